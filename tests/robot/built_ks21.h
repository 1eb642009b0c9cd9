#pragma once

/// @file KS21 once more, built in C++ from its table: a second writing of robots/ks21.urdf to compare with.

#include "murosimf/robot/tree_builder.h"

namespace murosimf::testing {

inline constexpr double kDegree = kPi / 180;

inline ServoParameters weakServo(const char* type) { return {type, 2.96, 7.12, 30, 0.416, 0.005, 0.00506}; }
inline ServoParameters kneeServo() { return {"RX-64", 4.24, 5.36, 45, 0.791, 0.005, 0.00506}; }

/// A turning joint with limits in degrees.
inline TreePlace turn(const TreePlace& place, const std::string& name, const Vector3& axis, double lower, double upper,
                      const ServoParameters& servo = weakServo("DX-117")) {
  return place.joint({.name = name,
                      .axis = axis,
                      .limits = {lower * kDegree, upper * kDegree, servo.no_load_speed, servo.stall_torque},
                      .damping = 0.01,
                      .servo = servo});
}

inline Body boxBody(const std::string& name, double mass, const Vector3& edges, const Vector3& centre) {
  return {.name = name, .mass = boxMass(mass, edges, centre)};
}

inline void addArm(const TreePlace& chest, const std::string& side, double s) {
  const TreePlace shoulder = turn(chest.translation({0, s * 0.075, 0.115}), "shoulder_pitch_" + side, kAxisY, -180, 180)
                                 .body(boxBody("shoulder_" + side, 0.02, {0.03, 0.03, 0.03}, {0, s * 0.01, 0}));
  const TreePlace upper =
      turn(shoulder.translation({0, s * 0.02, 0}), "shoulder_roll_" + side, kAxisX, s < 0 ? -120 : 0, s < 0 ? 0 : 120)
          .body(boxBody("upper_arm_" + side, 0.115, {0.045, 0.045, 0.09}, {0, 0, -0.045}));
  turn(upper.translation({0, 0, -0.09}), "elbow_" + side, kAxisY, -130, 0)
      .body(boxBody("forearm_" + side, 0.06, {0.03, 0.03, 0.13}, {0, 0, -0.075}));
}

inline void addLeg(const TreePlace& hips, const std::string& side, double s) {
  const double inwards = s < 0 ? -60 : -35, outwards = s < 0 ? 35 : 60;
  const TreePlace yaw = turn(hips.translation({0, s * 0.045, 0.03}), "hip_yaw_" + side, kAxisZ, -60, 60)
                            .body(boxBody("hip_" + side, 0.05, {0.045, 0.045, 0.03}, {}));
  const TreePlace roll = turn(yaw.translation({0, 0, -0.03}), "hip_roll_" + side, kAxisX, inwards, outwards)
                             .body(boxBody("groin_" + side, 0.14, {0.06, 0.045, 0.05}, {}));
  const TreePlace thigh = turn(roll, "hip_pitch_" + side, kAxisY, -110, 45)
                              .body(boxBody("thigh_" + side, 0.20, {0.05, 0.05, 0.10}, {0, 0, -0.0625}));
  const TreePlace shank = turn(thigh.translation({0, 0, -0.125}), "knee_" + side, kAxisY, 0, 135, kneeServo())
                              .body(boxBody("shank_" + side, 0.12, {0.045, 0.045, 0.10}, {0, 0, -0.0625}));
  const TreePlace ankle = turn(shank.translation({0, 0, -0.125}), "ankle_pitch_" + side, kAxisY, -70, 70)
                              .body(boxBody("ankle_" + side, 0.14, {0.06, 0.045, 0.05}, {}));
  turn(ankle, "ankle_roll_" + side, kAxisX, -45, 45)
      .body(boxBody("foot_" + side, 0.09, {0.13, 0.08, 0.025}, {0.01, 0, -0.029}));
}

inline KinematicTree builtKs21() {
  TreeBuilder builder;
  const TreePlace hips = builder.base("pelvis").body(boxBody("pelvis", 0.25, {0.09, 0.12, 0.03}, {0, 0, 0.04})).fork();
  const TreePlace chest = turn(hips.translation({0, 0, 0.04}), "waist_yaw", kAxisZ, -90, 90)
                              .body(boxBody("trunk", 1.0, {0.10, 0.14, 0.13}, {0, 0, 0.08}))
                              .fork();
  const TreePlace neck = turn(chest.translation({0, 0, 0.145}), "head_pan", kAxisZ, -90, 90, weakServo("RX-28"))
                             .body(boxBody("neck", 0.03, {0.03, 0.03, 0.02}, {0, 0, 0.01}));
  turn(neck.translation({0.01, 0, 0.02}), "head_tilt", kAxisY, -45, 60, weakServo("RX-28"))
      .body(boxBody("skull", 0.15, {0.07, 0.08, 0.07}, {0, 0, 0.025}));
  addArm(chest, "right", -1);
  addArm(chest, "left", 1);
  addLeg(hips, "right", -1);
  addLeg(hips, "left", 1);
  return builder.build();
}

}  // namespace murosimf::testing
