#pragma once

/// @file What the control software knows about its robot, the rappe: order of the joints, lengths.
///
/// Legs are numbered front right, front left, rear right, rear left. Axes x forward, y left, z up; a positive angle
/// turns by the right hand about +x (abduction) or +y (hip pitch, knee), no axis is mirrored. Knees point backwards.

#include <array>
#include <string_view>

namespace murosimf::controllers::trotter {

inline constexpr std::size_t kLegCount = 4, kLegJoints = 3, kJointCount = kLegCount * kLegJoints;
using JointAngles = std::array<double, kJointCount>;  ///< [rad], leg by leg, in the order of sensor and command frames
using LegAngles = std::array<double, kLegJoints>;     ///< abduction, hip pitch, knee

inline constexpr std::array<std::string_view, kJointCount> kJointNames{
    "abduction_front_right", "hip_pitch_front_right", "knee_front_right",     "abduction_front_left",
    "hip_pitch_front_left",  "knee_front_left",       "abduction_rear_right", "hip_pitch_rear_right",
    "knee_rear_right",       "abduction_rear_left",   "hip_pitch_rear_left",  "knee_rear_left"};

/// +1 for front and left legs, -1 for rear and right ones: the signs of x and y at that corner.
constexpr double endSign(std::size_t leg) { return leg < 2 ? 1.0 : -1.0; }
constexpr double sideSign(std::size_t leg) { return leg % 2 == 1 ? 1.0 : -1.0; }
/// Legs of one diagonal move together: 0 is front right with rear left, 1 the other.
constexpr int diagonalOf(std::size_t leg) { return leg == 0 || leg == 3 ? 0 : 1; }

// Lengths [m]. The trunk's origin lies in the middle between the abduction joints.
inline constexpr double kHipForward = 0.17, kHipAside = 0.05;  ///< abduction joint from the origin
inline constexpr double kHipOffset = 0.06;                     ///< of the leg's plane from the abduction joint
inline constexpr double kThigh = 0.20, kShank = 0.20;
inline constexpr double kHoofRadius = 0.025;  ///< a sphere about the lower end of the shank

}  // namespace murosimf::controllers::trotter
