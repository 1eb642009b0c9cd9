// Lock-step, our extension of the player API: the game waits for each client's answer, and guards itself against those
// that do not come.

#include <chrono>
#include <thread>

#include "murosimf/control/wire/delay_budget.h"
#include "player_api/api_robot.h"

namespace murosimf::testing {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

player_api::PlayerPortSettings lockStep() {
  player_api::PlayerPortSettings settings;
  settings.lock_step = true;
  settings.connect_wait = 0;
  settings.delay = {0.05, 0.2, 25};
  return settings;
}

TEST(DelayBudget, PatienceIsFreeAndTheRestIsChargedWithinTheWindow) {
  DelayBudget budget({0.1, 1.0, 25});
  EXPECT_DOUBLE_EQ(budget.allowance(0), 1.1);
  budget.answered(0.1, 0.1);
  EXPECT_DOUBLE_EQ(budget.allowance(1), 1.1);
  budget.answered(2, 0.7);
  EXPECT_DOUBLE_EQ(budget.allowance(3), 0.5);
  budget.answered(4, 0.5);
  EXPECT_DOUBLE_EQ(budget.allowance(5), 0.1);
  EXPECT_DOUBLE_EQ(budget.allowance(28), 0.7) << "what was charged at 2 s is forgotten, not yet that of 4 s";
  EXPECT_DOUBLE_EQ(budget.allowance(30), 1.1);
}

TEST(DelayBudget, WhoMissesIsNotWaitedForUntilHeAnswers) {
  DelayBudget budget({0.1, 1.0, 25});
  budget.missed(1, 1.1);
  EXPECT_EQ(budget.allowance(2), 0);
  budget.answered(3, 0);
  EXPECT_DOUBLE_EQ(budget.allowance(4), 0.1);
  EXPECT_EQ(budget.misses(), 1);
}

TEST(LockStep, AStepEndsWithTheAnswerAndItsCommandsActAtOnce) {
  ApiRobot robot(lockStep());
  robot.start();
  PlainClient client = robot.connect();
  std::thread answers([&] {
    for (int k = 0; k < 20; ++k) {
      const PlainReader measured = client.receive();
      client.send(position("Neck", 1e-3 * static_cast<double>(measured.last(sent::kTime).value)));
    }
  });
  for (int k = 1; k <= 20; ++k) {
    robot.step();
    EXPECT_EQ(robot.commands.joints[0].position, 1e-3 * (8 * k));
  }
  answers.join();
  EXPECT_EQ(robot.port.counts().missed_answers, 0);
}

TEST(LockStep, OneMessageOfRequestsIsTakenAStep) {
  ApiRobot robot(lockStep());
  robot.start();
  PlainClient client = robot.connect();
  for (const double angle : {0.1, 0.2, 0.3}) robot.deliver(client, position("Neck", angle));
  for (const double angle : {0.1, 0.2, 0.3}) {
    robot.step();
    EXPECT_EQ(robot.commands.joints[0].position, angle);
  }
}

TEST(LockStep, ClientThatSaysWhatItAnswersMaySendMoreThanOnce) {
  ApiRobot robot(lockStep());
  robot.start();
  PlainClient client = robot.connect();
  robot.deliver(client, std::move(position("Neck", 0.1).number(asked::kAnswers, 0)));
  robot.deliver(client, std::move(position("Neck", 0.2).number(asked::kAnswers, 8)));
  robot.step();
  EXPECT_EQ(robot.commands.joints[0].position, 0.2);
}

TEST(LockStep, FirstRequestsCountAsBeforeTheFirstStep) {
  player_api::PlayerPortSettings settings = lockStep();
  settings.connect_wait = 10;
  settings.port = 0;
  const auto server = std::make_shared<FrameServer>();
  player_api::PlayerPort port(server, settings);
  std::optional<PlainClient> client;
  std::thread player([&] {
    while (port.port() == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    client.emplace(port.port());
    client->greeting();
    client->send(std::move(timeStep("Camera", 32).message(asked::kTimeSteps, named("NeckS").number(2, 8))));
  });
  port.start(describedRobot());
  std::vector<double> periods{-1};
  port.startCameras(periods);
  player.join();
  EXPECT_EQ(periods[0], 0.032);
  client::SensorFrame frame;
  const std::vector<client::JointReading> joints{{0.1, 0, 0}, {0.2, 0, 0}};
  frame.time = 0.008, frame.joints = joints;
  client::CommandFrame commands;
  client->send(PlainMessage{});
  port.step(frame, commands);
  EXPECT_TRUE(measurement(client->receive(), sent::kPositionSensors, "NeckS"));
}

TEST(LockStep, ClientThatNeverAnswersCostsItsBudgetOnce) {
  ApiRobot robot(lockStep());
  robot.start();
  PlainClient client = robot.connect();
  const Clock::time_point start = Clock::now();
  robot.step();
  const double first = secondsSince(start);
  EXPECT_GE(first, 0.2);
  for (int k = 0; k < 200; ++k) robot.step();
  EXPECT_LT(secondsSince(start) - first, 0.2) << "no further step waits";
  EXPECT_EQ(robot.port.counts().missed_answers, 1);
  EXPECT_EQ(robot.commands.joints[0].position, 0.1) << "motors keep what they have";
}

TEST(LockStep, ClientThatComesBackIsWaitedForAgain) {
  ApiRobot robot(lockStep());
  robot.start();
  PlainClient client = robot.connect();
  robot.step();  // missed
  robot.deliver(client, position("Neck", 0.4));
  robot.step();  // the late answer
  EXPECT_EQ(robot.commands.joints[0].position, 0.4);
  std::thread late([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    client.send(position("Neck", 0.5));
  });
  robot.step();
  EXPECT_EQ(robot.commands.joints[0].position, 0.5);
  late.join();
}

TEST(LockStep, ClientThatGoesIsNotWaitedFor) {
  ApiRobot robot(lockStep());
  robot.start();
  auto client = std::make_unique<PlainClient>(robot.connect());
  client.reset();
  const Clock::time_point start = Clock::now();
  for (int k = 0; k < 100; ++k) robot.step();
  EXPECT_LT(secondsSince(start), 0.25);
}

}  // namespace
}  // namespace murosimf::testing
