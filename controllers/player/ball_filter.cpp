#include "ball_filter.h"

#include <algorithm>
#include <cmath>

namespace murosimf::controllers {
namespace {

constexpr double kVariancePerWay = 0.005;   // of the odometry [m^2/m]
constexpr double kVariancePerTurn = 0.005;  // [rad^2/rad]

using Matrix = std::array<std::array<double, 4>, 4>;
using Vector = std::array<double, 4>;

/// Unit vectors along the ray to the sight and across it.
struct RayAxes {
  Point along, across;
};
RayAxes rayAxes(const Point& p) {
  const double distance = norm(p);
  const Point along = distance > 1e-6 ? (1 / distance) * p : Point{1, 0};
  return {along, {-along.y, along.x}};
}

/// P h^T for a row h = (u, 0, 0).
Vector timesPosition(const Matrix& P, const Point& u) {
  Vector result{};
  for (std::size_t i = 0; i < 4; ++i) result[i] = P[i][0] * u.x + P[i][1] * u.y;
  return result;
}

/// P <- T P T^T, T = diag(R, R), R a turn to the right by `angle`.
void turnBack(const SinCos<double>& angle, Matrix& P) {
  for (std::size_t column = 0; column < 4; ++column)
    for (std::size_t block = 0; block < 4; block += 2) {
      const Point p = turnedBack(angle, {P[block][column], P[block + 1][column]});
      P[block][column] = p.x, P[block + 1][column] = p.y;
    }
  for (Vector& row : P)
    for (std::size_t block = 0; block < 4; block += 2) {
      const Point p = turnedBack(angle, {row[block], row[block + 1]});
      row[block] = p.x, row[block + 1] = p.y;
    }
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < i; ++j) P[j][i] = P[i][j];
}

}  // namespace

void rollBall(Point& p, Point& v, double dt) {
  const double speed = norm(v), loss = BallFilter::kRollingDeceleration * dt;
  if (speed <= loss) {
    p = p + (0.5 * speed / BallFilter::kRollingDeceleration) * v;  // v^2 / (2 a) in the direction of v
    v = {0, 0};
    return;
  }
  const double left = (speed - loss) / speed;
  p = p + (0.5 * dt * (1 + left)) * v;
  v = left * v;
}

void BallFilter::begin(const BallSight& sight, const Point& velocity, double velocity_variance) {
  state = {sight.p_R.x, sight.p_R.y, velocity.x, velocity.y};
  covariance = {};
  const RayAxes axes = rayAxes(sight.p_R);
  const Point &a = axes.along, &c = axes.across;
  const double along = sight.along_variance, across = sight.across_variance;
  covariance[0][0] = along * a.x * a.x + across * c.x * c.x;
  covariance[0][1] = covariance[1][0] = along * a.x * a.y + across * c.x * c.y;
  covariance[1][1] = along * a.y * a.y + across * c.y * c.y;
  covariance[2][2] = covariance[3][3] = velocity_variance;
}

void BallFilter::roll(double dt) {
  Point p = position(), v = velocity();
  rollBall(p, v, dt);
  state = {p.x, p.y, v.x, v.y};
  auto& P = covariance;
  for (std::size_t j = 0; j < 4; ++j)
    for (std::size_t i = 0; i < 2; ++i) P[i][j] += dt * P[i + 2][j];
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 2; ++j) P[i][j] += dt * P[i][j + 2];
  const double to_position = 0.5 * dt * dt * kAcceleration, to_velocity = dt * kAcceleration;
  for (std::size_t i = 0; i < 2; ++i) {
    P[i][i] += to_position * to_position;
    P[i][i + 2] += to_position * to_velocity;
    P[i + 2][i] = P[i][i + 2];
    P[i + 2][i + 2] += to_velocity * to_velocity;
  }
  for (std::size_t i = 0; i < 2; ++i) {
    limitVariance(i, kLargestPositionVariance);
    limitVariance(i + 2, kLargestVelocityVariance);
  }
}

/// Scales row and column, so that what remains is still a covariance.
void BallFilter::limitVariance(std::size_t i, double largest) {
  if (covariance[i][i] <= largest) return;
  const double scale = sqrt(largest / covariance[i][i]);
  for (std::size_t j = 0; j < 4; ++j) covariance[i][j] *= scale, covariance[j][i] *= scale;
}

void BallFilter::disturb(double velocity_variance) {
  for (std::size_t i = 2; i < 4; ++i) {
    covariance[i][i] += velocity_variance;
    limitVariance(i, kLargestVelocityVariance);
  }
}

void BallFilter::turn(const PlanarPose& increment) {
  const SinCos<double> angle = sincos(increment.heading);
  const Point p = turnedBack(angle, position() - Point{increment.x, increment.y});
  const Point v = turnedBack(angle, velocity());
  state = {p.x, p.y, v.x, v.y};
  turnBack(angle, covariance);
  const double way = norm(Point{increment.x, increment.y}), turn = std::fabs(increment.heading);
  const double variance = kVariancePerWay * way + kVariancePerTurn * turn * dot(p, p);
  covariance[0][0] += variance;
  covariance[1][1] += variance;
}

double BallFilter::squaredError(const BallSight& sight) const {
  const RayAxes axes = rayAxes(sight.p_R);
  const Vector along = timesPosition(covariance, axes.along), across = timesPosition(covariance, axes.across);
  const double aa = dot(axes.along, {along[0], along[1]}) + sight.along_variance;
  const double cc = dot(axes.across, {across[0], across[1]}) + sight.across_variance;
  const double ac = dot(axes.across, {along[0], along[1]});
  const Point error = sight.p_R - position();
  const double e = dot(axes.along, error), f = dot(axes.across, error);
  return (cc * e * e - 2 * ac * e * f + aa * f * f) / std::max(aa * cc - ac * ac, 1e-12);
}

void BallFilter::correct(const BallSight& sight) {
  const RayAxes axes = rayAxes(sight.p_R);
  const std::array<Point, 2> directions{axes.along, axes.across};
  const std::array<double, 2> variances{sight.along_variance, sight.across_variance};
  for (std::size_t k = 0; k < 2; ++k) {
    const Point& u = directions[k];
    const Vector Ph = timesPosition(covariance, u);
    const double S = dot(u, {Ph[0], Ph[1]}) + variances[k];
    const double scaled = dot(u, sight.p_R - position()) / S;
    for (std::size_t i = 0; i < 4; ++i) state[i] += Ph[i] * scaled;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j <= i; ++j) covariance[i][j] = covariance[j][i] = covariance[i][j] - Ph[i] * Ph[j] / S;
  }
}

}  // namespace murosimf::controllers
