#include "murosimf/algorithms/collision/hull_shape.h"

namespace murosimf {

HullShape makeConvex(std::span<const Vector3> points_L) {
  Vector3 low, high;
  if (!points_L.empty()) low = high = points_L.front();
  for (const Vector3& p : points_L)
    for (int k = 0; k < 3; ++k) low[k] = min(low[k], p[k]), high[k] = max(high[k], p[k]);
  HullShape made{{ShapeKind::kConvex, (high - low) * 0.5}, (low + high) * 0.5, nullptr};
  std::vector<Vector3> points_S;
  points_S.reserve(points_L.size());
  for (const Vector3& p : points_L) points_S.push_back(p - made.p_LS);
  made.hull = std::make_shared<const ConvexHull>(points_S);
  return made;
}

}  // namespace murosimf
