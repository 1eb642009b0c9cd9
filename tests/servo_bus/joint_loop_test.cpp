// Registers move the joints of a control loop, and read where these are.

#include <thread>

#include "control/controlled_world.h"
#include "servo_bus/terminal_client.h"

namespace murosimf::servo_bus {
namespace {

using ::murosimf::testing::ControlledWorld;
using ::murosimf::testing::kFrame;

/// A box whose pan and tilt follow the bus; the test is the program at the terminal, between two frames.
struct BoxOnTheBus {
  explicit BoxOnTheBus(const std::string& name) {
    ControlledRobot robot = world.controlled(0, [](auto&...) {});
    client::RobotDescription description = robot.port.description();
    description.joints[0].name = "pan", description.joints[1].name = "tilt";
    const ServoBusSettings settings = twoServos(name);
    link = settings.link;
    robot.port = RobotPort(*world.linked, world.robots[0], description);
    robot.program = makeServoBus(settings);
    std::vector<ControlledRobot> robots;
    robots.push_back(std::move(robot));
    loop = std::make_unique<ControlLoop>(std::move(robots), *world.view, ControlTiming{10, 0, false, 1}, kFrame);
    loop->start();
    run(0.02);
  }
  void run(double seconds) {
    for (const long end = frame + std::lround(seconds / kFrame); frame < end; ++frame) world.runFrame(*loop, frame);
  }
  /// Sends a write to servo 1 and waits for its answer.
  void put(int address, int value, int size) {
    Bytes parameters = {static_cast<std::uint8_t>(address), 0}, packet;
    for (int i = 0; i < size; ++i) parameters.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
    appendInstruction(Protocol::k2, 1, 3, parameters, packet);
    TerminalClient client(link);
    client.send(packet);
    EXPECT_EQ(text(client.receive()), "FF FF FD 00 01 04 00 55 00 A1 0C");
  }
  int position() {
    TerminalClient client(link);
    client.send(bytes("FF FF FD 00 01 07 00 02 84 00 04 00 1D 15"));
    const Bytes answer = client.receive();
    return answer.size() == 15 ? answer[9] + 256 * answer[10] : -1;
  }

  ControlledWorld world{{"robots.red.1"}};
  std::string link;
  std::unique_ptr<ControlLoop> loop;
  long frame = 0;
};

TEST(ServoBusJoints, AJointGoesWhereTheGoalRegisterSaysAndStaysWhenTorqueIsOff) {
  BoxOnTheBus box("loop_goal");
  box.put(116, 3000, 4);
  box.run(0.1);
  EXPECT_EQ(box.world.joint(0), 0) << "torque is off";
  box.put(64, 1, 1), box.put(116, 3000, 4);
  box.run(0.1);
  EXPECT_NEAR(box.world.joint(0), angleOf(3000 - 2048), 1e-12);
  EXPECT_EQ(box.position(), 3000);
  box.put(64, 0, 1);
  box.run(0.02);
  box.put(116, 1000, 4);
  box.run(0.1);
  EXPECT_NEAR(box.world.joint(0), angleOf(3000 - 2048), 1e-12);
}

TEST(ServoBusJoints, TheProfilesVelocityIsTheJoints) {
  BoxOnTheBus box("loop_profile");
  box.put(64, 1, 1), box.put(112, 60, 4), box.put(116, 4000, 4);
  box.run(0.05);
  const double before = box.world.joint(0);
  box.run(0.5);
  const double speed = 60 * 0.229 * 2 * 3.14159265358979 / 60;
  EXPECT_NEAR(box.world.joint(0) - before, 0.5 * speed, 1e-9);
  EXPECT_NEAR(angleOf(box.position() - 2048), box.world.joint(0), speed * 0.01 + angleOf(1)) << "one period old";
}

TEST(ServoBusJoints, VelocityControlTurnsTheJointOnAndOn) {
  BoxOnTheBus box("loop_velocity");
  box.put(11, 1, 1), box.put(64, 1, 1), box.put(104, 100, 4);
  box.run(0.05);
  const double before = box.world.joint(0);
  box.run(1.0);
  EXPECT_NEAR(box.world.joint(0) - before, 100 * 0.229 * 2 * 3.14159265358979 / 60, 1e-9);
  box.put(104, 0, 4);
  box.run(0.05);
  const double stopped = box.world.joint(0);
  box.run(0.2);
  EXPECT_EQ(box.world.joint(0), stopped);
}

}  // namespace
}  // namespace murosimf::servo_bus
