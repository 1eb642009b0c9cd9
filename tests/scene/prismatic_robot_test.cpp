// A robot file with prismatic joints in a scenario: servos, stops and sensors of a level of detail work on sliders too.

#include "murosimf/control/robot_port.h"
#include "murosimf/robot/flatten_tree.h"
#include "murosimf/robot/urdf_reader.h"
#include "murosimf/scene/robot_builder.h"
#include "scene/built_world.h"

namespace murosimf::test {
namespace {

std::string hopperAt(const std::string& level) {
  return "[referee]\nenabled = false\n[ball]\npresent = false\n[robots.red.1]\nfile = \"tests/data/hopper.urdf\"\npose "
         "= "
         "[0.5, -0.2, 1.0]\nlevel = \"" +
         level + "\"\n";
}

class Hopper : public testing::TestWithParam<const char*> {
 protected:
  BuiltWorld built_{hopperAt(GetParam())};
  std::unique_ptr<Simulation> simulation_ = built_.simulation();
  ObjectId robot_ = simulation_->world().find("robots.red.1");

  void command(double leg, double lift) {
    auto commands = simulation_->linked().handle(robot_, kJointCommand, subset::kJoints);
    commands.set({leg, 0, 0, 1, 0}, 0), commands.set({lift, 0, 0, 1, 0}, 1);
  }
  void run(double seconds) {
    for (long i = std::lround(seconds / simulation_->frameLength()); i > 0; --i) simulation_->step();
  }
  Pose base() const { return simulation_->linked().handle(robot_, kBasePose).get(); }
  double q(int joint) const { return simulation_->linked().handle(robot_, kJointPosition, subset::kJoints).get(joint); }
};

TEST_P(Hopper, StandsWhereItIsPutAndRaisesItsTrunkByWhatItsLegIsTold) {
  command(0.05, 0.02);
  run(2);
  const double before = base().translation.z;
  EXPECT_NEAR(base().translation.x, 0.5, 1e-3);
  EXPECT_NEAR(base().translation.y, -0.2, 1e-3);
  command(0.15, 0.02);
  run(3);
  EXPECT_NEAR(base().translation.z - before, 0.1, 1e-4);
  EXPECT_NEAR(base().rotation.z.z, 1, 1e-6);
}

TEST_P(Hopper, StaysWithinTheRangesOfItsSliders) {
  command(9, 9);
  run(3);
  for (const int joint : {0, 1}) EXPECT_NEAR(q(joint), 0.3, 0.01) << joint;
}

TEST_P(Hopper, ItsPortTellsWhetherItsOneSoleTouches) {
  client::RobotDescription description;
  description.joints.resize(2), description.soles = {"sole"};
  RobotPort port(simulation_->linked(), robot_, description);
  client::SensorFrame sensors;
  command(0.1, 0.02);
  run(3);  // it has hopped
  port.readSensors(3, sensors);
  ASSERT_EQ(sensors.sole_touches.size(), 1u);
  EXPECT_EQ(sensors.sole_touches[0], 1);
  Pose X_WB = base();
  X_WB.translation.z += 0.5;
  simulation_->linked().handle(robot_, kBasePose).set(X_WB);
  run(0.05);
  port.readSensors(3.05, sensors);
  EXPECT_EQ(sensors.sole_touches[0], 0);
}

INSTANTIATE_TEST_SUITE_P(Levels, Hopper, testing::Values("full", "fast"),
                         [](const auto& test) { return std::string(test.param); });

TEST(Soles, OfARobotAreNumberedRightLeftAndThenThoseOfNoSide) {
  Diagnostics diagnostics;
  const auto foot = [](const std::string& name, const std::string& side) {
    return "<link name='" + name +
           "'><inertial><mass value='1'/><inertia ixx='1' iyy='1' izz='1'/></inertial><murosimf>"
           "<sole name='sole_" +
           name + "' " + side + " size='0.1 0.1'/></murosimf></link>";
  };
  const auto joint = [](const std::string& name) {
    return "<joint name='joint_" + name + "' type='continuous'><parent link='a'/><child link='" + name + "'/></joint>";
  };
  const ReadResult model = readUrdfText("<robot name='stool'>" + foot("a", "") + foot("b", "side='left'") + joint("b") +
                                            foot("c", "side='right'") + joint("c") + "</robot>",
                                        "stool.urdf", diagnostics);
  ASSERT_TRUE(model) << diagnostics.text();
  RobotBlueprint print{*model, {}};
  print.flat = flattenTree(print.model.tree);
  World world;
  const ObjectId robot = addRobot(world, "stool", print, Colour{});
  std::vector<std::string> names;
  for (const ObjectId sole : world.members(robot, subset::kSoles)) names.push_back(world.path(sole));
  EXPECT_EQ(names, (std::vector<std::string>{"stool.sole_c", "stool.sole_b", "stool.sole_a"}));
  const std::vector<SolePlace>& places = *world.findShared(robot, kSoles);
  EXPECT_EQ(places[2].mount.row, 0);
}

}  // namespace
}  // namespace murosimf::test
