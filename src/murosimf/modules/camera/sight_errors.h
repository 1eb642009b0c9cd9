#pragma once

/// @file How wrong an oracle is: what its percepts of one kind suffer.
///
/// A thing stands at horizontal distance d and bearing phi from the camera's centre, in axes of the world; its height
/// is never wrong. What is told of picture k, g and u numbers of (seed, camera, thing, k):
///   phi' = phi + bearing_bias + bearing_noise g_1
///   d'   = d max(1/20, 1 + distance_bias + distance_noise g_2)
/// It is left out where u < miss, where d > range, and in outages. Besides, things are told that are not there: their
/// number in a picture is of Poisson with the mean false_rate times the time between pictures, their bearings are those
/// of pixels, their distances even in [0.3 m, range], and each looks like some thing of its kind.

#include <array>
#include <string_view>
#include <vector>

#include "murosimf/modules/camera/landmark.h"

namespace murosimf {

struct SightErrors {
  double bearing_noise = 0, distance_noise = 0;  ///< standard deviations [rad], [1]
  double bearing_bias = 0, distance_bias = 0;    ///< [rad], [1]
  double miss = 0;                               ///< probability
  double false_rate = 0;                         ///< [1/s]
  double delay = 0;                              ///< from the look to its arrival [s]
  double outage_rate = 0, outage_length = 1;     ///< [1/s], [s]
  double range = 10;                             ///< farther things are not seen [m]
  double occlusion = 1;                          ///< 1: what others hide is not seen; 0: it is
};
using ErrorsByKind = std::array<SightErrors, kSightKinds>;

/// A number that a scenario may set: NAME for all kinds, KIND_NAME for one.
template <class Errors>
struct ErrorParameter {
  std::string_view name, unit;
  double lowest = 0, highest = 0;
  double Errors::*value = nullptr;
  std::string_view meaning;
};

const std::vector<ErrorParameter<SightErrors>>& sightParameters();

}  // namespace murosimf
