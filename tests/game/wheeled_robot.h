#pragma once

/// @file A scenario with robots on wheels, whose wheels a test turns, or control software.

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "cart/cart.h"
#include "murosimf/modules/motion/wheeled_kinematics.h"
#include "scene/built_world.h"

namespace murosimf::test {

/// What the test commands, and what the robot's software was told last.
struct Wires {
  std::vector<client::JointCommand> commands;
  client::RobotDescription description;
  std::vector<std::uint8_t> touches;
  std::map<int, std::vector<double>> scans;
  std::map<int, double> scan_times;
  int scans_told = 0;
};

class WiredProgram final : public client::ControlSoftware {
 public:
  explicit WiredProgram(std::shared_ptr<Wires> wires) : wires_(std::move(wires)) {}
  void start(const client::RobotDescription& robot) override { wires_->description = robot; }
  void step(const client::SensorFrame& sensors, client::CommandFrame& commands) override {
    if (!wires_->commands.empty()) commands.joints = wires_->commands;
    wires_->touches.assign(sensors.touches.begin(), sensors.touches.end());
    for (const client::RangeScan& scan : sensors.scans) {
      wires_->scans[scan.sensor].assign(scan.ranges.begin(), scan.ranges.end());
      wires_->scan_times[scan.sensor] = scan.time;
      ++wires_->scans_told;
    }
  }
  const client::ControlReport& report() const override { return report_; }
  void archive(StateArchive&) override {}

 private:
  std::shared_ptr<Wires> wires_;
  client::ControlReport report_;
};

inline double wrappedAngle(double angle) { return controllers::cart::wrapped(angle); }

inline std::string wheeled(const std::string& file, const std::string& more = "",
                           const std::string& pose = "[0, 0, 0]") {
  return fmt::format(
      "[referee]\nenabled = false\n[ball]\npresent = false\n[robots.red.1]\nfile = \"robots/{}.urdf\"\npose = {}\n"
      "control = \"wired\"\ncameras.eye = \"none\"\n{}\n",
      file, pose, more);
}

struct WheeledRobot {
  explicit WheeledRobot(const std::string& text, const std::vector<std::string>& overrides = {},
                        const std::string& path = "robots.red.1")
      : wires(std::make_shared<Wires>()), built(text, overrides) {
    simulation = built.builder.link(allModules(), programs());
    EXPECT_EQ(built.diagnostics.text(), "");
    robot = simulation->world().find(path);
  }
  ~WheeledRobot() { simulation->control()->finish(); }
  WheeledRobot(const WheeledRobot&) = delete;
  WheeledRobot& operator=(const WheeledRobot&) = delete;

  ControlPrograms programs() {
    return {{"wired", [w = wires] { return std::make_unique<WiredProgram>(w); }},
            {"cart", [] { return controllers::cart::makeCart(); }}};
  }
  /// Rates of all wheels [rad/s], in the order of joints.
  void turn(const std::vector<double>& rates) {
    wires->commands.clear();
    for (const double rate : rates) wires->commands.push_back({0, rate, 0, 0, 0.05});
  }
  void run(double seconds) {
    for (long i = std::lround(seconds / simulation->frameLength()); i > 0; --i) simulation->step();
    simulation->control()->finish();
  }
  Pose base() const { return simulation->linked().handle(robot, kBasePose).get(); }
  double heading() const { return atan2(base().rotation.x.y, base().rotation.x.x); }
  SpatialMotion<double> velocity() const { return simulation->linked().handle(robot, kBaseVelocity).get(); }
  double load(int wheel) const { return simulation->linked().handle(robot, kWheelLoad, subset::kWheels).get(wheel); }
  double mass() const { return *simulation->world().find(robot, kMass); }

  std::shared_ptr<Wires> wires;
  BuiltWorld built;
  std::unique_ptr<Simulation> simulation;
  ObjectId robot;
};

}  // namespace murosimf::test
