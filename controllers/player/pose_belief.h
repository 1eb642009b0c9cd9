#pragma once

/// @file One hypothesis of where the robot stands: a normal distribution over its pose, an extended Kalman filter.
///
/// State      x = (x, y, heading) of R in F, covariance P (3 x 3).
/// Move       x <- x (+) u, P <- F P F^T + Q(u); u: odometry increment. Q grows with the way, because feet slip and
///            robots are blocked and pushed, and a little with every step.
/// Correct    one scalar measurement at a time: S = h P h^T + r, k = P h^T / S, x <- x + k e, P <- P - k S k^T.
/// Source     [Thrun, Burgard, Fox 2005, ch. 3 and 7].

#include <array>

#include "field_map.h"
#include "murosimf/control/client/state_archive.h"

namespace murosimf::controllers {

/// A linearised scalar measurement: what the innovation changes by when the pose changes.
struct Measurement {
  std::array<double, 3> row{};  ///< h, per x, y [1/m or 1], heading
  double innovation = 0;        ///< e: measured minus expected
  double variance = 0;          ///< r
};

/// A landmark seen: percept with kind and variances.
struct LandmarkSight {
  LandmarkKind kind = LandmarkKind::kPost;
  LandmarkColour colour = LandmarkColour::kYellow;
  double bearing = 0, distance = 0;                    ///< in R [rad], [m]
  double bearing_variance = 0, distance_variance = 0;  ///< [rad^2], [m^2]
  /// Member by member: the bytes between them are nobody's.
  void archive(client::StateArchive& archive) {
    archive(kind, colour, bearing, distance, bearing_variance, distance_variance);
  }
};

/// Bearing and distance of one landmark against a belief, ready to correct it.
struct PolarInnovation {
  Measurement bearing, distance;
  double squared_error = 0;  ///< e^T S^-1 e, two degrees of freedom
  double density = 0;        ///< of the sight under this belief [1/(rad m)]
};

struct PoseBelief {
  PlanarPose mean;
  std::array<std::array<double, 3>, 3> covariance{};
  double log_weight = 0;  ///< against the best of all hypotheses: 0 for the best
  double doubt = 0;       ///< running share of landmarks that it cannot explain, 0 to 1

  static PoseBelief at(const PlanarPose& pose, double position_deviation, double heading_deviation);
  void move(const PlanarPose& increment);
  /// Adds independent uncertainty (standard deviations [m], [rad]).
  void widen(double position_deviation, double heading_deviation);
  void correct(const Measurement& measurement);
  /// Corrects by both parts; the second innovation takes into account what the first has changed.
  void correct(const PolarInnovation& innovation);
  /// h P h^T + r.
  double innovationVariance(const Measurement& measurement) const;
  PolarInnovation compare(const LandmarkSight& sight, const Point& landmark) const;
};

}  // namespace murosimf::controllers
