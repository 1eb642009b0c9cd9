// Worlds built from scenarios hold what scenario and robot file say.

#include "murosimf/scene/world_builder.h"

#include <algorithm>

#include "scene/built_world.h"

namespace murosimf::test {
namespace {

ObjectId redOne(const World& world) { return world.find("robots.red.1"); }

TEST(WorldBuilder, Ks21BecomesItsJointsBodiesSolesAndCameras) {
  BuiltWorld built(kTwoRobots);
  const World& world = built.builder.world();
  for (const char* path : {"robots.red.1", "robots.blue.1"}) {
    const ObjectId robot = world.find(path);
    ASSERT_TRUE(robot.valid());
    EXPECT_EQ(world.members(robot, subset::kJoints).size(), 21u);
    EXPECT_EQ(world.members(robot, subset::kBodies).size(), 22u);
    EXPECT_EQ(world.members(robot, subset::kSoles).size(), 2u);
    EXPECT_EQ(world.members(robot, kCamerasSubset).size(), 2u);
    EXPECT_NEAR(*world.find(robot, kMass), 3.3, 1e-12);
  }
  EXPECT_EQ(world.path(world.members(redOne(world), subset::kSoles)[0]), "robots.red.1.sole_right");
  EXPECT_EQ(built.builder.participants().robots.size(), 2u);
  EXPECT_EQ(built.builder.participants().free_bodies.size(), 1u);
}

/// One frame; the robots then stand where the scenario puts them, upright on straight legs.
std::unique_ptr<Simulation> afterOneStep(BuiltWorld& built) {
  std::unique_ptr<Simulation> simulation = built.simulation();
  for (int i = 0; i < 20; ++i) simulation->step();
  return simulation;
}

TEST(WorldBuilder, CamerasOfAStraightRobotSitWhereItsTableSays) {
  // Mid hip .285 above the soles; head camera .04 before and .235 above it, chest camera .055 and .11, 20 degrees down.
  BuiltWorld built(kTwoRobots);
  const auto simulation = afterOneStep(built);
  const ControlledRobot& blue = simulation->control()->robot(
      simulation->control()->indexOf(simulation->world().find("robots.blue.1")));  // at (1, 0), looking along -x
  ASSERT_EQ(blue.cameras.size(), 2u);
  const auto poseOf = [&](const char* name) {
    for (const auto& camera : blue.cameras) {
      if (simulation->world().path(camera->object()) != std::string("robots.blue.1.") + name) continue;
      return camera->place(simulation->view(), simulation->frame() - 1).X_WC;
    }
    ADD_FAILURE() << "no camera " << name;
    return Pose{};
  };
  constexpr double kTolerance = 1e-9;
  const Pose head = poseOf("head"), chest = poseOf("chest");
  EXPECT_NEAR(head.translation.x, 1 - .04, kTolerance);
  EXPECT_NEAR(head.translation.y, 0, kTolerance);
  EXPECT_NEAR(head.translation.z, .285 + .235, kTolerance);
  EXPECT_NEAR(head.rotation.z.x, -1, kTolerance);  // forward
  EXPECT_NEAR(head.rotation.x.y, 1, kTolerance);   // right
  EXPECT_NEAR(head.rotation.y.z, -1, kTolerance);  // down
  EXPECT_NEAR(chest.translation.x, 1 - .055, kTolerance);
  EXPECT_NEAR(chest.translation.z, .285 + .11, kTolerance);
  EXPECT_NEAR(chest.rotation.z.x, -0.9396926208, kTolerance);
  EXPECT_NEAR(chest.rotation.z.z, -0.3420201433, kTolerance);
}

TEST(WorldBuilder, TheBallLiesOnItsMarkAndRobotsStandAtTheirPoses) {
  BuiltWorld built(kTwoRobots, {"ball.position=[0.5, -0.25, 0.0]"});
  const auto simulation = afterOneStep(built);
  LinkedWorld& linked = simulation->linked();
  const Pose ball = linked.handle(simulation->world().find("ball"), kBasePose).get();
  EXPECT_NEAR(ball.translation.x, 0.5, 1e-9);
  EXPECT_NEAR(ball.translation.y, -0.25, 1e-9);
  EXPECT_NEAR(ball.translation.z, 0.07, 2e-3);
  const Pose red = linked.handle(redOne(simulation->world()), kBasePose).get();
  EXPECT_NEAR(red.translation.x, -1, 1e-9);
  EXPECT_NEAR(red.translation.z, 0.285, 1e-9);
}

TEST(WorldBuilder, APropertyOfTheScenarioReachesItsModule) {
  // At most 0.5 rad/s instead of the servo's 5.36: 0.05 rad in 0.1 s.
  BuiltWorld built(kTwoRobots + "[robots.red.1.properties]\n\"knee_left.largest_velocity\" = 0.5\n");
  const auto simulation = built.simulation();
  for (const char* path : {"robots.red.1", "robots.blue.1"}) {
    const ObjectId robot = simulation->world().find(path);
    Handle<ServoCommand> command = simulation->linked().handle(robot, kJointCommand, subset::kJoints);
    for (int j = 0; j < command.size(); ++j) command.set({0.3, 0, 0, 1, 0}, j);
  }
  for (int i = 0; i < 100; ++i) simulation->step();
  const auto kneeOf = [&](const char* path) {
    const World& world = simulation->world();
    const auto joints = world.members(world.find(path), subset::kJoints);
    const auto knee = std::find(joints.begin(), joints.end(), world.find(std::string(path) + ".knee_left"));
    return simulation->linked()
        .handle(world.find(path), kJointPosition, subset::kJoints)
        .get(static_cast<int>(knee - joints.begin()));
  };
  EXPECT_NEAR(kneeOf("robots.red.1"), 0.05, 1e-12);
  EXPECT_NEAR(kneeOf("robots.blue.1"), 0.3, 1e-12);
}

TEST(WorldBuilder, ARobotWeighsWhatItsBodiesWeigh) {
  BuiltWorld built(kTwoRobots + "[robots.red.1.properties]\n\"trunk.mass\" = 2.5\n");
  const World& world = built.builder.world();
  EXPECT_NEAR(*world.find(redOne(world), kMass), 3.3 + 1.5, 1e-12);
  EXPECT_NEAR(*world.find(world.find("robots.blue.1"), kMass), 3.3, 1e-12);
  BuiltWorld whole(kTwoRobots + "[robots.red.1.properties]\n\"trunk.mass\" = 2.5\nmass = 10\n");
  EXPECT_EQ(*whole.builder.world().find(redOne(whole.builder.world()), kMass), 10);
}

TEST(WorldBuilder, MotionsPeriodHoldsForWhatFollowsIt) {
  BuiltWorld built(kTwoRobots + "[robots.red.1.motion]\nperiod = 0.004\n");
  const auto simulation = built.simulation();
  LinkedWorld& linked = simulation->linked();
  const World& world = simulation->world();
  EXPECT_EQ(linked.handle(redOne(world), kJointPosition, subset::kJoints).period(), 4);
  EXPECT_EQ(linked.handle(redOne(world), kBasePose).period(), 4);
  EXPECT_EQ(linked.handle(redOne(world), kBodyPose, subset::kBodies).period(), 4);
  EXPECT_EQ(linked.handle(redOne(world), kGyroscope, subset::kImus).period(), 4);
  EXPECT_EQ(linked.handle(world.find("robots.blue.1"), kBasePose).period(), 10);
}

TEST(WorldBuilder, CamerasCanBeShutAndSlowed) {
  BuiltWorld built(kTwoRobots + "[robots.red.1.cameras]\nhead = \"none\"\nchest = {period = 0.25}\n");
  const auto simulation = built.simulation();
  const ControlledRobot& red =
      simulation->control()->robot(simulation->control()->indexOf(redOne(simulation->world())));
  const auto& cameras = red.port.description().cameras;
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(red.cameras[i] == nullptr, cameras[i].name == "head");
    if (cameras[i].name == "chest") {
      EXPECT_EQ(cameras[i].period, 0.25);
      EXPECT_EQ(red.cameras[i]->period(), 250);
    }
  }
}

TEST(WorldBuilder, ControlSoftwareIsToldItsTeamsViewOfTheField) {
  BuiltWorld built(kTwoRobots, {"robots.blue.1.role=keeper", "simulation.seed=12"});
  const client::RobotDescription red = built.builder.describe(built.scene.robots[0]);
  const client::RobotDescription blue = built.builder.describe(built.scene.robots[1]);
  EXPECT_EQ(red.model, "ks21");
  EXPECT_EQ(red.team, "red");
  EXPECT_EQ(blue.team, "blue");
  EXPECT_EQ(blue.number, 1);
  EXPECT_EQ(blue.role, "keeper");
  EXPECT_EQ(red.seed, 12u);
  EXPECT_TRUE(red.attacks_positive_x);
  EXPECT_FALSE(blue.attacks_positive_x);
  // Each attacks what the other defends.
  EXPECT_EQ(red.goal_colour_attacked, *built.scene.field.goal_at_plus_x);
  EXPECT_EQ(red.goal_colour_defended, *built.scene.field.goal_at_minus_x);
  EXPECT_EQ(blue.goal_colour_attacked, red.goal_colour_defended);
  EXPECT_EQ(blue.goal_colour_defended, red.goal_colour_attacked);
  EXPECT_NE(red.goal_colour_attacked, red.goal_colour_defended);
  EXPECT_EQ(red.field.length, 4.5);
  EXPECT_EQ(red.field.width, 3.0);
  EXPECT_EQ(red.field.ball_radius, 0.07);
  EXPECT_EQ(red.control_period, 0.01);
}

TEST(WorldBuilder, ControlSoftwareIsToldItsJointsAndCameras) {
  BuiltWorld built(kTwoRobots);
  const client::RobotDescription d = built.builder.describe(built.scene.robots[0]);
  ASSERT_EQ(d.joints.size(), 21u);
  const auto knee = std::find_if(d.joints.begin(), d.joints.end(), [](const auto& j) { return j.name == "knee_left"; });
  ASSERT_NE(knee, d.joints.end());
  EXPECT_NEAR(knee->upper, 135 * kPi / 180, 1e-6);
  EXPECT_EQ(knee->largest_velocity, 5.36);
  ASSERT_EQ(d.cameras.size(), 2u);
  const auto head = std::find_if(d.cameras.begin(), d.cameras.end(), [](const auto& c) { return c.name == "head"; });
  ASSERT_NE(head, d.cameras.end());
  EXPECT_EQ(head->width, 640);
  EXPECT_NEAR(head->fx, 554.26, 5e-3);
  EXPECT_EQ(head->kc[0], -0.30);
  EXPECT_EQ(head->period, 0.05);
  EXPECT_EQ(head->body, "skull");
  EXPECT_NEAR(head->X_BC.translation.x, 0.03, 1e-15);
}

TEST(WorldBuilder, LensesAreSharedByRobotsOfOneFile) {
  BuiltWorld built(kTwoRobots);
  const auto simulation = built.simulation();
  ControlLoop& control = *simulation->control();
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(&control.robot(0).cameras[i]->model(), &control.robot(1).cameras[i]->model());
  }
}

}  // namespace
}  // namespace murosimf::test
