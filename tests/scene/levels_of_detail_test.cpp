// Levels of detail of a scenario's robots: chosen one by one, without a change to the others.

#include "murosimf/simulation/state_hash.h"
#include "scene/built_world.h"

namespace murosimf::test {
namespace {

std::string game(const std::string& red, const std::string& blue) {
  return "[referee]\nenabled = false\n[ball]\nposition = [0, 2]\n" + kTwoRobots +
         fmt::format(
             "[robots.red.2]\nfile = \"robots/ks21.urdf\"\npose = [0, -1, 0.4]\n{}\n[robots.blue.2]\nfile = "
             "\"robots/ks21.urdf\"\npose = [0, 1, 2]\n{}\n",
             red, blue);
}

/// State of one robot of a simulation after a tenth of a second.
std::vector<double> stateOf(const std::string& text, const std::string& path) {
  BuiltWorld built(text);
  const auto simulation = built.simulation();
  for (int i = 0; i < 100; ++i) simulation->step();
  std::vector<double> state;
  for (const Place& place : simulation->linked().places()) {
    if (simulation->world().path(place.assembly) != path) continue;
    simulation->linked().visitState(place,
                                    [&](const ColumnLayout&, int, int, double value) { state.push_back(value); });
  }
  return state;
}

TEST(LevelsOfDetail, ARobotKeepsItsBitsWhateverLevelTheOthersHave) {
  const std::string full = "level = \"full\"";
  const std::vector<double> alone = stateOf(game(full, ""), "robots.red.2");
  EXPECT_EQ(alone, stateOf(game(full, full), "robots.red.2"));
  EXPECT_EQ(alone,
            stateOf(game(full, "motion = \"multibody_dynamics\"\nintegration = \"runge_kutta_4\""), "robots.red.2"));
  EXPECT_EQ(stateOf(game("", full), "robots.red.2"), stateOf(game("", ""), "robots.red.2"));
  EXPECT_GT(alone.size(), 60U);
}

TEST(LevelsOfDetail, AMotionBringsTheModulesThatGoWithIt) {
  EXPECT_EQ(stateOf(game("level = \"full\"", ""), "robots.red.2"),
            stateOf(game("motion = \"multibody_dynamics\"", ""), "robots.red.2"));
}

/// Names of the modules that step the robot at each level of detail of its plan.
std::vector<std::vector<std::string>> modulesAtLevels(const std::string& red) {
  BuiltWorld built(game(red, ""));
  const auto simulation = built.simulation();
  const LinkedWorld& linked = simulation->linked();
  std::vector<std::vector<std::string>> levels;
  for (const LevelSeat& seat : linked.residentOf(simulation->world().find("robots.red.2")).levels) {
    std::vector<std::string>& names = levels.emplace_back();
    for (const LinkedPass& pass : linked.batches()[static_cast<std::size_t>(seat.batch)].passes) {
      names.push_back(pass.name);
    }
  }
  return levels;
}

bool has(const std::vector<std::string>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

TEST(LevelsOfDetail, AModuleIsChosenForThoseLevelsThatCanWorkWithIt) {
  const auto levels = modulesAtLevels(
      "motion = \"kinematic_walking, multibody_dynamics@5, simplified_dynamics@6\"\nactuation = \"dc_motor\"\n"
      "contact = \"paper_contact\"\nintegration = \"midpoint\"\ntorque = \"torque_estimate\"\n"
      "modules = {gear_load = {}, joint_friction = {}}\nproperties = {servo_file = \"robots/servos/mx64_m4.json\"}\n");
  ASSERT_EQ(levels.size(), 3U);
  EXPECT_TRUE(has(levels[0], "ideal_servo"));
  EXPECT_FALSE(has(levels[0], "dc_motor") || has(levels[0], "joint_friction"));
  for (const char* name :
       {"dc_motor", "gear_load", "joint_friction", "midpoint", "paper_contact", "joint_torque_sensor"})
    EXPECT_TRUE(has(levels[1], name)) << name;
  for (const char* name : {"tracking_servo", "momentum_midpoint", "paper_contact", "torque_estimate"})
    EXPECT_TRUE(has(levels[2], name)) << name;
  EXPECT_FALSE(has(levels[2], "dc_motor") || has(levels[2], "midpoint") || has(levels[2], "gear_load"));
}

TEST(LevelsOfDetail, APlacedRobotWithDynamicsStandsThereAtRest) {
  BuiltWorld built(game("level = \"full\"", ""));
  const auto simulation = built.simulation();
  const ObjectId robot = simulation->world().find("robots.red.2");
  for (int i = 0; i < 300; ++i) simulation->step();
  simulation->interventions().placeRobot(300, robot, {1.2, -0.7, 0.5});
  for (int i = 0; i < 5; ++i) simulation->step();
  const Pose X_WB = simulation->linked().handle(robot, kBasePose).get();
  EXPECT_NEAR(X_WB.translation.x, 1.2, 1e-3);
  EXPECT_NEAR(X_WB.translation.y, -0.7, 1e-3);
  EXPECT_NEAR(atan2(X_WB.rotation.x.y, X_WB.rotation.x.x), 0.5, 1e-3);
  EXPECT_LT(norm(simulation->linked().handle(robot, kBaseVelocity).get().v), 0.1);
  const BodyPath path(simulation->linked(), robot);
  EXPECT_LT(norm(path.last(0).translation - path.end(0).translation), 1e-3) << "no path leads to where it was put";
}

/// Where a ball is that was rolled against a foot of the robot, which holds itself upright.
Vector3 ballAtFoot(const std::string& level) {
  BuiltWorld built(game("level = \"" + level + "\"", ""), {"robots.red.2.pose=[0, -1, 0]"});
  const auto simulation = built.simulation();
  const ObjectId ball = simulation->world().find("ball"), robot = simulation->world().find("robots.red.2");
  auto commands = simulation->linked().handle(robot, kJointCommand, subset::kJoints);
  for (int j = 0; j < commands.size(); ++j) commands.set({0, 0, 0, 1, 0}, j);
  simulation->interventions().placeBody(0, ball, {0.3, -1.05, 0.07}, {-1, 0, 0});
  for (int i = 0; i < 400; ++i) simulation->step();
  EXPECT_GT(simulation->linked().handle(robot, kBasePose).get().rotation.z.z, 0.9);
  return simulation->linked().handle(ball, kBasePose).get().translation;
}

TEST(LevelsOfDetail, TheBallMeetsAFootWithDynamicsWhereItMeetsAKinematicOne) {
  const Vector3 dynamic = ballAtFoot("full"), kinematic = ballAtFoot("kinematic");
  EXPECT_LT(norm(dynamic - kinematic), 4e-3);
  EXPECT_GT(kinematic.z, 0.075) << "it was to climb onto the foot";
}

}  // namespace
}  // namespace murosimf::test
