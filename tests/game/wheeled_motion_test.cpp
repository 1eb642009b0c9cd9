// Robots on wheels: rolling, slipping and being pushed, against closed forms.

#include "game/wheeled_robot.h"

#include <filesystem>
#include <fstream>
#include <iterator>

#include "murosimf/algorithms/gravity.h"
#include "murosimf/simulation/checkpoint.h"

namespace murosimf::test {
namespace {

constexpr double kRadius = 0.05, kTrack = 0.216;        // of duo
constexpr double kOmniRadius = 0.04, kOmniArm = 0.115;  // of trio
constexpr int kTyreLeft = 1, kTyreRight = 2;            // wheels of duo, behind its castor
const std::string kAtOnce = "actuation = {largest_acceleration = 0}\n";
/// Tyres that hardly creep, and a castor that slides without friction.
const std::string kIdeal =
    "[robots.red.1.properties]\n\"castor.wheel_friction\" = 0\n\"tyre_left.wheel_creepage\" = 0\n"
    "\"tyre_right.wheel_creepage\" = 0\n\"tyre_left.wheel_stick_speed\" = 1e-5\n"
    "\"tyre_right.wheel_stick_speed\" = 1e-5\n";

TEST(WheeledKinematics, ALevelOfThisNameMovesRobotsOnWheelsByThem) {
  const WheeledRobot duo(wheeled("duo"));
  EXPECT_TRUE(duo.simulation->linked().handle(duo.robot, kWheelLoad, subset::kWheels).valid());
  EXPECT_FALSE(duo.simulation->linked().handle(duo.robot, kStanceSide).valid());
}

TEST(WheeledKinematics, LoadsCarryTheWeightWhereItIs) {
  const WheeledRobot duo(wheeled("duo"));
  const double weight = duo.mass() * kGravity;
  EXPECT_NEAR(duo.load(0) + duo.load(1) + duo.load(2), weight, 1e-9);
  // About the axle: the castor stands .1 m behind it.
  double moment = 0;
  const auto bodies = duo.simulation->world().members(duo.robot, subset::kBodies);
  for (const ObjectId body : bodies) moment += duo.simulation->world().find(body, kBodyInertia)->mc.x;
  EXPECT_NEAR(duo.load(0), -moment * kGravity / 0.1, 1e-6);  // wheels are on the axle
  EXPECT_NEAR(duo.load(kTyreLeft), duo.load(kTyreRight), 1e-9);
}

TEST(WheeledKinematics, RollingWheelsDriveByTheirAngleTimesRadius) {
  WheeledRobot duo(wheeled("duo", kIdeal));
  duo.turn({6, 6});
  duo.run(1);
  const double begin = duo.base().translation.x;
  duo.run(1);
  EXPECT_NEAR(duo.base().translation.x - begin, 6 * kRadius, 1e-6);
  EXPECT_NEAR(duo.base().translation.y, 0, 1e-9);
}

TEST(WheeledKinematics, UnequalRatesDriveACircle) {
  WheeledRobot duo(wheeled("duo", kIdeal));
  duo.turn({5, 7});
  duo.run(1);
  const double turn_rate = kRadius * 2 / kTrack, speed = kRadius * 6, radius = speed / turn_rate;
  const Pose begin = duo.base();
  const double first = duo.heading(), t = 2;
  duo.run(t);
  const double last = first + turn_rate * t;
  EXPECT_NEAR(wrappedAngle(duo.heading() - last), 0, 1e-5);
  EXPECT_NEAR(duo.base().translation.x - begin.translation.x, radius * (std::sin(last) - std::sin(first)), 1e-4);
  EXPECT_NEAR(duo.base().translation.y - begin.translation.y, radius * (std::cos(first) - std::cos(last)), 1e-4);
}

TEST(WheeledKinematics, OmniWheelsDriveSidewaysAndTurnAtOnce) {
  WheeledRobot trio(wheeled("trio"));
  // Each wheel's own equation, g . (v + w x p) = r rate, for v = (0.1, 0.2) m/s and w = 0.6 rad/s.
  const double vx = 0.1, vy = 0.2, w = 0.6;
  std::vector<double> rates;
  for (const double degrees : {60.0, 180.0, 300.0}) {
    const double a = degrees * kPi / 180;
    rates.push_back((std::sin(a) * vx - std::cos(a) * vy - kOmniArm * w) / kOmniRadius);
  }
  trio.turn(rates);
  trio.run(1);
  EXPECT_NEAR(trio.velocity().v.x, vx, 2e-3);
  EXPECT_NEAR(trio.velocity().v.y, vy, 2e-3);
  EXPECT_NEAR(trio.velocity().w.z, w, 5e-3);
}

TEST(WheeledKinematics, TyresPullWithTheirFrictionAndNoMore) {
  WheeledRobot duo(wheeled("duo", kAtOnce + kIdeal));
  duo.run(0.1);
  duo.turn({26, 26});  // 1.3 m/s at once
  duo.run(0.05);
  const double begin = duo.velocity().v.x;
  duo.run(0.1);
  const double a = 0.75 * (duo.load(kTyreLeft) + duo.load(kTyreRight)) / duo.mass();
  EXPECT_GT(begin, 0.1);
  EXPECT_NEAR((duo.velocity().v.x - begin) / 0.1, a, 1e-3 * a);
}

TEST(WheeledKinematics, LockedWheelsSlideTheWayOfDryFriction) {
  WheeledRobot duo(wheeled("duo", kAtOnce + kIdeal));
  duo.turn({20, 20});
  duo.run(2);
  const double v = duo.velocity().v.x, begin = duo.base().translation.x;
  EXPECT_NEAR(v, 1, 1e-3);
  duo.turn({0, 0});
  const double delay = 0.02;  // the command's, in which it goes on
  duo.run(2);
  const double a = 0.75 * (duo.load(kTyreLeft) + duo.load(kTyreRight)) / duo.mass();
  EXPECT_NEAR(duo.base().translation.x - begin, v * v / (2 * a), 1.5 * v * delay);
  EXPECT_GT(duo.base().translation.x - begin, v * v / (2 * a));
  EXPECT_NEAR(duo.velocity().v.x, 0, 1e-6);
}

/// How far 2 N to the left, on the base above the axle, take a robot from where it would be, in two seconds.
double takenAside(const std::string& file, const std::string& more, const std::vector<double>& rates, double newtons) {
  WheeledRobot robot(wheeled(file, more));
  robot.turn(rates);
  robot.run(1);
  for (int i = 0; i < 2000; ++i) {
    const Vector3 p = robot.base().translation;
    robot.simulation->interventions().push(robot.simulation->frame(), robot.robot, 0, {p.x, p.y, 0.06},
                                           {0, newtons, 0});
    robot.simulation->step();
  }
  return robot.base().translation.y;
}

TEST(WheeledKinematics, APushTakesARollingRobotOffItsCommandedPathByTheCreepOfItsTyres) {
  const WheeledRobot weighed(wheeled("duo"));
  const double load = weighed.load(kTyreLeft) + weighed.load(kTyreRight), castor = weighed.load(0);
  EXPECT_NEAR(takenAside("duo", "", {6, 6}, 0), 0, 1e-6);
  // F = c u, c of both tyres with s_0 = stick speed + creepage r w; the castor slides and gives way.
  const double free_slip = 0.002 + 0.03 * 6 * kRadius, creep = 2 * free_slip / (0.75 * load);
  const double aside = takenAside("duo", "properties = {\"castor.wheel_friction\" = 0}\n", {6, 6}, 2);
  EXPECT_GT(aside, 1e-3);
  EXPECT_NEAR(aside, 2 * creep, 0.05 * 2 * creep);
  // A castor that is dragged along has used up its friction: it holds no more than a share of its own.
  EXPECT_NEAR(takenAside("duo", "", {6, 6}, 2), aside, 0.06 * castor / 2 * aside);
}

TEST(WheeledKinematics, APushBeyondFrictionAccelerates) {
  // 2 N on tyres of mu = 0.02: F - mu N is left.
  const std::string ice =
      "[robots.red.1.properties]\n\"castor.wheel_friction\" = 0\n\"tyre_left.wheel_friction\" = 0.02\n"
      "\"tyre_right.wheel_friction\" = 0.02\n";
  const WheeledRobot weighed(wheeled("duo"));
  const double load = weighed.load(kTyreLeft) + weighed.load(kTyreRight), mass = weighed.mass();
  const double a = (2 - 0.02 * load) / mass;
  EXPECT_GT(takenAside("duo", ice, {0, 0}, 2), 0.5 * 0.5 * a * 4);  // it turns as well: the push is not at its centre
}

class AnyLevel : public testing::TestWithParam<const char*> {};

TEST_P(AnyLevel, CommandedAndTruePathUnderTwoNewtonsDiffer) {
  for (const auto& [file, rates] :
       {std::pair<std::string, std::vector<double>>{"duo", {6, 6}}, {"trio", {6.5, 0, -6.5}}}) {
    const std::string level = fmt::format("level = \"{}\"\n", GetParam());
    const double alone = takenAside(file, level, rates, 0), pushed = takenAside(file, level, rates, 2);
    EXPECT_GT(pushed - alone, 5e-4) << file;
    EXPECT_LT(pushed - alone, 0.05) << file;
  }
}

TEST_P(AnyLevel, WheelsDriveByTheirAngle) {
  WheeledRobot duo(wheeled("duo", fmt::format("level = \"{}\"\n", GetParam())));
  duo.turn({6, 6});
  duo.run(1);
  const double begin = duo.base().translation.x;
  duo.run(1);
  EXPECT_NEAR(duo.base().translation.x - begin, 6 * kRadius, 2e-3);
  EXPECT_NEAR(duo.base().translation.y, 0, 2e-3);
}

INSTANTIATE_TEST_SUITE_P(Levels, AnyLevel, testing::Values("kinematic", "fast"),
                         [](const auto& test) { return std::string(test.param); });

class Square : public testing::TestWithParam<std::pair<const char*, const char*>> {};

TEST_P(Square, EndsWhereItBegan) {
  const auto [file, level] = GetParam();
  WheeledRobot robot(wheeled(file, fmt::format("level = \"{}\"\nrole = \"square 0.8 0.3\"\n", level)),
                     {"robots.red.1.control=cart"});
  double farthest_x = 0, farthest_y = 0, turned = 0, last = 0;
  for (int i = 0; i < 2200; ++i) {
    robot.run(0.01);
    farthest_x = std::max(farthest_x, robot.base().translation.x);
    farthest_y = std::max(farthest_y, robot.base().translation.y);
    turned += wrappedAngle(robot.heading() - last), last = robot.heading();
  }
  const Vector3 end = robot.base().translation;
  EXPECT_NEAR(farthest_x, 0.8, 0.04);
  EXPECT_NEAR(farthest_y, 0.8, 0.04);
  EXPECT_LT(std::hypot(end.x, end.y), 0.06);
  EXPECT_NEAR(turned, std::string(file) == "duo" ? 2 * kPi : 0, 0.06);
  EXPECT_LT(norm(robot.velocity().v), 1e-3);
}

INSTANTIATE_TEST_SUITE_P(Drives, Square,
                         testing::Values(std::pair{"duo", "kinematic"}, std::pair{"trio", "kinematic"},
                                         std::pair{"duo", "fast"}, std::pair{"trio", "fast"}),
                         [](const auto& test) { return fmt::format("{}_{}", test.param.first, test.param.second); });

/// Five robots of a kind that drive squares of different size; a game of its own for all of them together.
std::string fleet(const std::string& file, const std::string& level) {
  std::string text = "[referee]\nenabled = false\n[ball]\npresent = false\n";
  for (int i = 1; i <= 5; ++i)
    text += fmt::format(
        "[robots.red.{0}]\nfile = \"robots/{1}.urdf\"\nlevel = \"{2}\"\ncontrol = \"cart\"\ncameras.eye = \"none\"\n"
        "role = \"square 0.{0} 0.2\"\npose = [{3}, {0}, 0]\nproperties = {{\"chassis.mass\" = 2.{0}}}\n",
        i, file, level, 0.1 * i);
  return text;
}

TEST_P(Square, ManyAtOnceMoveAsOneByOneToTheBit) {
  const auto [file, level] = GetParam();
  std::vector<std::uint64_t> hashes;
  for (const std::string setting : {"simulation.lanes=1", "simulation.lanes=4", "simulation.lanes=8",
                                    "simulation.threads=1", "simulation.threads=2"}) {
    WheeledRobot all(fleet(file, level), {setting});
    all.run(1.5);
    hashes.push_back(all.simulation->stateHash());
  }
  for (const std::uint64_t hash : hashes) EXPECT_EQ(hash, hashes.front());
}

TEST_P(Square, AContinuedRunIsTheSameRun) {
  const auto [file, level] = GetParam();
  const std::string text = fleet(file, level);
  const std::filesystem::path place =
      std::filesystem::temp_directory_path() / fmt::format("murosimf_{}_{}_checkpoint", file, level);
  WheeledRobot whole(text), second(text);
  whole.run(0.7);
  saveCheckpoint(place, *whole.simulation, "wheels");
  whole.run(0.7);
  loadCheckpoint(place, *second.simulation);
  second.run(0.7);
  EXPECT_EQ(second.simulation->stateHash(), whole.simulation->stateHash());
  std::filesystem::remove_all(place);
}

TEST(WheeledLevels, AnExchangeKeepsPlaceAndSpeed) {
  WheeledRobot duo(wheeled("duo", "motion = \"wheeled_kinematics, simplified_dynamics@1, wheeled_kinematics@2\"\n"));
  duo.turn({6, 6});
  duo.run(3);
  EXPECT_NEAR(duo.velocity().v.x, 0.3, 2e-3);
  EXPECT_NEAR(duo.base().translation.x, 0.3 * 3, 0.03);
  EXPECT_NEAR(duo.base().translation.z, 0, 1e-9);
}

TEST(WheeledLevels, FullDynamicsRollsWithServosThatHoldRates) {
  WheeledRobot duo(wheeled("duo", "level = \"full\"\nelectronics = {commanded_gains = 1}\n"));
  duo.turn({6, 6});
  duo.run(2);
  const double begin = duo.base().translation.x;
  duo.run(1);
  EXPECT_NEAR(duo.base().translation.x - begin, 0.3, 0.03);
}

TEST(WheeledLevels, ARobotWithoutWheelsIsRefused) {
  BuiltWorld ks21("[robots.red.1]\nfile = \"robots/ks21.urdf\"\npose = [0, 0, 0]\nmotion = \"wheeled_kinematics\"\n");
  bool told = false;
  for (const std::string& words : ks21.complaints())
    told = told || (startsWith(words, "4:10:") && words.find("needs property wheels") != std::string::npos);
  EXPECT_TRUE(told);
}

/// What is said of duo with some words of its file exchanged for others.
std::string saidOfChanged(const std::string& words, const std::string& others) {
  std::ifstream file(kRoot / "robots" / "duo.urdf");
  std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  const std::size_t place = text.find(words);
  EXPECT_NE(place, std::string::npos);
  const std::filesystem::path changed = std::filesystem::temp_directory_path() / "murosimf_changed_duo.urdf";
  std::ofstream(changed) << text.replace(place, words.size(), others);
  BuiltWorld built(fmt::format("[robots.red.1]\nfile = \"{}\"\npose = [0, 0, 0]\n", changed.string()));
  std::string said;
  for (const std::string& line : built.complaints()) said += line + "\n";
  std::filesystem::remove(changed);
  return said;
}

TEST(WheeledLevels, RobotsThatCannotStandOnTheirWheelsAreRefused) {
  EXPECT_NE(saidOfChanged("<origin xyz=\"-0.1 0 0.018\"/>", "<origin xyz=\"0.1 0 0.018\"/>")
                .find("wheel 1 of the robot carries -"),
            std::string::npos);
  EXPECT_NE(saidOfChanged("<origin xyz=\"-0.1 0 0.018\"/>", "<origin xyz=\"-0.1 0 0.03\"/>")
                .find("wheel 1 of the robot hangs 0.012 m above the ground"),
            std::string::npos);
  EXPECT_NE(saidOfChanged("<murosimf><castor name=\"castor\" friction=\"0.06\"/></murosimf>", "")
                .find("the robot has 2 wheels and castors that stand in one line"),
            std::string::npos);
}

TEST(WheeledLevels, ARobotOnWheelsDoesNotWalk) {
  BuiltWorld duo("[robots.red.1]\nfile = \"robots/duo.urdf\"\npose = [0, 0, 0]\nmotion = \"kinematic_walking\"\n");
  bool told = false;
  for (const std::string& words : duo.complaints())
    told = told || words.find("0 soles; expected 2") != std::string::npos;
  EXPECT_TRUE(told);
}

}  // namespace
}  // namespace murosimf::test
