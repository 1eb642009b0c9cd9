// Which parameter file a servo gets, and what goes before it.

#include "murosimf/scene/servo_builder.h"

#include <fstream>
#include <sstream>

#include "murosimf/modules/actuation/motor_properties.h"
#include "scene/built_world.h"

namespace murosimf::test {
namespace {

namespace fs = std::filesystem;

const std::string kProperties = kTwoRobots + "[robots.red.1.properties]\n";

double constantOf(BuiltWorld& built, const std::string& joint, const Constant<double>& constant) {
  const World& world = built.builder.world();
  return world.find(world.find("robots.red.1." + joint), constant).value_or(-1);
}

TEST(ServoBuilder, TheRobotsFileIsThatOfAllItsServos) {
  BuiltWorld built(kProperties + "servo_file = \"robots/servos/mx64_m1.json\"");
  EXPECT_EQ(built.diagnostics.text(), "");
  EXPECT_EQ(constantOf(built, "knee_left", kTorqueConstant), 1.6225);
  EXPECT_EQ(constantOf(built, "head_pan", kTorqueConstant), 1.6225);
  EXPECT_EQ(constantOf(built, "knee_left", kArmature), 0.01195);  // goes before the servo type's
  const World& world = built.builder.world();
  EXPECT_FALSE(world.find(world.find("robots.blue.1.knee_left"), kTorqueConstant));
  EXPECT_NE(built.simulation(), nullptr);
}

TEST(ServoBuilder, AJointsFileGoesBeforeTheRobotsAndNoneIsNoFile) {
  BuiltWorld built(kProperties +
                   "servo_file = \"robots/servos/mx64_m1.json\"\n"
                   "\"knee_left.servo_file\" = \"robots/servos/mx106_m1.json\"\n\"head_pan.servo_file\" = \"none\"");
  EXPECT_EQ(built.diagnostics.text(), "");
  EXPECT_EQ(constantOf(built, "knee_left", kTorqueConstant), 2.1914);
  EXPECT_EQ(constantOf(built, "knee_right", kTorqueConstant), 1.6225);
  EXPECT_EQ(constantOf(built, "head_pan", kTorqueConstant), -1);
  EXPECT_EQ(constantOf(built, "head_pan", kArmature), 0.005);
}

TEST(ServoBuilder, AWrittenPropertyGoesBeforeTheFiles) {
  BuiltWorld built(kProperties +
                   "servo_file = \"robots/servos/mx64_m1.json\"\n"
                   "\"knee_left.friction_base\" = 0.2\n\"knee_left.armature\" = 0.03");
  EXPECT_EQ(constantOf(built, "knee_left", kFrictionBase), 0.2);
  EXPECT_EQ(constantOf(built, "knee_left", kArmature), 0.03);
  EXPECT_EQ(constantOf(built, "knee_right", kFrictionBase), 0.0904);
}

TEST(ServoBuilder, TheCommandLineMayNameAFile) {
  BuiltWorld built(kTwoRobots, {"robots.red.1.properties.servo_file=\"robots/servos/mx64_m1.json\""});
  EXPECT_EQ(built.diagnostics.text(), "");
  EXPECT_EQ(constantOf(built, "knee_left", kTorqueConstant), 1.6225);
}

TEST(ServoBuilder, ARobotOfLevelFullRunsOnMotors) {
  BuiltWorld built(kTwoRobots + R"(
[robots.red.1.properties]
servo_file = "robots/servos/mx64_m4.json"
[robots.all]
level = "full"
[robots.red.1.modules]
gear_load = {}
joint_limits = {}
joint_friction = {}
[robots.red.1.electronics]
encoder_steps = 1
delay_steps = 5
[robots.red.1.actuation]
module = "dc_motor"
)");
  const auto simulation = built.simulation();
  for (int i = 0; i < 50; ++i) simulation->step();
  const auto load = simulation->linked().handle(simulation->world().find("robots.red.1"), kGearLoad, subset::kJoints);
  const auto joints = built.builder.describe(built.scene.robots.front()).joints;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    if (joints[j].name != "knee_right") continue;
    EXPECT_GT(std::abs(load.get(static_cast<int>(j))), 1e-3);  // it bears weight
    return;
  }
  FAIL() << "no knee";
}

/// KS21 in a folder of its own, where servo type RX-64, that of its knees, names a file beside it.
class ServoTypeWithFile : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder_ / "servos");
    fs::copy_file(kRoot / "robots/servos/mx106_m1.json", folder_ / "servos/knee.json",
                  fs::copy_options::overwrite_existing);
    std::stringstream text;
    text << std::ifstream(kRoot / "robots/ks21.urdf").rdbuf();
    std::string robot = text.str();
    const std::string type = "<servo_type name=\"RX-64\"";
    robot.replace(robot.find(type), type.size(), type + " file=\"servos/knee.json\"");
    std::ofstream(folder_ / "robot.urdf") << robot;
  }
  void TearDown() override { fs::remove_all(folder_); }
  std::string scenario(const std::string& properties = "") const {
    return "[robots.red.1]\nfile = \"" + (folder_ / "robot.urdf").string() +
           "\"\npose = [0, 0, 0]\n[robots.red.1.properties]\n" + properties;
  }
  fs::path folder_ = fs::path(testing::TempDir()) / fmt::format("murosimf_servo_{}", ::getpid());
};

TEST_F(ServoTypeWithFile, GivesItToItsJoints) {
  BuiltWorld built(scenario());
  EXPECT_EQ(built.diagnostics.text(), "");
  EXPECT_EQ(constantOf(built, "knee_left", kTorqueConstant), 2.1914);
  EXPECT_EQ(constantOf(built, "knee_right", kTorqueConstant), 2.1914);
  EXPECT_EQ(constantOf(built, "head_pan", kTorqueConstant), -1);
}

TEST_F(ServoTypeWithFile, YieldsToTheScenario) {
  BuiltWorld built(scenario("servo_file = \"" + (kRoot / "robots/servos/mx64_m1.json").string() + "\""));
  EXPECT_EQ(built.diagnostics.text(), "");
  EXPECT_EQ(constantOf(built, "knee_left", kTorqueConstant), 1.6225);
}

TEST_F(ServoTypeWithFile, ThatIsNotThereIsToldOnce) {
  fs::remove(folder_ / "servos/knee.json");
  fs::copy_file(kRoot / "robots/servos/mx106_m1.json", folder_ / "servos/kne.json");
  const std::vector<std::string> said = BuiltWorld(scenario()).complaints();
  ASSERT_EQ(said.size(), 1U);
  EXPECT_NE(said[0].find("there is no servo file \"servos/knee.json\", looked for from " + folder_.string()),
            std::string::npos)
      << said[0];
  EXPECT_NE(said[0].find("(did you mean \"servos/kne.json\"?)"), std::string::npos) << said[0];
}

TEST(ServoBuilder, ToldMistakesHaveTheirPlace) {
  EXPECT_EQ(BuiltWorld(kProperties + "servo_file = 3").complaints(),
            std::vector<std::string>{"9:14: servo_file of robots.red.1 is no text, expected the name of a file"});
  const auto said = BuiltWorld(kProperties + "\"knee_left.servo_file\" = \"robots/servos/mx65_m1.json\"").complaints();
  ASSERT_EQ(said.size(), 1U);
  EXPECT_TRUE(startsWith(said[0], "9:26: there is no servo file \"robots/servos/mx65_m1.json\", looked for from "))
      << said[0];
  EXPECT_TRUE(said[0].ends_with("(did you mean \"robots/servos/mx64_m1.json\"?)")) << said[0];
}

}  // namespace
}  // namespace murosimf::test
