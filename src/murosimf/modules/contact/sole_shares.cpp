#include "murosimf/modules/contact/sole_shares.h"

namespace murosimf {

namespace {

constexpr double kInPlane = 1e-3, kNear = 1e-2;  // [m] between vertices and the sole's plane

/// p: in the sole's frame. Corners count as those of a box's lower face: x, then y alternate.
CornerShares sharesAt(const Vector3& p, const SolePlace& sole) {
  CornerShares shares{};
  if (abs(p.z) > kNear) return shares;
  const double x = clamp(0.5 + 0.5 * p.x / sole.half_length, 0.0, 1.0);
  const double y = clamp(0.5 + 0.5 * p.y / sole.half_width, 0.0, 1.0);
  for (int i = 0; i < 4; ++i) shares.of[i] = ((i & 1) != 0 ? x : 1 - x) * ((i & 2) != 0 ? y : 1 - y);
  return shares;
}

}  // namespace

SoleShares shareBySole(const PlacedShape& shape, const std::vector<SolePlace>& soles) {
  for (std::size_t i = 0; i < soles.size(); ++i) {
    if (soles[i].mount.row != shape.row) continue;
    SoleShares made{static_cast<int>(i), {}};
    bool beside = false;
    for (const Vector3& vertex : shape.hull->vertices()) {
      const Vector3 p = applyInverse(soles[i].mount.X_RM, shape.X_BS * vertex);
      beside = beside || abs(p.z) <= kInPlane;
      made.of_vertices.push_back(sharesAt(p, soles[i]));
    }
    if (beside) return made;
  }
  return {};
}

}  // namespace murosimf
