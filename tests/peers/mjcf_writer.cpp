#include "peers/mjcf_writer.h"

#include <fmt/format.h>

#include <array>
#include <iterator>

namespace murosimf::peers {

namespace {

std::string text(const Vector3& v) { return fmt::format("{} {} {}", v.x, v.y, v.z); }

std::string place(const Pose& X) {
  return fmt::format("pos=\"{}\" xyaxes=\"{} {}\"", text(X.translation), text(X.rotation.x), text(X.rotation.y));
}

class Writer {
 public:
  explicit Writer(const PeerScene& scene) : scene_(scene), robot_(scene.robot) {}

  std::string write() {
    add("<mujoco><compiler angle=\"radian\" coordinate=\"local\"/>");
    add("<option timestep=\"{}\" gravity=\"0 0 -9.81\"/><size njmax=\"100\" nconmax=\"20\"/>", scene_.step);
    add("<worldbody><geom type=\"plane\" size=\"0 0 1\" contype=\"1\" conaffinity=\"0\" friction=\"{} 0.005 0.0001\"/>",
        scene_.friction);
    body(0);
    add("</worldbody><actuator>");
    for (std::size_t j = 0; scene_.servos && j < robot_.model.tree.joints.size(); ++j) actuator(j);
    add("</actuator><sensor>");
    for (const char* kind : {"jointpos", "jointvel"}) {
      for (std::size_t j = 0; j < robot_.model.tree.joints.size(); ++j) add("<{} joint=\"joint{}\"/>", kind, j);
    }
    if (!robot_.model.imus.empty()) add("<gyro site=\"imu\"/><accelerometer site=\"imu\"/>");
    add("</sensor></mujoco>");
    return std::move(out_);
  }

 private:
  template <class... Values>
  void add(fmt::format_string<Values...> form, Values&&... values) {
    fmt::format_to(std::back_inserter(out_), form, std::forward<Values>(values)...);
    out_ += '\n';
  }
  void body(std::size_t row) {
    const TreeRow& place_on_parent = robot_.flat.table.rows[row];
    add("<body name=\"body{}\" {}>", row, place(row == 0 ? Pose{} : place_on_parent.X_PF));
    if (row == 0) {
      add("<freejoint/>");
    } else {
      joint(row, place_on_parent);
    }
    inertia(robot_.flat.row_mass[row]);
    carried(static_cast<int>(row));
    for (std::size_t child = row + 1; child < robot_.flat.table.rows.size(); ++child) {
      if (robot_.flat.table.rows[child].parent == static_cast<int>(row)) body(child);
    }
    add("</body>");
  }
  void joint(std::size_t row, const TreeRow& tree_row) {
    constexpr std::array<const char*, 3> kAxes = {"1 0 0", "0 1 0", "0 0 1"};
    const Joint& j = robot_.model.tree.joints[row - 1];
    add("<joint name=\"joint{}\" type=\"{}\" axis=\"{}\" armature=\"{}\" damping=\"{}\"/>", row - 1,
        tree_row.kind == JointKind::kPrismatic ? "slide" : "hinge", kAxes[static_cast<std::size_t>(tree_row.axis)],
        j.servo ? j.servo->armature : 0.0, j.damping);
  }
  void inertia(const MassProperties& m) {
    const SymmetricMatrix& I = m.I_C_B;
    add("<inertial pos=\"{}\" mass=\"{}\" fullinertia=\"{} {} {} {} {} {}\"/>", text(m.p_BC_B), m.mass, I.xx, I.yy,
        I.zz, I.xy, I.xz, I.yz);
  }
  /// Sole boxes and the inertial unit on a row.
  void carried(int row) {
    for (const Sole& sole : robot_.model.soles) {
      const RowPlace box = soleBox(robot_, sole);
      if (box.row != row) continue;
      add("<geom type=\"box\" size=\"{} {} {}\" {} contype=\"0\" conaffinity=\"1\" friction=\"{} 0.005 0.0001\"/>",
          sole.length / 2, sole.width / 2, kSoleThickness / 2, place(box.X_RB), scene_.friction);
    }
    if (robot_.model.imus.empty()) return;
    const ImuMount& imu = robot_.model.imus.front();
    const RowPlace& mount = robot_.flat.bodies[static_cast<std::size_t>(imu.body)];
    if (mount.row == row) add("<site name=\"imu\" {}/>", place(mount.X_RB * imu.X_BI));
  }
  void actuator(std::size_t j) {
    const Joint& joint = robot_.model.tree.joints[j];
    const ServoParameters servo = joint.servo.value_or(ServoParameters{});
    add("<general joint=\"joint{}\" gainprm=\"{}\" biastype=\"affine\" biasprm=\"0 {} {}\" forcelimited=\"true\" "
        "forcerange=\"{} {}\"/>",
        j, servo.kp, -servo.kp, -servo.kd, -servo.stall_torque, servo.stall_torque);
  }

  const PeerScene& scene_;
  const RobotBlueprint& robot_;
  std::string out_;
};

}  // namespace

std::string mjcfOf(const PeerScene& scene) { return Writer(scene).write(); }

}  // namespace murosimf::peers
