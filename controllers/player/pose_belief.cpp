#include "pose_belief.h"

#include <algorithm>

namespace murosimf::controllers {
namespace {

using Row = std::array<double, 3>;

// Odometry noise: variances that grow with the way w [m] and the turn a [rad], and with every step.
constexpr double kPositionPerWay = 0.02;    // [m^2/m]
constexpr double kPositionPerStep = 3e-6;   // [m^2]
constexpr double kHeadingPerWay = 0.01;     // [rad^2/m]
constexpr double kHeadingPerTurn = 0.03;    // [rad^2/rad]
constexpr double kHeadingPerStep = 8e-6;    // [rad^2]
constexpr double kSmallestDistance = 0.15;  // landmarks nearer than this are taken to be this far away [m]

double product(const Row& a, const Row& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// h P.
Row rowTimes(const Row& row, const std::array<Row, 3>& matrix) {
  Row result{};
  for (std::size_t j = 0; j < 3; ++j) result[j] = row[0] * matrix[0][j] + row[1] * matrix[1][j] + row[2] * matrix[2][j];
  return result;
}

}  // namespace

PoseBelief PoseBelief::at(const PlanarPose& pose, double position_deviation, double heading_deviation) {
  PoseBelief belief;
  belief.mean = {pose.x, pose.y, wrapAngle(pose.heading)};
  belief.widen(position_deviation, heading_deviation);
  return belief;
}

void PoseBelief::widen(double position_deviation, double heading_deviation) {
  covariance[0][0] += position_deviation * position_deviation;
  covariance[1][1] += position_deviation * position_deviation;
  covariance[2][2] += heading_deviation * heading_deviation;
}

void PoseBelief::move(const PlanarPose& increment) {
  const PlanarPose next = compose(mean, increment);
  // F = 1 but for the influence of the heading on the position: (-dy, dx).
  const double dx = next.x - mean.x, dy = next.y - mean.y;
  auto& P = covariance;
  const double xh = P[0][2] - dy * P[2][2], yh = P[1][2] + dx * P[2][2];
  P[0][0] += -dy * (P[0][2] + xh);
  P[1][1] += dx * (P[1][2] + yh);
  P[0][1] += dx * P[0][2] - dy * yh;
  P[1][0] = P[0][1];
  P[0][2] = P[2][0] = xh;
  P[1][2] = P[2][1] = yh;
  mean = next;
  const double way = sqrt(dx * dx + dy * dy), turn = increment.heading < 0 ? -increment.heading : increment.heading;
  P[0][0] += kPositionPerWay * way + kPositionPerStep;
  P[1][1] += kPositionPerWay * way + kPositionPerStep;
  P[2][2] += kHeadingPerWay * way + kHeadingPerTurn * turn + kHeadingPerStep;
}

double PoseBelief::innovationVariance(const Measurement& measurement) const {
  return product(rowTimes(measurement.row, covariance), measurement.row) + measurement.variance;
}

void PoseBelief::correct(const Measurement& measurement) {
  const Row hP = rowTimes(measurement.row, covariance);
  const double S = product(hP, measurement.row) + measurement.variance;
  const double scaled = measurement.innovation / S;
  mean.x += hP[0] * scaled;
  mean.y += hP[1] * scaled;
  mean.heading = wrapAngle(mean.heading + hP[2] * scaled);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j <= i; ++j) covariance[i][j] = covariance[j][i] = covariance[i][j] - hP[i] * hP[j] / S;
  for (std::size_t i = 0; i < 3; ++i) covariance[i][i] = std::max(covariance[i][i], 1e-9);
}

void PoseBelief::correct(const PolarInnovation& innovation) {
  const PlanarPose before = mean;
  correct(innovation.bearing);
  Measurement distance = innovation.distance;
  distance.innovation -= distance.row[0] * (mean.x - before.x) + distance.row[1] * (mean.y - before.y);
  correct(distance);
}

PolarInnovation PoseBelief::compare(const LandmarkSight& sight, const Point& landmark) const {
  const Point d = landmark - Point{mean.x, mean.y};
  const double r = std::max(norm(d), kSmallestDistance);
  PolarInnovation result;
  result.bearing = {{d.y / (r * r), -d.x / (r * r), -1.0},
                    wrapAngle(sight.bearing - (direction(d) - mean.heading)),
                    sight.bearing_variance};
  result.distance = {{-d.x / r, -d.y / r, 0.0}, sight.distance - r, sight.distance_variance};
  const Row bP = rowTimes(result.bearing.row, covariance);
  const double bb = product(bP, result.bearing.row) + sight.bearing_variance;
  const double bd = product(bP, result.distance.row);
  const double dd = innovationVariance(result.distance);
  const double determinant = std::max(bb * dd - bd * bd, 1e-12);
  const double e = result.bearing.innovation, f = result.distance.innovation;
  result.squared_error = (dd * e * e - 2 * bd * e * f + bb * f * f) / determinant;
  result.density = exp(-0.5 * result.squared_error) / (2 * kPi * sqrt(determinant));
  return result;
}

}  // namespace murosimf::controllers
