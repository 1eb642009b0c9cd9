#include "peers/mjcf_writer.h"

#include <fmt/format.h>

#include <array>
#include <iterator>

#include "peers/mjcf_geoms.h"

namespace murosimf::peers {

namespace {

std::string text(const Vector3& v) { return fmt::format("{} {} {}", v.x, v.y, v.z); }

/// What a text says besides robots and geoms.
struct Frame {
  int robots = 1;
  double step = 1e-3;
  bool servos = true;
  int most_contacts = 20;
  int most_constraints = 100;
};

class Writer {
 public:
  Writer(const RobotBlueprint& robot, const MjcfGeoms& geoms, const Frame& frame)
      : robot_(robot), geoms_(geoms), frame_(frame) {}

  std::string write() {
    add("<mujoco><compiler angle=\"radian\" coordinate=\"local\"/>");
    add("<option timestep=\"{}\" gravity=\"0 0 -9.81\"/><size njmax=\"{}\" nconmax=\"{}\"/>", frame_.step,
        frame_.most_constraints, frame_.most_contacts);
    add("<worldbody>{}", geoms_.ground());
    forRobots([&] { body(0); });
    add("</worldbody><actuator>");
    forRobots([&] {
      for (std::size_t j = 0; frame_.servos && j < joints(); ++j) actuator(j);
    });
    add("</actuator><sensor>");
    forRobots([&] { sensors(); });
    add("</sensor></mujoco>");
    return std::move(out_);
  }

 private:
  template <class... Values>
  void add(fmt::format_string<Values...> form, Values&&... values) {
    fmt::format_to(std::back_inserter(out_), form, std::forward<Values>(values)...);
    out_ += '\n';
  }
  template <class Visit>
  void forRobots(Visit&& visit) {
    for (number_ = 0; number_ < frame_.robots; ++number_) visit();
  }
  std::size_t joints() const { return robot_.model.tree.joints.size(); }
  void body(std::size_t row) {
    const TreeRow& place_on_parent = robot_.flat.table.rows[row];
    add("<body name=\"robot{}_body{}\" {}>", number_, row, mjcfPlace(row == 0 ? Pose{} : place_on_parent.X_PF));
    if (row == 0) {
      add("<freejoint name=\"robot{}_base\"/>", number_);
    } else {
      joint(row, place_on_parent);
    }
    inertia(robot_.flat.row_mass[row]);
    add("{}", geoms_.onRow(number_, static_cast<int>(row)));
    inertialUnit(static_cast<int>(row));
    for (std::size_t child = row + 1; child < robot_.flat.table.rows.size(); ++child) {
      if (robot_.flat.table.rows[child].parent == static_cast<int>(row)) body(child);
    }
    add("</body>");
  }
  void joint(std::size_t row, const TreeRow& tree_row) {
    constexpr std::array<const char*, 3> kAxes = {"1 0 0", "0 1 0", "0 0 1"};
    const Joint& j = robot_.model.tree.joints[row - 1];
    add("<joint name=\"robot{}_joint{}\" type=\"{}\" axis=\"{}\" armature=\"{}\" damping=\"{}\"/>", number_, row - 1,
        tree_row.kind == JointKind::kPrismatic ? "slide" : "hinge", kAxes[static_cast<std::size_t>(tree_row.axis)],
        j.servo ? j.servo->armature : 0.0, j.damping);
  }
  void inertia(const MassProperties& m) {
    const SymmetricMatrix& I = m.I_C_B;
    add("<inertial pos=\"{}\" mass=\"{}\" fullinertia=\"{} {} {} {} {} {}\"/>", text(m.p_BC_B), m.mass, I.xx, I.yy,
        I.zz, I.xy, I.xz, I.yz);
  }
  void inertialUnit(int row) {
    if (robot_.model.imus.empty()) return;
    const ImuMount& imu = robot_.model.imus.front();
    const RowPlace& mount = robot_.flat.bodies[static_cast<std::size_t>(imu.body)];
    if (mount.row == row) add("<site name=\"robot{}_imu\" {}/>", number_, mjcfPlace(mount.X_RB * imu.X_BI));
  }
  void actuator(std::size_t j) {
    const Joint& joint = robot_.model.tree.joints[j];
    const ServoParameters servo = joint.servo.value_or(ServoParameters{});
    add("<general joint=\"robot{}_joint{}\" gainprm=\"{}\" biastype=\"affine\" biasprm=\"0 {} {}\" "
        "forcelimited=\"true\" forcerange=\"{} {}\"/>",
        number_, j, servo.kp, -servo.kp, -servo.kd, -servo.stall_torque, servo.stall_torque);
  }
  void sensors() {
    for (const char* kind : {"jointpos", "jointvel"}) {
      for (std::size_t j = 0; j < joints(); ++j) add("<{} joint=\"robot{}_joint{}\"/>", kind, number_, j);
    }
    if (!robot_.model.imus.empty()) add("<gyro site=\"robot{0}_imu\"/><accelerometer site=\"robot{0}_imu\"/>", number_);
  }

  const RobotBlueprint& robot_;
  const MjcfGeoms& geoms_;
  const Frame frame_;
  int number_ = 0;  // of the robot being written
  std::string out_;
};

}  // namespace

std::string mjcfOf(const PeerScene& scene) {
  const SoleGeoms geoms(scene);
  return Writer(scene.robot, geoms, {.step = scene.step, .servos = scene.servos}).write();
}

std::string mjcfOf(const PeerHeap& heap) {
  // Room for three times what heaps of ten robots came to; a pyramid's contact takes four constraints.
  constexpr int kContactsPerRobot = 100, kConstraintsPerContact = 4;
  const int contacts = kContactsPerRobot * heap.robots;
  const HeapGeoms geoms(heap);
  return Writer(heap.robot, geoms,
                {.robots = heap.robots,
                 .step = heap.step,
                 .most_contacts = contacts,
                 .most_constraints = kConstraintsPerContact * contacts})
      .write();
}

}  // namespace murosimf::peers
