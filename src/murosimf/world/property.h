#pragma once

/// @file Properties: the words in which objects and algorithms meet.
///
/// A property is a typed key, declared once with name, unit and meaning. A Constant belongs to the model (mass, length,
/// lens) and never changes after the world is built; a Variable belongs to an algorithm, which adds it to an object
/// when the two are linked [Friedmann 2007, 3.1]. Shared properties stand in vocabulary.h, private ones beside their
/// module.

#include <cstdint>
#include <string_view>
#include <type_traits>

#include "murosimf/math/transform.h"

namespace murosimf {

/// How long the value of a variable lives.
enum class Storage : std::uint8_t {
  kState,     ///< always valid; saved in checkpoints, part of the state hash
  kKept,      ///< follows from state, kept between frames for readers; computed only when somebody reads it
  kStep,      ///< valid only after its writer ran in this frame; lives in memory that all blocks of a thread share
  kOnDemand,  ///< follows from what its writer keeps, for those outside of the blocks; computed only in frames in which
              ///< somebody asks
};

/// A value of the model. T is double, Vector3, Pose, std::string, or a type of a lower folder (a shape list, a lens).
template <class T>
struct Constant {
  using Value = T;
  std::string_view name;
  std::string_view unit;
  std::string_view meaning;
};

/// A value that an algorithm computes. T is a plain structure of doubles: double, Vector3, Rotation3, Pose, ...
template <class T>
struct Variable {
  static_assert(std::is_trivially_copyable_v<T> && sizeof(T) % sizeof(double) == 0, "variables are made of doubles");
  using Value = T;
  static constexpr int kComponents = static_cast<int>(sizeof(T) / sizeof(double));
  std::string_view name;
  std::string_view unit;
  std::string_view meaning;
  Storage storage = Storage::kState;
};

/// Constants of these types are numbers that kernels read lane by lane, so robots of one batch may differ in them. All
/// other types (trees, lenses, texts) are structure: robots of one batch have equal values.
template <class T>
inline constexpr bool kIsNumeric = false;
template <>
inline constexpr bool kIsNumeric<double> = true;
template <>
inline constexpr bool kIsNumeric<Vector3> = true;

/// Names of the groups of objects that an assembly (a robot, a ball) hands out.
namespace subset {
inline constexpr std::string_view kSelf = "self";                   ///< the assembly's own object
inline constexpr std::string_view kWorld = "world";                 ///< the root, which holds what all share
inline constexpr std::string_view kJoints = "joints";               ///< in the order of the control software's frames
inline constexpr std::string_view kBodies = "bodies";               ///< rows of the tree table, the base first
inline constexpr std::string_view kSoles = "soles";                 ///< right ones, left ones, those of no side
inline constexpr std::string_view kImus = "imus";                   ///< in the order of the robot file
inline constexpr std::string_view kTouchSensors = "touch_sensors";  ///< likewise
inline constexpr std::string_view kForceSensors = "force_sensors";  ///< likewise
inline constexpr std::string_view kRangeSensors = "range_sensors";  ///< likewise
inline constexpr std::string_view kWheels = "wheels";               ///< wheels and castors, likewise
}  // namespace subset

}  // namespace murosimf
