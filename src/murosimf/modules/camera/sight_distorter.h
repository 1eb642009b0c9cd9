#pragma once

/// @file From what a camera could see to what an oracle tells of it: errors, misses, false percepts, outages.
///
/// All random numbers are those of (seed, camera, purpose and thing) at step k, the picture's number: any picture can
/// be asked for in any order.

#include <span>
#include <string_view>
#include <vector>

#include "murosimf/math/random.h"
#include "murosimf/math/state_archive.h"
#include "murosimf/modules/camera/oracle_eye.h"

namespace murosimf {

/// What is told of one thing: places in the camera's frame C at the moment of the look.
struct Sighting {
  int landmark = 0;  ///< which it is, or for what something was taken that is not there
  Vector3 p_C, q_C;  ///< q: a line's other end, else p
  void archive(StateArchive& archive) { archive(landmark, p_C, q_C); }
};
using SightingsByKind = std::array<std::vector<Sighting>, kSightKinds>;

/// When and where a look was taken.
struct LookMoment {
  std::uint64_t number = 0;  ///< of the picture
  double time = 0;           ///< [s]
  Pose X_WC;
};

class SightDistorter {
 public:
  /// @param period  between pictures [s]
  SightDistorter(const OracleEye& eye, const ErrorsByKind& errors, std::uint64_t seed, std::string_view camera,
                 double period);

  /// Overwrites `told`.
  void distort(const OracleEye& eye, std::span<const TrueSight> seen, const LookMoment& moment,
               SightingsByKind& told) const;

 private:
  struct ThingStreams {
    RandomStream miss, bearing, distance;
  };
  struct KindStreams {
    RandomStream outage, count, place;
  };
  void addSight(const TrueSight& sight, SightKind kind, const LookMoment& moment, SightingsByKind& told) const;
  void addFalse(const OracleEye& eye, SightKind kind, const LookMoment& moment, SightingsByKind& told) const;

  ErrorsByKind errors_;
  double period_, valid_radius_;
  std::vector<ThingStreams> things_;  // as the eye's targets
  std::array<KindStreams, kSightKinds> kinds_;
  std::array<std::vector<int>, kSightKinds> members_;  // targets of each kind
};

}  // namespace murosimf
