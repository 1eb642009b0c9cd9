#pragma once

/// @file What the control software knows about its robot, the KS21: order of the joints, lengths, mounts.
///
/// Side: 0 right, 1 left, as in Posture and the first two soles of SensorFrame. Axes x forward, y left, z up; a
/// positive angle turns by the right hand about +x (roll), +y (pitch), +z (yaw). No axis is mirrored: outwards is
/// negative roll on the right.

#include <array>
#include <string_view>

#include "murosimf/math/elementary.h"

namespace murosimf::controllers {

inline constexpr int kJointCount = 21;
using JointAngles = std::array<double, kJointCount>;  ///< [rad], in the order of sensor and command frames
using LegAngles = std::array<double, 6>;              ///< hip yaw, hip roll, hip pitch, knee, ankle pitch, ankle roll

/// Names of the joints, and of the body that carries the head camera; all other cameras sit on the trunk.
inline constexpr std::array<std::string_view, kJointCount> kJointNames{
    "waist_yaw",           "head_pan",          "head_tilt",           "shoulder_pitch_right",
    "shoulder_roll_right", "elbow_right",       "shoulder_pitch_left", "shoulder_roll_left",
    "elbow_left",          "hip_yaw_right",     "hip_roll_right",      "hip_pitch_right",
    "knee_right",          "ankle_pitch_right", "ankle_roll_right",    "hip_yaw_left",
    "hip_roll_left",       "hip_pitch_left",    "knee_left",           "ankle_pitch_left",
    "ankle_roll_left"};
inline constexpr std::string_view kHeadBody = "skull";

inline constexpr int kRight = 0, kLeft = 1;
inline constexpr int kWaistYaw = 0, kHeadPan = 1, kHeadTilt = 2;
inline constexpr std::array<int, 2> kFirstArmJoint{3, 6};   ///< shoulder pitch; roll and elbow follow
inline constexpr std::array<int, 2> kFirstLegJoint{9, 15};  ///< hip yaw; the others as in LegAngles
inline constexpr int kHipRoll = 1, kHipPitch = 2, kKnee = 3, kAnklePitch = 4, kAnkleRoll = 5;  ///< within LegAngles

/// +1 left, -1 right: the sign of y on that side.
constexpr double sideSign(int side) { return side == kLeft ? 1.0 : -1.0; }
constexpr double degrees(double angle) { return angle * kPi / 180.0; }

// Lengths [m]. The pelvis' origin lies in the middle between the hip centres.
inline constexpr double kHipHalfDistance = 0.045;
inline constexpr double kThigh = 0.125, kShank = 0.125;
inline constexpr double kWaistHeight = 0.040;                     ///< waist joint above the pelvis' origin
inline constexpr double kNeckHeight = 0.145;                      ///< head pan joint above the waist joint
inline constexpr double kTiltForward = 0.010, kTiltUp = 0.020;    ///< head tilt joint from the pan joint
inline constexpr double kEyeForward = 0.030, kEyeUp = 0.030;      ///< head camera from the tilt joint
inline constexpr double kSoleForward = 0.010, kSoleDown = 0.035;  ///< centre of the sole's bottom face from the ankle
inline constexpr double kSoleLength = 0.130, kSoleWidth = 0.080;

}  // namespace murosimf::controllers
