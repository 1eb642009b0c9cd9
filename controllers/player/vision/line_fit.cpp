#include "player/vision/line_fit.h"

#include <algorithm>

#include "murosimf/math/vec3.h"

namespace murosimf::controllers {
namespace {

constexpr double kNoLine = 1e9;
constexpr double kLargestBend = 0.55;  ///< change of slope from end to end

/// Coordinates of p along and across a line.
PlanePoint inLine(const FittedLine& line, const PlanePoint& p) {
  const double da = p.a - line.centre.a, db = p.b - line.centre.b;
  return {da * line.direction.a + db * line.direction.b, db * line.direction.a - da * line.direction.b};
}

/// Coefficients of t = c.x + c.y s + c.z s^2 from the sums of 1, s, s^2 times (1, s, s^2) and times t.
Vector3 solveSymmetric(const Vector3 (&row)[3], const Vector3& right) {
  const Vector3 c = cross(row[1], row[2]);
  const double determinant = dot(row[0], c);
  if (determinant == 0) return {0, 0, kNoLine};
  return (c * right.x + cross(row[2], row[0]) * right.y + cross(row[0], row[1]) * right.z) * (1 / determinant);
}

}  // namespace

FittedLine LineFit::straight() const {
  double a = 0, b = 0, aa = 0, ab = 0, bb = 0;
  for (int i = 0; i < count_; ++i)
    a += points_[static_cast<std::size_t>(i)].a, b += points_[static_cast<std::size_t>(i)].b;
  a /= count_, b /= count_;
  for (int i = 0; i < count_; ++i) {
    const double da = points_[static_cast<std::size_t>(i)].a - a, db = points_[static_cast<std::size_t>(i)].b - b;
    aa += da * da, ab += da * db, bb += db * db;
  }
  const double half = 0.5 * (aa - bb), root = sqrt(half * half + ab * ab), largest = 0.5 * (aa + bb) + root;
  // Eigenvector from the better conditioned row of the covariance.
  PlanePoint d = half >= 0 ? PlanePoint{largest - bb, ab} : PlanePoint{ab, largest - aa};
  const double length = sqrt(d.a * d.a + d.b * d.b);
  d = length > 0 ? PlanePoint{d.a / length, d.b / length} : PlanePoint{1, 0};
  return {{a, b}, d, sqrt(std::max(0.0, largest - 2 * root) / count_), 0, count_};
}

FittedLine LineFit::tangent() const {
  FittedLine line = straight();
  line.deviation = kNoLine;
  if (count_ < 5) return line;
  // Scaled by the largest |s|, so that the sums are of one size.
  double scale = 0;
  for (int i = 0; i < count_; ++i) scale = std::max(scale, abs(inLine(line, points_[static_cast<std::size_t>(i)]).a));
  if (scale <= 0) return line;
  Vector3 row[3], right;
  for (int i = 0; i < count_; ++i) {
    const PlanePoint p = inLine(line, points_[static_cast<std::size_t>(i)]);
    const double s = p.a / scale;
    const Vector3 powers{1, s, s * s};
    for (int k = 0; k < 3; ++k) row[k] += powers * powers[k];
    right += powers * p.b;
  }
  const Vector3 c = solveSymmetric(row, right);
  if (abs(4 * c.z) > kLargestBend * scale) return line;
  double sum = 0;
  for (int i = 0; i < count_; ++i) {
    const PlanePoint p = inLine(line, points_[static_cast<std::size_t>(i)]);
    const double s = p.a / scale, e = p.b - (c.x + s * (c.y + s * c.z));
    sum += e * e;
  }
  const double s0 = inLine(line, points_[0]).a / scale, t0 = c.x + s0 * (c.y + s0 * c.z);
  const double slope = (c.y + 2 * c.z * s0) / scale, length = sqrt(1 + slope * slope);
  const PlanePoint d = line.direction;
  const double along = s0 * scale;
  line.centre = {line.centre.a + along * d.a - t0 * d.b, line.centre.b + along * d.b + t0 * d.a};
  line.direction = {(d.a - slope * d.b) / length, (d.b + slope * d.a) / length};
  line.deviation = sqrt(sum / count_);
  return line;
}

}  // namespace murosimf::controllers
