// A whole robot whose servos have direct-current motors, in free flight.

#include <gtest/gtest.h>

#include "modules/motion_world.h"
#include "murosimf/modules/actuation/motor_properties.h"
#include "murosimf/scene/servo_builder.h"

namespace murosimf::motion {
namespace {

class MotorRobots {
 public:
  MotorRobots(const std::vector<std::string>& servo_files, int lanes) {
    ServoBuilder servos(diagnostics_);
    for (std::size_t i = 0; i < servo_files.size(); ++i) {
      robots_.push_back(addRobot(world_, "r" + std::to_string(i), ks21(), Colour{}));
      const std::string folder = MUROSIMF_SOURCE_DIR "/robots/servos/";
      world_.set(robots_[i], kServoFile, folder + servo_files[i]);
      servos.apply(world_, robots_[i], "");
    }
    static const OutsideAccess driver([](Declaration& d) { d.adds(kJointCommand, subset::kJoints); });
    Linker linker(world_, registry_, LinkOptions{1e-3, lanes});
    for (const ObjectId robot : robots_) {
      for (const char* module : {"servo_controller", "dc_motor", "gear_load", "joint_limits", "joint_friction",
                                 "tree_motion", "multibody_dynamics", "implicit_euler"}) {
        linker.assign({robot, module, {}, {}});
      }
    }
    linker.attach({"driver", &driver, robots_});
    linked_ = linker.link(diagnostics_);
    if (linked_ == nullptr) throw std::runtime_error(diagnostics_.text());
  }
  void command(std::size_t i, const std::vector<double>& q) {
    auto commands = linked_->handle(robots_[i], kJointCommand, subset::kJoints);
    for (std::size_t j = 0; j < q.size(); ++j) commands.set({q[j], 0, 0, 1, 0}, static_cast<int>(j));
  }
  void run(int steps) {
    for (int i = 0; i < steps; ++i) linked_->runFrame(frame_++);
  }
  std::vector<double> positions(std::size_t i) {
    std::vector<double> found;
    const auto q = linked_->handle(robots_[i], kJointPosition, subset::kJoints);
    for (int j = 0; j < q.size(); ++j) found.push_back(q.get(j));
    return found;
  }

 private:
  World world_;
  ModuleRegistry registry_ = allModules();
  Diagnostics diagnostics_;
  std::vector<ObjectId> robots_;
  std::unique_ptr<LinkedWorld> linked_;
  long frame_ = 0;
};

TEST(MotorRobot, TakesItsPoseInTheAirUpToWhatFrictionKeeps) {
  MotorRobots robots({"mx64_m4.json"}, 1);
  const std::vector<double> wanted = gait(0, controllers::WalkCommand{});
  robots.command(0, wanted);
  robots.run(600);
  const std::vector<double> found = robots.positions(0);
  const double stiffness = 1.6632 / 3.156 * 15 * 0.158 * 32;
  for (std::size_t j = 0; j < found.size(); ++j) {
    EXPECT_NEAR(found[j], wanted[j], 1.01 * (0.0615 + 0.0239) / (1 - 0.2343) / stiffness) << j;
  }
}

TEST(MotorRobot, LanesWithUnlikeServosEqualScalarBitForBit) {
  const std::vector<std::string> files{"mx64_m4.json", "mx106_m1.json", "mx106_m4.json", "mx64_m1.json"};
  MotorRobots together(files, 4);
  const auto drive = [](MotorRobots& robots, std::size_t i, double phase) {
    robots.command(i, gait(phase, controllers::WalkCommand{}));
    robots.run(150);
  };
  for (std::size_t i = 0; i < 4; ++i) together.command(i, gait(0.1 * static_cast<double>(i), {}));
  together.run(150);
  for (std::size_t i = 0; i < 4; ++i) {
    MotorRobots alone({files[i]}, 1);
    drive(alone, 0, 0.1 * static_cast<double>(i));
    EXPECT_EQ(alone.positions(0), together.positions(i)) << i;
  }
}

}  // namespace
}  // namespace murosimf::motion
