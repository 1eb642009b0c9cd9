// Robots of other teams stand at every level of detail when their servos hold a posture, and tell what they feel.

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <memory>

#include "scene/built_world.h"

namespace murosimf::test {
namespace {

/// What a control program was told last.
struct Heard {
  client::RobotDescription description;
  std::vector<client::ImuReading> imus;
  std::vector<std::array<double, 4>> pressures;
  std::vector<std::uint8_t> touches;
  Vector3 rate, force;
};

/// Holds all joints where they were at first.
class Hold final : public client::ControlSoftware {
 public:
  explicit Hold(std::shared_ptr<Heard> heard) : heard_(std::move(heard)) {}
  void start(const client::RobotDescription& robot) override { heard_->description = robot; }
  void step(const client::SensorFrame& sensors, client::CommandFrame& commands) override {
    if (held_.empty()) {
      for (const client::JointReading& joint : sensors.joints) held_.push_back(joint.position);
    }
    for (std::size_t i = 0; i < held_.size(); ++i) commands.joints[i] = {held_[i], 0, 0, 1, 0};
    heard_->imus.assign(sensors.imus.begin(), sensors.imus.end());
    heard_->pressures.assign(sensors.sole_pressures.begin(), sensors.sole_pressures.end());
    heard_->touches.assign(sensors.touches.begin(), sensors.touches.end());
    heard_->rate = sensors.angular_velocity, heard_->force = sensors.specific_force;
  }
  const client::ControlReport& report() const override { return report_; }
  void archive(StateArchive&) override {}

 private:
  std::shared_ptr<Heard> heard_;
  std::vector<double> held_;
  client::ControlReport report_;
};

/// Holds all joints but the head's first, which it turns from one side to the other, and keeps its largest rate.
class ShakeHead final : public client::ControlSoftware {
 public:
  explicit ShakeHead(std::shared_ptr<double> fastest) : fastest_(std::move(fastest)) {}
  void start(const client::RobotDescription& robot) override {
    while (robot.joints[head_].name != "head_pan") ++head_;
    side_ = 0.9 * std::min(robot.joints[head_].upper, 2.5);
  }
  void step(const client::SensorFrame& sensors, client::CommandFrame& commands) override {
    if (held_.empty()) {
      for (const client::JointReading& joint : sensors.joints) held_.push_back(joint.position);
    }
    held_[head_] = sensors.time < 2 ? -side_ : side_;
    for (std::size_t i = 0; i < held_.size(); ++i) commands.joints[i] = {held_[i], 0, 0, 1, 0};
    if (sensors.time > 1.9) *fastest_ = std::max(*fastest_, sensors.joints[head_].velocity);
  }
  const client::ControlReport& report() const override { return report_; }
  void archive(StateArchive&) override {}

 private:
  std::shared_ptr<double> fastest_;
  std::size_t head_ = 0;
  double side_ = 0;
  std::vector<double> held_;
  client::ControlReport report_;
};

std::string alone(const std::string& robot, const std::string& level, const std::string& more = "") {
  std::string text = fmt::format(
      "[referee]\nenabled = false\n[ball]\npresent = false\n[robots.red.1]\nfile = \"robots/{}.urdf\"\n"
      "pose = [0, 0, 0]\nlevel = \"{}\"\ncontrol = \"hold\"\n{}",
      robot, level, more);
  text += robot == "nugus"       ? "cameras = {left_camera = \"none\", right_camera = \"none\"}\n"
          : robot == "darwin_op" ? "cameras = {camera = \"none\", camera2 = \"none\"}\n"
                                 : "cameras = {camera = \"none\"}\n";
  return text;
}

/// A robot that holds its posture.
struct Standing {
  explicit Standing(const std::string& text) : built(text) {
    const ControlPrograms programs{{"hold", [shared = heard] { return std::make_unique<Hold>(shared); }},
                                   {"shake", [shared = fastest] { return std::make_unique<ShakeHead>(shared); }}};
    simulation = built.builder.link(allModules(), programs);
    EXPECT_EQ(built.diagnostics.text(), "");
  }
  void run(double seconds) {
    for (int i = 0; i < std::lround(1000 * seconds); ++i) simulation->step();
  }
  Pose base() { return simulation->linked().handle(simulation->world().find("robots.red.1"), kBasePose).get(); }
  std::shared_ptr<Heard> heard = std::make_shared<Heard>();
  std::shared_ptr<double> fastest = std::make_shared<double>(0.0);
  BuiltWorld built;
  std::unique_ptr<Simulation> simulation;
};

class GuestAtALevel : public testing::TestWithParam<std::tuple<const char*, const char*>> {};

TEST_P(GuestAtALevel, StandsForFiveSecondsWhereItWasPut) {
  const auto& [robot, level] = GetParam();
  Standing standing(alone(robot, level));
  standing.run(0.01);
  const Pose before = standing.base();
  standing.run(5);
  const Pose after = standing.base();
  EXPECT_GT(after.rotation.z.z, 0.995) << "it leans or lies";
  EXPECT_LT(norm(after.translation - before.translation), 0.02);
  EXPECT_NEAR(norm(standing.heard->force), 9.81, 0.05);
  EXPECT_LT(norm(standing.heard->rate), 0.05) << "it sways";
}

INSTANTIATE_TEST_SUITE_P(Guests, GuestAtALevel,
                         testing::Combine(testing::Values("darwin_op", "wolfgang", "nugus"),
                                          testing::Values("kinematic", "fast", "full")),
                         [](const auto& made) {
                           return std::string(std::get<0>(made.param)) + "_" + std::get<1>(made.param);
                         });

TEST(GuestRobots, StandOnServosThatRubAtTheirLimitsToo) {
  for (const char* robot : {"darwin_op", "wolfgang", "nugus"}) {
    Standing standing(alone(robot, "full", "modules = {joint_limits = {}, joint_friction = {}}\n"));
    standing.run(5);
    EXPECT_GT(standing.base().rotation.z.z, 0.995) << robot;
  }
}

TEST(GuestRobots, TurnTheirHeadsAsFastAsThePublishedServosWhenTheyRub) {
  const std::vector<std::pair<const char*, double>> published{{"darwin_op", 5.24}, {"wolfgang", 8.17}, {"nugus", 8.17}};
  for (const auto& [robot, speed] : published) {
    std::string text = alone(robot, "full", "modules = {joint_friction = {}}\n");
    text.replace(text.find("\"hold\""), 6, "\"shake\"");
    Standing shaking(text);
    shaking.run(4);
    EXPECT_GT(*shaking.fastest, 0.97 * speed) << robot;
    EXPECT_LT(*shaking.fastest, 1.07 * speed) << robot;
  }
}

TEST(GuestRobots, OfTheScenarioStandWhereTheyWerePutThoughNobodyControlsThem) {
  std::ifstream file(kRoot / "scenarios" / "guests.toml");
  BuiltWorld built(std::string(std::istreambuf_iterator<char>(file), {}));
  const std::unique_ptr<Simulation> simulation = built.simulation();
  const std::vector<std::string> robots{"robots.red.1", "robots.red.2", "robots.blue.1"};
  std::vector<Pose> before;
  const auto base = [&](const std::string& robot) {
    return simulation->linked().handle(simulation->world().find(robot), kBasePose).get();
  };
  simulation->step();
  for (const std::string& robot : robots) before.push_back(base(robot));
  for (int i = 0; i < 5000; ++i) simulation->step();
  for (std::size_t i = 0; i < robots.size(); ++i) {
    EXPECT_GT(base(robots[i]).rotation.z.z, 0.999) << robots[i];
    EXPECT_LT(norm(base(robots[i]).translation - before[i].translation), 0.01) << robots[i];
  }
}

TEST(GuestSensors, CleatsOfWolfgangCarryItsWeightTogether) {
  Standing standing(alone("wolfgang", "full"));
  standing.run(3);
  double sum = 0;
  for (const std::array<double, 4>& sole : standing.heard->pressures) {
    for (const double corner : sole) sum += corner;
  }
  EXPECT_NEAR(sum, 6.117 * 9.81, 0.3);
}

TEST(GuestSensors, BumpersOfNUgusCloseWhereItStandsOnThem) {
  Standing standing(alone("nugus", "full"));
  standing.run(3);
  ASSERT_EQ(standing.heard->touches.size(), 8U);
  int closed = 0;
  for (const std::uint8_t touch : standing.heard->touches) closed += touch;
  EXPECT_GE(closed, 6) << "three studs of each foot carry it at least";
  for (const std::array<double, 4>& sole : standing.heard->pressures) {
    for (const double corner : sole) EXPECT_EQ(corner, 0) << "it stands on studs, not on its soles";
  }
}

TEST(GuestSensors, BothUnitsOfWolfgangReadEachWithErrorsOfItsOwn) {
  Standing plain(alone("wolfgang", "full"));
  Standing wrong(alone("wolfgang", "full",
                       "modules.gyroscope_errors = {noise = 0.1, offset = 3}\n"
                       "modules.accelerometer_errors = {noise = 0.5}\n"));
  plain.run(1), wrong.run(1);
  ASSERT_EQ(plain.heard->description.imus, (std::vector<std::string>{"imu", "imu_head"}));
  ASSERT_EQ(plain.heard->imus.size(), 2U);
  Vector3 errors[2];
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(norm(plain.heard->imus[i].specific_force), 9.81, 0.05);
    errors[i] = wrong.heard->imus[i].angular_velocity - plain.heard->imus[i].angular_velocity;
    EXPECT_LT(norm(errors[i] - Vector3{3, 3, 3}), 0.6);
    EXPECT_GT(norm(wrong.heard->imus[i].specific_force - plain.heard->imus[i].specific_force), 0.01);
  }
  EXPECT_GT(norm(errors[0] - errors[1]), 1e-3);
  EXPECT_EQ(plain.heard->rate, plain.heard->imus[0].angular_velocity);
  EXPECT_EQ(plain.heard->force, plain.heard->imus[0].specific_force);
}

TEST(GuestSensors, AreDescribedAsDevicesOfTheirParts) {
  Standing standing(alone("wolfgang", "kinematic"));
  const client::RobotDescription& told = standing.heard->description;
  standing.run(0.02);
  const auto find = [&](const std::string& name) {
    for (const client::DeviceDescription& device : told.devices) {
      if (device.name == name) return device;
    }
    return client::DeviceDescription{};
  };
  const auto index = [](int part) { return static_cast<std::size_t>(part); };
  EXPECT_EQ(told.joints[index(find("LKnee").part)].name, "knee_left");
  EXPECT_EQ(find("LKnee").kind, client::DeviceKind::kMotor);
  EXPECT_EQ(find("LKnee_sensor").kind, client::DeviceKind::kPositionSensor);
  EXPECT_EQ(told.imus[index(find("imu_head gyro").part)], "imu_head");
  EXPECT_EQ(find("imu_head gyro").kind, client::DeviceKind::kGyro);
  EXPECT_EQ(find("imu accelerometer").kind, client::DeviceKind::kAccelerometer);
  EXPECT_EQ(told.cameras[index(find("camera").part)].name, "camera");
  EXPECT_EQ(find("camera").kind, client::DeviceKind::kCamera);
  EXPECT_EQ(told.soles[index(find("llb").part)], "sole_left");
  EXPECT_EQ(find("llb").corner, 2);  // (-x +y)
  EXPECT_EQ(find("rrf").corner, 1);  // (+x -y)
  EXPECT_EQ(find("llb").kind, client::DeviceKind::kForce);
  EXPECT_EQ(find("imu gyro").highest, 34.90659);
}

}  // namespace
}  // namespace murosimf::test
