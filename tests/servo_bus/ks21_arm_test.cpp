// A program that knows nothing but ROBOTIS' manual moves an arm of KS21 over the terminal, through the whole
// simulation.

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <thread>

#include "murosimf/control/servo_bus/servo_bus.h"
#include "scene/built_world.h"

namespace murosimf::servo_bus {
namespace {

const std::string kScenario = R"(
[robots.red.1]
file = "robots/ks21.urdf"
pose = [0, 0, 0]
level = "full"
control = "servo_bus"
)";

/// A servo for each joint, ids from 1 on in the order of the robot file; the knees have stronger ones.
ServoBusSettings wholeRobot(const client::RobotDescription& robot) {
  ServoBusSettings settings;
  settings.link = ::testing::TempDir() + "murosimf_ks21_" + std::to_string(::getpid());
  settings.torque_on = true;
  int id = 0;
  for (const client::JointDescription& joint : robot.joints) {
    ServoSettings servo;
    servo.id = ++id, servo.joint = joint.name;
    servo.model = joint.name.starts_with("knee") ? "MX-106" : "MX-64";
    settings.servos.push_back(servo);
  }
  settings.imus.push_back({});
  return settings;
}

/// Steps in wall-clock time until the command has ended. @returns its exit status
int runBeside(Simulation& simulation, const std::string& command) {
  std::atomic<bool> done{false};
  int status = -1;
  std::thread program([&] {
    status = std::system(command.c_str());
    done = true;
  });
  auto next = std::chrono::steady_clock::now();
  while (!done) {
    simulation.step();
    next = std::max(next + std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                               std::chrono::duration<double>(simulation.frameLength())),
                    std::chrono::steady_clock::now() - std::chrono::milliseconds(5));
    std::this_thread::sleep_until(next);
  }
  program.join();
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(ServoBusRobot, AProgramWrittenFromTheManualMovesTheArmOfASimulatedKs21) {
  test::BuiltWorld built(kScenario);
  const client::RobotDescription robot = built.builder.describe(built.scene.robots.at(0));
  const ServoBusSettings settings = wholeRobot(robot);
  const auto simulation = built.builder.link(allModules(), {{"servo_bus", [&] { return makeServoBus(settings); }}});
  ASSERT_EQ(built.diagnostics.text(), "");
  simulation->step();  // starts the program, and with it the terminal
  EXPECT_EQ(runBeside(*simulation, "python3 examples/servo_bus/move_arm.py " + settings.link), 0);
  simulation->control()->finish();
  EXPECT_EQ(simulation->control()->counts().failed_programs, 0);
  const Handle<double> angles =
      simulation->linked().handle(simulation->world().find("robots.red.1"), kJointPosition, subset::kJoints);
  const auto angleOf = [&](const std::string& name) {
    const auto joint =
        std::find_if(robot.joints.begin(), robot.joints.end(), [&](const auto& j) { return j.name == name; });
    return angles.get(static_cast<int>(joint - robot.joints.begin()));
  };
  EXPECT_NEAR(angleOf("shoulder_pitch_right"), -1.0, 0.05);
  EXPECT_NEAR(angleOf("elbow_right"), -0.8, 0.05);
}

}  // namespace
}  // namespace murosimf::servo_bus
