#pragma once

/// @file Checks of single parts of a robot, in the words in which their faults are reported.
///
/// Each returns what was found and what was expected, or "" when nothing is wrong. The builder throws these words, the
/// reader puts the file's line in front. For mass and inertia see massProblem() in mass_properties.h.

#include <optional>
#include <string>

#include "murosimf/robot/kinematic_tree.h"

namespace murosimf {

/// Edges, radii and lengths positive and finite; a hull where the shape is one; colour components in [0, 1].
std::string shapeProblem(const BodyShape& shape);

/// lower <= upper, largest values positive; infinite is allowed, NaN is not.
std::string limitsProblem(const JointLimits& limits);

/// Stall torque, no-load speed and kp positive; kd, armature, resolution and backlash not negative; all finite.
std::string servoProblem(const ServoParameters& servo);

/// A name is a word of at most 100 letters, digits, `_` and `-`, so that paths and lists of names need no quotes.
std::string nameProblem(const std::string& name);

/// A device of the player API is named as others named it: 1 to 100 printable ASCII characters, spaces within.
std::string deviceNameProblem(const std::string& name);

/// The axis with length 1, or nothing when it is zero or not finite. Components below 1e-9 of the largest are rounding
/// of whatever wrote the file and become zero, so that a coordinate axis stays exactly one.
std::optional<Vector3> unitAxis(const Vector3& axis);

/// Text of a file for use in a message: in double quotes, at most 60 characters, unprintable bytes as \xNN.
std::string quoted(const std::string& text);

}  // namespace murosimf
