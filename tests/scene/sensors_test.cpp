// Sensors of a scenario's robots: what control software sees of them, and what is said of mistakes.

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "scene/built_world.h"

namespace murosimf::test {
namespace {

namespace fs = std::filesystem;

std::string robot(const std::string& more, const std::string& file = "robots/ks21.urdf") {
  return fmt::format(
      "[referee]\nenabled = false\n[ball]\npresent = false\n[robots.red.1]\nfile = \"{}\"\npose = [0, 0, 0]\n{}", file,
      more);
}

/// What robots.red.1's control software is given after so many frames.
client::SensorFrame seen(Simulation& simulation, RobotPort& port, int frames) {
  for (int i = 0; i < frames; ++i) simulation.step();
  client::SensorFrame sensors;
  port.readSensors(0.001 * frames, sensors);
  return sensors;
}

struct Port {
  explicit Port(const std::string& text, const std::vector<std::string>& overrides = {}) : built(text, overrides) {
    simulation = built.simulation();
    const ObjectId id = simulation->world().find("robots.red.1");
    client::RobotDescription description;
    description.joints.resize(simulation->world().members(id, subset::kJoints).size());
    description.soles.resize(simulation->world().members(id, subset::kSoles).size());
    description.touch_sensors = {"toes"};
    description.force_sensors = {"ankle"};
    port = std::make_unique<RobotPort>(simulation->linked(), id, description);
  }
  client::SensorFrame after(int frames) { return seen(*simulation, *port, frames); }
  BuiltWorld built;
  std::unique_ptr<Simulation> simulation;
  std::unique_ptr<RobotPort> port;
};

TEST(Sensors, ControlSoftwareSeesReadingsInThePlaceOfValues) {
  for (const std::string level : {"level = \"kinematic\"\n", "level = \"full\"\n"}) {
    Port plain(robot(level));
    Port wrong(
        robot(level +
              "modules.gyroscope_errors = {offset = 0.5}\nmodules.accelerometer_errors = {offset = 2}\n"
              "modules.joint_position_errors = {quantum = 0.1}\nmodules.joint_velocity_errors = {offset = 7}\n"));
    const client::SensorFrame is = plain.after(200), reads = wrong.after(200);
    EXPECT_NEAR(reads.angular_velocity.x, is.angular_velocity.x + 0.5, 1e-12) << level;
    EXPECT_NEAR(reads.specific_force.z, is.specific_force.z + 2, 1e-12);
    for (std::size_t j = 0; j < 21; ++j) {
      EXPECT_NEAR(reads.joints[j].position, 0.1 * std::round(is.joints[j].position / 0.1), 1e-12);
      EXPECT_NEAR(reads.joints[j].velocity, is.joints[j].velocity + 7, 1e-12);
    }
  }
}

TEST(Sensors, OfLevelFullTellTorquesAndPressuresWithTheirErrors) {
  Port plain(robot("level = \"full\"\n"));
  Port wrong(
      robot("level = \"full\"\nmodules.joint_torque_errors = {offset = 1}\n"
            "modules.foot_pressure_errors = {offset = 3}\n"));
  const client::SensorFrame is = plain.after(300), reads = wrong.after(300);
  double sum = 0;
  for (std::size_t s = 0; s < 2; ++s) {
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_NEAR(reads.sole_pressures[s][k], is.sole_pressures[s][k] + 3, 1e-12);
      sum += is.sole_pressures[s][k];
    }
  }
  EXPECT_GT(sum, 5) << "it was to stand";
  EXPECT_NEAR(reads.joints[12].torque, is.joints[12].torque + 1, 1e-12);
}

TEST(Sensors, ErrorsLeaveTheMotionAlone) {
  Port plain(robot("level = \"full\"\n"));
  Port wrong(robot("level = \"full\"\nmodules.joint_position_errors = {noise = 0.1, delay = 0.01, rate = 200}\n"));
  plain.after(200), wrong.after(200);
  const auto base = [](Port& p) {
    return p.simulation->linked().handle(p.simulation->world().find("robots.red.1"), kBasePose).get();
  };
  EXPECT_EQ(base(plain), base(wrong));
}

TEST(Sensors, NoiseFollowsFromTheSeedOfTheScenario) {
  const std::string text = robot("modules.gyroscope_errors = {noise = 0.1}\n");
  const Vector3 first = Port(text).after(50).angular_velocity;
  EXPECT_EQ(Port(text).after(50).angular_velocity, first);
  EXPECT_NE(Port(text, {"simulation.seed=5"}).after(50).angular_velocity, first);
}

TEST(Sensors, DelaysBeginAnewWhenTheLevelOfDetailIsExchangedAndBiasesStay) {
  Port port(
      robot("motion = \"kinematic_walking, multibody_dynamics@0.1\"\n"
            "modules.joint_position_errors = {delay = 0.02, bias = 0.1}\n"));
  const ObjectId id = port.simulation->world().find("robots.red.1");
  const auto truth = port.simulation->linked().handle(id, kJointPosition, subset::kJoints);
  std::vector<double> truths, readings;
  for (int k = 0; k < 200; ++k) {
    readings.push_back(port.after(1).joints[12].position);
    truths.push_back(truth.get(12));
  }
  ASSERT_EQ(port.simulation->linked().levelOf(id), 1);
  const double bias = readings[50] - truths[29];  // of steps of 10 ms
  EXPECT_GT(std::fabs(bias), 1e-3);
  for (std::size_t k = 140; k < 200; ++k) EXPECT_NEAR(readings[k], truths[k - 20] + bias, 1e-12) << k;
  EXPECT_GT(std::fabs(truths[199] - truths[140]), 1e-6) << "it was to give way";
}

TEST(Sensors, ErrorsHoldAtTheLevelsThatHaveTheSensor) {
  Port port(
      robot("motion = \"kinematic_walking, multibody_dynamics@0.1\"\n"
            "modules.foot_pressure_errors = {offset = 3}\n"));
  EXPECT_EQ(port.after(50).sole_pressures[0][0], 0);
  const client::SensorFrame sensors = port.after(250);
  const ObjectId id = port.simulation->world().find("robots.red.1");
  const double truth = port.simulation->linked().handle(id, kSolePressure, subset::kSoles).get().of[0];
  EXPECT_NEAR(sensors.sole_pressures[0][0], truth + 3, 1e-12);
}

TEST(Sensors, ASensorThatTheLevelLacksIsNamedWithItsPlace) {
  const std::vector<std::string> said =
      BuiltWorld(robot("level = \"kinematic\"\nmodules.foot_pressure_errors = {noise = 1}\n")).complaints();
  ASSERT_EQ(said.size(), 1U);
  EXPECT_EQ(said[0].substr(0, 4), "9:9:");
  EXPECT_NE(said[0].find("module foot_pressure_errors reads variable sole_pressure [N] of soles, which no module "
                         "writes; expected foot_pressure"),
            std::string::npos)
      << said[0];
}

TEST(Sensors, ErrorsOfWhatTheRobotHasNoneOfAreRefused) {
  const std::vector<std::string> said =
      BuiltWorld(robot("modules.force_errors = {noise = 1}\nlevel = \"full\"\n")).complaints();
  ASSERT_EQ(said.size(), 1U);
  EXPECT_EQ(
      said[0],
      "8:9: robots.red.1: module force_errors: the robot has no force sensors; expected some whose readings could "
      "have errors");
}

TEST(Sensors, WrongNumbersOfErrorsAreNamedWithTheirPlace) {
  const auto said = [](const std::string& errors) {
    return BuiltWorld(robot("modules.gyroscope_errors = " + errors + "\n")).complaints().at(0);
  };
  EXPECT_NE(said("{noise = -1}").find("parameter noise of module gyroscope_errors is -1 rad/s; expected 0 to"),
            std::string::npos);
  EXPECT_NE(said("{rate = 400}").find("rate is 400 samples a second; expected at most 100, one a step of 0.01 s"),
            std::string::npos);
  EXPECT_NE(said("{nois = 1}").find("did you mean \"noise\""), std::string::npos);
}

/// KS21 with a force sensor in its left ankle and a switch under its left foot.
class FeltFoot : public ::testing::Test {
 protected:
  FeltFoot() {
    std::ifstream stream(kRoot / "robots" / "ks21.urdf");
    std::stringstream text;
    text << stream.rdbuf();
    std::string urdf = text.str();
    const std::string mark = "<pressure_sensor name=\"pressure_left\" sole=\"sole_left\"/>";
    urdf.replace(urdf.find(mark), mark.size(),
                 "<touch_sensor name=\"toes\" threshold=\"2\"/><force_sensor name=\"ankle\"/>");
    std::ofstream(file_) << urdf;
  }
  ~FeltFoot() override { fs::remove(file_); }
  fs::path file_ = fs::temp_directory_path() / fmt::format("murosimf_felt_{}.urdf", ::getpid());
};

TEST_F(FeltFoot, IsFeltByControlSoftwareAtLevelFull) {
  Port port(robot("level = \"full\"\nmodules.force_errors = {offset = 5}\nmodules.touch_errors = {delay = 0.01}\n",
                  file_.string()));
  const client::SensorFrame sensors = port.after(300);
  ASSERT_EQ(sensors.touches.size(), 1U);
  EXPECT_EQ(sensors.touches[0], 1);
  const Vector3 felt = port.simulation->linked()
                           .handle(port.simulation->world().find("robots.red.1"), kSensedForce, subset::kForceSensors)
                           .get();
  EXPECT_GT(felt.z, 5) << "about half of the robot's weight";
  ASSERT_EQ(sensors.forces.size(), 1U);
  EXPECT_EQ(sensors.forces[0], felt + (Vector3{5, 5, 5}));
}

TEST_F(FeltFoot, IsNotFeltByAKinematicRobot) {
  Port port(robot("level = \"kinematic\"\n", file_.string()));
  const client::SensorFrame sensors = port.after(100);
  EXPECT_EQ(sensors.touches[0], 0);
  EXPECT_EQ(sensors.forces[0], Vector3{});
}

TEST(Sensors, ABumperFeelsTheBallThatFliesAgainstIt) {
  const fs::path file = fs::temp_directory_path() / fmt::format("murosimf_bumper_{}.urdf", ::getpid());
  std::ofstream(file)
      << R"(<robot name="cart"><murosimf surface="plastic"/><link name="cart"><inertial><mass value="20"/>
    <inertia ixx="1" iyy="1" izz="1"/></inertial><collision><geometry><box size="0.4 0.4 0.3"/></geometry></collision>
    </link><link name="bumper"><collision><geometry><box size="0.02 0.4 0.2"/></geometry></collision>
    <murosimf><touch_sensor name="toes"/></murosimf></link><joint name="screw" type="fixed"><parent link="cart"/>
    <child link="bumper"/><origin xyz="0.21 0 0"/></joint></robot>)";
  Port port(
      "[referee]\nenabled = false\n[ball]\nposition = [1, 0]\n[robots.red.1]\npose = [0, 0, 0]\nlevel = \"full\"\n"
      "actuation = \"none\"\nelectronics = \"none\"\nlimits = \"none\"\nsensing = \"none\"\nfile = \"" +
      file.string() + "\"\n");
  const ObjectId ball = port.simulation->world().find("ball");
  port.simulation->interventions().placeBody(0, ball, {0.40, 0, 0.15}, {-1, 0, 0});  // flies
  int pressed = 0, first = -1;
  for (int k = 0; k < 300; ++k) {
    if (port.after(1).touches[0] == 0) continue;
    ++pressed;
    if (first < 0) first = k;
  }
  EXPECT_NEAR(first, 110, 2) << "0.11 m at 1 m/s";
  EXPECT_GT(pressed, 2);
  EXPECT_LT(pressed, 60);
  EXPECT_GT(port.simulation->linked().handle(ball, kBodyVelocity).get().x, 0.3) << "it was to bounce";
  fs::remove(file);
}

TEST_F(FeltFoot, TouchErrorsKnowDelayAndRateAlone) {
  const std::vector<std::string> said =
      BuiltWorld(robot("level = \"full\"\nmodules.touch_errors = {noise = 1}\n", file_.string())).complaints();
  ASSERT_EQ(said.size(), 1U);
  EXPECT_NE(said[0].find("module touch_errors has no parameter \"noise\"; it knows period, delay, rate"),
            std::string::npos)
      << said[0];
}

}  // namespace
}  // namespace murosimf::test
