// Programs at the terminal: what they ask is answered, and none of them stops a step.

#include <chrono>
#include <filesystem>
#include <functional>
#include <thread>

#include "servo_bus/terminal_client.h"

namespace murosimf::servo_bus {
namespace {

namespace fs = std::filesystem;

double seconds(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

const Bytes kPingOne = bytes("FF FF FD 00 01 03 00 01 19 4E");

Bytes question(int id, Instruction instruction, const std::string& parameters) {
  Bytes out;
  appendInstruction(Protocol::k2, static_cast<std::uint8_t>(id), static_cast<std::uint8_t>(instruction),
                    bytes(parameters), out);
  return out;
}

TEST(ServoBusTerminal, AGoalThatIsWrittenReachesTheJointAndItsPositionIsRead) {
  SteppedBus robot(twoServos("goal"));
  robot.joints[0].position = 0.5;
  robot.step();
  TerminalClient client(robot.link());
  client.send(question(1, Instruction::kRead, "84 00 04 00"));
  const Bytes answer = client.receive();
  ASSERT_EQ(answer.size(), 15u);
  EXPECT_EQ(answer[9] + 256 * answer[10], 2048 + stepsOf(0.5));
  client.send(question(254, Instruction::kSyncWrite, "40 00 01 00 01 01 02 01"));
  client.send(question(254, Instruction::kSyncWrite, "74 00 04 00 01 00 0A 00 00 02 00 06 00 00"));
  client.send(kPingOne);
  EXPECT_EQ(client.receive().size(), 14u) << "sync writes are not answered";
  robot.step();
  EXPECT_NEAR(robot.commands.joints[0].position, angleOf(512), 1e-12);
  EXPECT_NEAR(robot.commands.joints[1].position, angleOf(-512), 1e-12);
  EXPECT_GT(robot.commands.joints[0].kp, 0);
}

TEST(ServoBusTerminal, NothingIsAnsweredBeforeTheFirstSensorFrame) {
  SteppedBus robot(twoServos("early"));
  TerminalClient client(robot.link());
  client.send(kPingOne);
  EXPECT_EQ(client.receive(100).size(), 0u);
  robot.step();
  EXPECT_EQ(client.receive().size(), 14u);
}

TEST(ServoBusTerminal, TheLinkGoesWithTheProgramAndReplacesOneThatWasLeft) {
  const ServoBusSettings settings = twoServos("link");
  fs::create_directories(fs::path(settings.link).parent_path());
  fs::create_symlink("/dev/pts/9999", settings.link);
  {
    SteppedBus robot(settings);
    EXPECT_EQ(fs::read_symlink(settings.link), robot.bus.terminal()->device());
  }
  EXPECT_FALSE(fs::exists(fs::symlink_status(settings.link)));
}

TEST(ServoBusTerminal, ANameThatSomethingElseHasIsRefused) {
  const ServoBusSettings settings = twoServos("folder");
  fs::create_directories(settings.link);
  try {
    SteppedBus robot(settings);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(std::string(error.what()), settings.link + ": this is no link to a terminal, expected a free name");
  }
  fs::remove(settings.link);
}

TEST(ServoBusTerminal, TeamAndNumberAreFilledIn) {
  ServoBusSettings settings = twoServos("{team}.{number}");
  SteppedBus robot(settings);
  EXPECT_TRUE(robot.link().ends_with("/red.3")) << robot.link();
}

TEST(ServoBusTerminal, ASlowProgramsQuestionIsAnsweredByteByByte) {
  SteppedBus robot(twoServos("slow"));
  robot.step();
  TerminalClient client(robot.link());
  for (const std::uint8_t byte : kPingOne) {
    client.send({byte});
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    EXPECT_LT(seconds([&] { robot.step(); }), 0.05);
  }
  EXPECT_EQ(client.receive().size(), 14u);
}

TEST(ServoBusTerminal, AQuestionThatIsNeverFinishedIsGivenUp) {
  SteppedBus robot(twoServos("unfinished"));
  robot.step();
  TerminalClient client(robot.link());
  client.send(bytes("FF FF FD 00 01 F0 00 03"));
  std::this_thread::sleep_for(std::chrono::milliseconds(150));
  client.send(kPingOne);
  EXPECT_EQ(client.receive().size(), 14u);
}

TEST(ServoBusTerminal, ASilentProgramStopsNoStep) {
  SteppedBus robot(twoServos("silent"));
  robot.step();
  TerminalClient client(robot.link());
  EXPECT_LT(seconds([&] {
              for (int i = 0; i < 1000; ++i) robot.step();
            }),
            1.0);
}

/// It asks without end and never reads: answers are lost, steps are not.
TEST(ServoBusTerminal, AFloodingProgramStopsNoStep) {
  SteppedBus robot(twoServos("flood"));
  robot.step();
  TerminalClient client(robot.link());
  Bytes many;
  for (int i = 0; i < 100; ++i) many.insert(many.end(), kPingOne.begin(), kPingOne.end());
  std::atomic<bool> done{false};
  std::size_t sent = 0;
  std::thread flood([&] {
    while (!done) sent += client.flood(many);
  });
  double longest = 0;
  const auto start = std::chrono::steady_clock::now();
  while (std::chrono::steady_clock::now() - start < std::chrono::milliseconds(500)) {
    longest = std::max(longest, seconds([&] { robot.step(); }));
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  done = true;
  flood.join();
  const ServoBusCounts counts = robot.bus.counts();
  RecordProperty("longest_step_us", static_cast<int>(1e6 * longest));
  EXPECT_LT(longest, 0.1) << sent << " bytes, " << counts.packets << " packets";
  EXPECT_GT(counts.packets, 1000u);
  EXPECT_GT(counts.lost_bytes, 0u);
}

TEST(ServoBusTerminal, ABaudRateAndAReturnDelayPaceTheAnswers) {
  ServoBusSettings settings = twoServos("baud");
  settings.baud_rate = 9600;
  SteppedBus robot(settings);
  robot.step();
  TerminalClient client(robot.link());
  const double time = seconds([&] {
    for (int i = 0; i < 5; ++i) {
      client.send(kPingOne);
      EXPECT_TRUE(client.hears(1000));
      client.take();
    }
  });
  EXPECT_GT(time, 5 * (24 * 10 / 9600.0 + 500e-6)) << "ten bits a byte, question and answer";
  EXPECT_LT(time, 5 * (24 * 10 / 9600.0 + 500e-6) + 0.2);
}

TEST(ServoBusTerminal, InLockStepAStepWaitsForGoals) {
  ServoBusSettings settings = twoServos("lock");
  settings.lock_step = true, settings.patience = 1, settings.torque_on = true;
  SteppedBus robot(settings);
  EXPECT_TRUE(robot.bus.waitsForOthers());
  std::atomic<bool> done{false};
  std::thread firmware([&] {
    TerminalClient client(robot.link());
    for (int goal = 2000; !done; ++goal) {
      const Bytes value = {static_cast<std::uint8_t>(goal), static_cast<std::uint8_t>(goal >> 8)};
      client.send(question(1, Instruction::kWrite, "74 00 " + text(value) + " 00 00"));
      EXPECT_EQ(client.receive(2000).size(), 11u);
    }
  });
  double last = -10;
  for (int i = 0; i < 10; ++i) {
    robot.step();
    EXPECT_GT(robot.commands.joints[0].position, last) << "each step has a goal of its own";
    last = robot.commands.joints[0].position;
  }
  EXPECT_EQ(robot.bus.counts().missed_steps, 0u);
  done = true;
  firmware.join();
}

TEST(ServoBusTerminal, LockStepGivesUpWithinItsBudget) {
  ServoBusSettings settings = twoServos("budget");
  settings.lock_step = true;
  SteppedBus robot(settings);
  EXPECT_NEAR(seconds([&] { robot.step(); }), 0.1, 0.05);
  const double rest = seconds([&] {
    for (int i = 0; i < 100; ++i) robot.step();
  });
  EXPECT_LT(rest, 1.2) << "a second in 25, whatever the number of steps";
  EXPECT_EQ(robot.bus.counts().missed_steps, 101u);
}

TEST(ServoBusTerminal, ACheckpointBringsBackRegistersAndGoals) {
  SteppedBus robot(twoServos("saved"));
  robot.step();
  TerminalClient client(robot.link());
  client.send(question(254, Instruction::kWrite, "40 00 01"));
  client.send(question(1, Instruction::kWrite, "74 00 00 0A 00 00"));
  EXPECT_EQ(client.receive().size(), 11u);
  robot.step();
  StateArchive saved;
  robot.bus.archive(saved);
  SteppedBus other(twoServos("loaded"));
  StateArchive loading(saved.bytes());
  other.bus.archive(loading);
  EXPECT_TRUE(loading.exhausted());
  other.t = robot.t;
  robot.step(), other.step();
  EXPECT_EQ(other.commands.joints[0].position, robot.commands.joints[0].position);
  EXPECT_EQ(other.commands.joints[0].position, angleOf(512));
}

struct WrongSettings {
  const char* sentence;
  std::function<void(ServoBusSettings&)> change;
  const char* complaint;
};

TEST(ServoBusTerminal, SettingsThatCannotBeAreRefusedInWords) {
  const WrongSettings kCases[] = {
      {"an id beyond the range", [](auto& s) { s.servos[0].id = 253; },
       "servo_bus: servo of joint \"pan\" has id 253, expected 0 to 252"},
      {"an id given twice", [](auto& s) { s.servos[1].id = 1; },
       "servo_bus: servo of joint \"tilt\" has id 1, which another device has already"},
      {"a joint with two servos", [](auto& s) { s.servos[1].joint = "pan"; },
       "servo_bus: joint \"pan\" has two servos, expected one"},
      {"no direction", [](auto& s) { s.servos[0].direction = 0; },
       "servo_bus: servo of joint \"pan\" has direction 0, expected 1 or -1"},
      {"too much patience", [](auto& s) { s.patience = 5; }, "servo_bus: patience [s] is 5, expected 0 to 1"},
      {"no link", [](auto& s) { s.link = ""; },
       "servo_bus: link is missing, expected the path of a link to the terminal: \"/tmp/murosimf/red.1\""},
      {"a joint that the robot lacks", [](auto& s) { s.servos[0].joint = "pam"; },
       "servo_bus: robot \"box\" has no joint \"pam\", expected one of pan, tilt"},
      {"an IMU board in version 1.0",
       [](auto& s) {
         s.protocol = Protocol::k1, s.imus = {{200, ""}};
       },
       "model \"IMU\" speaks protocol 2 alone"},
  };
  for (const WrongSettings& wrong : kCases) {
    ServoBusSettings settings = twoServos("wrong");
    wrong.change(settings);
    try {
      SteppedBus robot(settings);
      ADD_FAILURE() << wrong.sentence;
    } catch (const std::exception& error) {
      EXPECT_STREQ(error.what(), wrong.complaint) << wrong.sentence;
    }
  }
}

TEST(ServoBusTerminal, WhatTheRobotLacksIsToldBeforeTheSimulationBegins) {
  ServoBusSettings settings = twoServos("lacks");
  settings.servos[0].joint = "pam";
  EXPECT_THROW(SteppedBus robot(settings), client::CannotStart);
  settings = twoServos("lacks");
  settings.link = "/proc/no/such/folder/link";
  EXPECT_THROW(SteppedBus robot(settings), client::CannotStart);
}

}  // namespace
}  // namespace murosimf::servo_bus
