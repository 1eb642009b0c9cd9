// Agents of RCSSServerMJ, with a client that knows bytes alone.

#include "murosimf/control/agent_server/agent_port.h"

#include <gtest/gtest.h>

#include <array>
#include <thread>

#include "murosimf/control/wire/frame_client.h"
#include "murosimf/control/wire/s_expression.h"

namespace murosimf::testing {
namespace {

using agent_server::AgentDesk;
using agent_server::AgentPort;
using agent_server::AgentPortSettings;
using agent_server::Side;

/// Four bytes of length, the highest first, then text.
class PlainAgent {
 public:
  explicit PlainAgent(int port) : client_("127.0.0.1", port, 5) {}
  void send(const std::string& text) {
    const auto size = static_cast<std::uint32_t>(text.size());
    std::vector<std::uint8_t> bytes;
    for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<std::uint8_t>(size >> shift));
    bytes.insert(bytes.end(), text.begin(), text.end());
    client_.sendRaw(bytes.data(), bytes.size());
  }
  /// The next message; "closed" where there is none.
  std::string receive() {
    std::array<std::uint8_t, 4> head{};
    if (!client_.readRaw(head.data(), 4)) return "closed";
    const std::size_t size = static_cast<std::size_t>(head[2]) * 256 + head[3];
    std::vector<std::uint8_t> bytes(size);
    if (head[0] != 0 || head[1] != 0 || !client_.readRaw(bytes.data(), size)) return "closed";
    return {bytes.begin(), bytes.end()};
  }

 private:
  FrameClient client_;
};

client::RobotDescription described(const std::string& team, int number) {
  client::RobotDescription r;
  r.model = "t1", r.team = team, r.number = number;
  r.joints = {{"he1", -2, 2, 10, 7}, {"lae1", -3, 3, 10, 18}, {"rle6", -1, 1, 10, 15}};
  r.attacks_positive_x = team == "red";
  r.control_period = 0.02;
  return r;
}

/// A robot whose simulation is the test.
struct AgentRobot {
  AgentPort port;
  client::RobotDescription robot;
  std::vector<client::JointReading> joints{{0.1, 0.2, 0}, {-0.3, 0, 0}, {0, 0, 0}};
  client::SensorFrame sensors;
  client::CommandFrame commands;

  AgentRobot(const std::shared_ptr<AgentDesk>& desk, const AgentPortSettings& settings,
             const client::RobotDescription& description)
      : port(desk, settings), robot(description) {
    port.start(robot);
    commands.joints.resize(robot.joints.size());
    sensors.joints = joints;
    sensors.game.phase = client::GamePhase::kSet;
  }
  void step() {
    sensors.time += robot.control_period;
    port.step(sensors, commands);
  }
  double figure(const std::string& name) const {
    for (const auto& [known, value] : port.figures())
      if (known == name) return value;
    return -1;
  }
};

AgentPortSettings anyPort() {
  AgentPortSettings settings;
  settings.port = 0;
  settings.delay = {2, 2, 25};
  return settings;
}

/// Red 1 and blue 1, in lock-step unless told.
struct Pitch {
  std::shared_ptr<AgentDesk> desk = std::make_shared<AgentDesk>(std::make_shared<FrameServer>());
  AgentRobot left, right;
  explicit Pitch(const AgentPortSettings& settings = anyPort())
      : left(desk, settings, described("red", 1)), right(desk, settings, described("blue", 1)) {}
  PlainAgent connect(const std::string& init) {
    PlainAgent agent(desk->port());
    agent.send(init);
    return agent;
  }
  /// Lets agents be seated until somebody sits at this place.
  void waitFor(int place) {
    for (int i = 0; i < 2000 && desk->channelOf(place) == nullptr; ++i) {
      desk->attend();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
  /// Lets agents be seated until somebody sits at one of the places, or has been sent away.
  void attend() {
    const long before = desk->refused();
    for (int i = 0; i < 2000 && desk->refused() == before; ++i) {
      desk->attend();
      if (desk->channelOf(0) != nullptr || desk->channelOf(1) != nullptr) return;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
};

/// A list of a message; fails the test where it is not there.
SExpression listOf(const std::string& message, const std::string& name) {
  std::string problem;
  const auto all = readSExpressions(message, problem);
  EXPECT_TRUE(all) << problem;
  for (const SExpression& e : all ? *all : std::vector<SExpression>{})
    if (e.name() == name) return e;
  ADD_FAILURE() << "no " << name << " in " << message;
  return {};
}

double under(const SExpression& e, const std::string& name, std::size_t place = 1) {
  const SExpression* list = e.find(name);
  return list == nullptr ? -1e9 : list->number(place).value_or(-1e9);
}

/// In lock-step: answers the next perception. @returns it
std::string cycle(AgentRobot& robot, PlainAgent& agent, const std::string& actions) {
  agent.send(actions);
  robot.step();
  return agent.receive();
}

AgentPortSettings lockStep() {
  AgentPortSettings settings = anyPort();
  settings.lock_step = true, settings.connect_wait = 0;
  return settings;
}

TEST(AgentDesk, FirstMessageNamesModelTeamAndNumber) {
  std::string problem;
  const auto request = agent_server::readAgentRequest("(init T1 Ours 7)", problem);
  ASSERT_TRUE(request) << problem;
  EXPECT_EQ(request->model, "T1");
  EXPECT_EQ(request->team, "Ours");
  EXPECT_EQ(request->number, 7);
  for (const char* wrong : {"", "(", "(init T1 Ours)", "(init T1 Ours x)", "(init T1 Ours 1.5)", "(init T1 Ours -1)",
                            "(init (T1) Ours 1)", "(init T1 Ours 1e308)", "(scene rsg/agent/nao/nao.rsg)"}) {
    EXPECT_FALSE(agent_server::readAgentRequest(wrong, problem)) << wrong;
    EXPECT_FALSE(problem.empty()) << wrong;
  }
  EXPECT_FALSE(agent_server::readAgentRequest("(init T1 " + std::string(65, 'a') + " 1)", problem));
}

TEST(AgentDesk, FirstTeamPlaysOnTheLeftAndTheNextOneOnTheRight) {
  Pitch pitch;
  PlainAgent first = pitch.connect("(init T1 Swifts 1)");
  pitch.attend();
  EXPECT_NE(pitch.desk->channelOf(0), nullptr);
  PlainAgent second = pitch.connect("(init t1 Robins 1)");
  pitch.waitFor(1);
  EXPECT_NE(pitch.desk->channelOf(1), nullptr);
  EXPECT_EQ(pitch.desk->teamOf(Side::kLeft), "Swifts");
  EXPECT_EQ(pitch.desk->teamOf(Side::kRight), "Robins");
}

TEST(AgentDesk, ScenarioMayNameTheTeamOfASide) {
  AgentPortSettings settings = anyPort();
  const auto desk = std::make_shared<AgentDesk>(std::make_shared<FrameServer>());
  settings.team = "Swifts";
  const AgentRobot left(desk, settings, described("red", 1));
  settings.team = "Robins";
  const AgentRobot right(desk, settings, described("blue", 1));
  PlainAgent agent(desk->port());
  agent.send("(init T1 Robins 1)");
  for (int i = 0; i < 2000 && desk->channelOf(1) == nullptr; ++i) {
    desk->attend();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_NE(desk->channelOf(1), nullptr);
  EXPECT_EQ(desk->channelOf(0), nullptr);
}

TEST(AgentDesk, NumberZeroGetsTheFirstFreeRobot) {
  Pitch pitch;
  PlainAgent agent = pitch.connect("(init T1 Swifts 0)");
  pitch.attend();
  EXPECT_NE(pitch.desk->channelOf(0), nullptr);
}

TEST(AgentDesk, TellsWhyAnAgentIsSentAwayAndClosesItsConnection) {
  Pitch pitch;
  PlainAgent sits = pitch.connect("(init T1 Swifts 1)");
  pitch.attend();
  const auto answer = [&](const std::string& init) {
    PlainAgent agent = pitch.connect(init);
    const long before = pitch.desk->refused();
    for (int i = 0; i < 2000 && pitch.desk->refused() == before; ++i) {
      pitch.desk->attend();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    const std::string text = agent.receive();
    EXPECT_EQ(agent.receive(), "closed");
    return text;
  };
  EXPECT_EQ(answer("(init T1 Swifts 1)"), "(error \"robot 1 on the left has its agent\")");
  EXPECT_EQ(answer("(init T1 Swifts 2)"), "(error \"no robot with number 2 on the left\")");
  EXPECT_EQ(answer("(init K1 Robins 1)"), "(error \"robot 1 on the right is a t1, not a K1\")");
  EXPECT_EQ(answer("(scene x)"), "(error \"expected (init MODEL TEAM NUMBER), as in (init T1 Ours 1)\")");
}

TEST(AgentDesk, RobotIsFreeAgainWhenItsAgentHasGone) {
  Pitch pitch;
  {
    PlainAgent agent = pitch.connect("(init T1 Swifts 1)");
    pitch.attend();
    ASSERT_NE(pitch.desk->channelOf(0), nullptr);
  }
  for (int i = 0; i < 2000 && pitch.desk->channelOf(0) != nullptr; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  PlainAgent again = pitch.connect("(init T1 Swifts 1)");
  pitch.attend();
  EXPECT_NE(pitch.desk->channelOf(0), nullptr);
}

TEST(AgentDesk, SilentAgentsMakeRoomForThoseThatSpeak) {
  Pitch pitch;
  std::vector<std::unique_ptr<PlainAgent>> silent;
  for (int i = 0; i < 80; ++i) silent.push_back(std::make_unique<PlainAgent>(pitch.desk->port()));
  PlainAgent agent = pitch.connect("(init T1 Swifts 1)");
  pitch.attend();
  EXPECT_NE(pitch.desk->channelOf(0), nullptr);
}

TEST(AgentDesk, RefusesTwoRobotsOfOneNumberAndTwoPorts) {
  Pitch pitch;
  AgentPort twice(pitch.desk, anyPort());
  EXPECT_THROW(twice.start(described("red", 1)), client::CannotStart);
  AgentPortSettings elsewhere = anyPort();
  elsewhere.port = 1;
  AgentPort other(pitch.desk, elsewhere);
  EXPECT_THROW(other.start(described("red", 2)), client::CannotStart);
}

TEST(Perceptions, ComeInTheOrderOfTheServer) {
  Pitch pitch(lockStep());
  PlainAgent agent = pitch.connect("(init T1 Swifts 1)");
  pitch.attend();
  pitch.left.sensors.own_pose = {1, true, 0, {1, 2, 0}, {{}, {1, 2, 0.5}}};
  const std::string text = cycle(pitch.left, agent, "(syn)");
  EXPECT_EQ(text,
            "(time (now 0.02))(GS (t 0.00)(pm BeforeKickOff)(tl Swifts)(sl 0)(sr 0))"
            "(quat (n torso_quat)(q 1.000 0.000 0.000 0.000))(pos (n torso_pos)(p 1.000 2.000 0.500))"
            "(GYR (n torso_gyro)(rt 0.00 0.00 0.00))(ACC (n torso_acc)(a 0.00 0.00 0.00))"
            "(HJ (n q_hj1)(ax 5.72)(vx 11.45))(HJ (n q_laj1)(ax -17.18)(vx 0.00))(HJ (n q_rlj6)(ax 0.00)(vx 0.00))");
}

TEST(Perceptions, NumbersAreCutNotRoundedAndAnglesAreDegrees) {
  Pitch pitch(lockStep());
  PlainAgent agent = pitch.connect("(init T1 Swifts 1)");
  pitch.attend();
  pitch.left.sensors.angular_velocity = {kPi, -kPi / 2, 0.99999 * kPi / 180};
  pitch.left.sensors.specific_force = {-0.009, 1.999, 9.819};
  const std::string text = cycle(pitch.left, agent, "(syn)");
  EXPECT_NE(text.find("(rt 180.00 -90.00 0.99)"), std::string::npos) << text;
  EXPECT_NE(text.find("(a 0.00 1.99 9.81)"), std::string::npos) << text;
}

TEST(Perceptions, RightTeamHearsItsPoseInTheFrameOfTheFieldNotInItsOwn) {
  Pitch pitch(lockStep());
  PlainAgent agent = pitch.connect("(init T1 Swifts 1)");
  pitch.attend();
  PlainAgent blue = pitch.connect("(init T1 Robins 1)");
  pitch.waitFor(1);
  pitch.right.sensors.own_pose = {1, true, 0, {-3, 1, 0}, {{}, {-3, 1, 0.5}}};
  const std::string text = cycle(pitch.right, blue, "(syn)");
  EXPECT_NE(text.find("(q 0.000 0.000 0.000 1.000)"), std::string::npos) << text;
  EXPECT_NE(text.find("(p 3.000 -1.000 0.500)"), std::string::npos) << text;
}

TEST(Perceptions, QuaternionsTurnAsTheirMatrixDoes) {
  Pitch pitch(lockStep());
  PlainAgent agent = pitch.connect("(init T1 Swifts 1)");
  pitch.attend();
  for (const Vector3& w : {Vector3{3, 0.1, 0}, Vector3{0.1, 3, -0.2}, Vector3{0.2, 0.3, 3.05}, Vector3{-1, 0.4, 0.6}}) {
    pitch.left.sensors.own_pose = {1, true, 0, {}, {rotationExp(w), {}}};
    const SExpression quat = listOf(cycle(pitch.left, agent, "(syn)"), "quat");
    const double angle = norm(w), s = std::sin(angle / 2) / angle;
    EXPECT_NEAR(under(quat, "q", 1), std::cos(angle / 2), 1e-3);
    EXPECT_NEAR(under(quat, "q", 2), s * w.x, 1e-3);
    EXPECT_NEAR(under(quat, "q", 3), s * w.y, 1e-3);
    EXPECT_NEAR(under(quat, "q", 4), s * w.z, 1e-3);
  }
}

TEST(Perceptions, TellDistanceAndAnglesOfWhatACameraHasSeen) {
  const agent_server::PolarPoint p = agent_server::polarOf({-1, -std::sqrt(2.0), 1});
  EXPECT_NEAR(p.distance, 2, 1e-12);
  EXPECT_NEAR(p.azimuth, 45, 1e-12);
  EXPECT_NEAR(p.elevation, 45, 1e-12);
  Pitch pitch(lockStep());
  PlainAgent agent = pitch.connect("(init T1 Swifts 1)");
  pitch.attend();
  const std::array<client::SeenThing, 1> ball{{{{0, 0, 2}, {0, 0, 2}, "", 0}}};
  const std::array<client::SeenThing, 1> mate{{{{-1, 0, 1}, {}, "blue", 4}}};
  const std::array<client::CameraSights, 2> sights{
      {{0, client::ThingKind::kBall, 0, ball}, {0, client::ThingKind::kRobot, 0, mate}}};
  pitch.left.sensors.sights = sights;
  const std::string text = cycle(pitch.left, agent, "(syn)");
  EXPECT_NE(text.find("(See (B (pol 2.00 0.00 0.00)) (P (team 1)(id 4)(base (pol 1.41 45.00 0.00))))"),
            std::string::npos)
      << text;
}

TEST(Perceptions, TellHowTheGameStands) {
  Pitch pitch(lockStep());
  PlainAgent agent = pitch.connect("(init T1 Swifts 1)");
  pitch.attend();
  const auto mode = [&] { return std::string(listOf(cycle(pitch.left, agent, "(syn)"), "GS").find("pm")->text(1)); };
  client::GameInfo& game = pitch.left.sensors.game;
  EXPECT_EQ(mode(), "BeforeKickOff");
  game.phase = client::GamePhase::kPlaying;
  EXPECT_EQ(mode(), "PlayOn");
  game.phase = client::GamePhase::kReady, game.own_score = 1, game.own_kickoff = false;
  EXPECT_EQ(mode(), "Goal_Left");
  game.opponent_score = 1, game.own_kickoff = true;
  EXPECT_EQ(mode(), "Goal_Right");
  game.phase = client::GamePhase::kFinished;
  const SExpression standing = listOf(cycle(pitch.left, agent, "(syn)"), "GS");
  EXPECT_EQ(standing.find("pm")->text(1), "GameOver");
  EXPECT_EQ(under(standing, "sl"), 1);
  EXPECT_EQ(under(standing, "sr"), 1);
  EXPECT_EQ(under(standing, "t"), 0.02) << "the game's clock ran for one cycle";
}

TEST(Actions, AreSixWordsInDegreesAndHoldUntilTheNext) {
  Pitch pitch(lockStep());
  PlainAgent agent = pitch.connect("(init T1 Swifts 1)");
  pitch.attend();
  cycle(pitch.left, agent, "(lae1 90 -180 20 0.5 1.25)(syn)");
  const auto check = [&] {
    const client::JointCommand& command = pitch.left.commands.joints[1];
    EXPECT_DOUBLE_EQ(command.position, kPi / 2);
    EXPECT_DOUBLE_EQ(command.velocity, -kPi);
    EXPECT_EQ(command.kp, 20);
    EXPECT_EQ(command.kd, 0.5);
    EXPECT_EQ(command.torque, 1.25);
  };
  check();
  cycle(pitch.left, agent, "(syn)");
  check();
}

TEST(Actions, ThatAreNotUnderstoodAreCountedAndLeftAlone) {
  Pitch pitch(lockStep());
  PlainAgent agent = pitch.connect("(init T1 Swifts 1)");
  pitch.attend();
  pitch.left.step();  // without an answer: the posture is held
  agent.receive();
  const std::vector<client::JointCommand> before = pitch.left.commands.joints;
  EXPECT_EQ(before[0].position, 0.1);
  for (const char* wrong : {"(nose 1 0 1 1 0)", "(he1 1 0 1 1)", "(he1 1 0 1 1 0 0)", "(he1 nan 0 1 1 0)",
                            "(he1 1e999 0 1 1 0)", "(he1 1 0 -1 1 0)", "(he1 1 0 1 1 x)", "(he1", ")", "\xff\x01"}) {
    cycle(pitch.left, agent, wrong);
    EXPECT_EQ(pitch.left.commands.joints[0].position, before[0].position) << wrong;
    EXPECT_EQ(pitch.left.commands.joints[0].kp, before[0].kp) << wrong;
  }
  EXPECT_EQ(pitch.left.figure("not_understood"), 10);
}

TEST(Actions, BeamIsMirroredToTheOwnHalfOfEachSide) {
  Pitch pitch(lockStep());
  PlainAgent agent = pitch.connect("(init T1 Swifts 1)");
  pitch.attend();
  cycle(pitch.left, agent, "(beam 2 1 90)");
  EXPECT_TRUE(pitch.left.commands.beams);
  EXPECT_EQ(pitch.left.commands.beam, (PlanarPose{-2, 1, kPi / 2}));
  cycle(pitch.left, agent, "(syn)");
  EXPECT_FALSE(pitch.left.commands.beams) << "once is enough";
  PlainAgent blue = pitch.connect("(init T1 Robins 1)");
  pitch.waitFor(1);
  cycle(pitch.right, blue, "(beam -2 1 0)");
  EXPECT_EQ(pitch.right.commands.beam, (PlanarPose{-2, -1, 0})) << "y is the field's: not mirrored";
}

TEST(LockStepOfAgents, TakesExactlyOneMessageACycle) {
  Pitch pitch(lockStep());
  PlainAgent agent = pitch.connect("(init T1 Swifts 1)");
  pitch.attend();
  for (const char* degrees : {"10", "20", "30"}) agent.send("(he1 " + std::string(degrees) + " 0 1 0 0)");
  for (const double degrees : {10.0, 20.0, 30.0}) {
    pitch.left.step();
    EXPECT_DOUBLE_EQ(pitch.left.commands.joints[0].position, degrees * kPi / 180);
  }
  EXPECT_EQ(pitch.left.figure("missed_answers"), 0);
}

TEST(LockStepOfAgents, AgentThatDoesNotAnswerIsWaitedForOnce) {
  AgentPortSettings settings = lockStep();
  settings.delay = {0.02, 0.05, 25};
  Pitch pitch(settings);
  PlainAgent agent = pitch.connect("(init T1 Swifts 1)");
  pitch.attend();
  for (int i = 0; i < 50; ++i) pitch.left.step();
  EXPECT_EQ(pitch.left.figure("missed_answers"), 1);
}

TEST(FreeRunningAgents, AllMessagesThatHaveComeAreMerged) {
  Pitch pitch;
  PlainAgent agent = pitch.connect("(init T1 Swifts 1)");
  pitch.attend();
  agent.send("(he1 10 0 1 0 0)");
  agent.send("(lae1 20 0 1 0 0)(he1 30 0 1 0 0)");
  for (int i = 0; i < 2000 && pitch.left.figure("messages_received") < 2; ++i) {
    pitch.left.step();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_DOUBLE_EQ(pitch.left.commands.joints[0].position, 30 * kPi / 180);
  EXPECT_DOUBLE_EQ(pitch.left.commands.joints[1].position, 20 * kPi / 180);
}

}  // namespace
}  // namespace murosimf::testing
