#pragma once

/// @file A board with an inertial measurement unit on the bus: gyroscope, accelerometer, orientation.
///
/// Rates and accelerations are cut to the range that is set, and told in steps of range/32768, as the BMI088 on the
/// board counts (Bosch, data sheet BMI088). Orientation is a complementary filter's: turned by the rates, then by the
/// share `accelerometer gain` of what brings the measured upward direction up. Heading starts at 0 and drifts.
/// [Valenti, Dryanovski, Xiao 2015]; registers as in bit-bots' firmware (control_table.h).

#include "murosimf/control/client/robot_frames.h"
#include "murosimf/control/servo_bus/device.h"

namespace murosimf::servo_bus {

class ImuBoard {
 public:
  /// @param dt  time since the last call [s]
  void sense(Device& device, const client::ImuReading& reading, double dt);
  void archive(StateArchive& archive) { archive(q_, started_); }

 private:
  struct Quaternion {
    double w = 1, x = 0, y = 0, z = 0;
  };
  static Quaternion product(const Quaternion& a, const Quaternion& b);
  static Quaternion unit(const Quaternion& q);
  static Vector3 turned(const Quaternion& q, const Vector3& v);
  void turn(const Vector3& rate, double dt);
  void straighten(const Vector3& specific_force, double gain);

  Quaternion q_;  ///< turns the board's axes into those of a level frame
  bool started_ = false;
};

}  // namespace murosimf::servo_bus
