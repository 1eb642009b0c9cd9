#include "murosimf/algorithms/collision/convex_pair.h"

#include "murosimf/algorithms/collision/least_depth.h"
#include "murosimf/algorithms/collision/mpr_contact.h"
#include "murosimf/algorithms/collision/surface_feature.h"

namespace murosimf {
namespace {

/// What both shapes turn to each other.
struct FacingFeatures {
  SurfaceFeature a, b;
  void find(const ConvexPair& pair, const Vector3& normal) {
    facingFeature(pair.a, -normal, a);
    facingFeature(pair.b, applyTransposed(pair.X_AB.rotation, normal), b);
    transformFeature(pair.X_AB, b);
  }
};

Vector3 betweenCentres(const ConvexPair& pair) {
  const Vector3 between = innerPoint(pair.a) - pair.X_AB * innerPoint(pair.b);
  const double distance = norm(between);
  return distance > 1e-12 ? between * (1 / distance) : Vector3{0, 0, 1};
}

/// A face within 3 degrees whose normal is as good as the one that was found, within the search's tolerance, replaces
/// it: the search knows faces by their corners only.
bool takeNormalOfFace(const ConvexPair& pair, const FacingFeatures& features, LeastDepth& found) {
  const double limit = found.depth * (1 + 1e-4) + 1e-7;
  double least = limit;
  Vector3 normal;
  const auto attempt = [&](const SurfaceFeature& feature, const Vector3& outward) {
    if (feature.count < 3) return;
    const double depth = pair.depthAlong(outward);
    if (depth < least) least = depth, normal = outward;
  };
  attempt(features.a, -features.a.normal);
  attempt(features.b, features.b.normal);
  if (!(least < limit)) return false;
  found.depth = least, found.normal = normal;
  return true;
}

}  // namespace

void convexAgainstConvex(const CollisionShape& a, const CollisionShape& b, const Pose& X_AB, const Vector3& hint,
                         ContactManifold& out) {
  out.count = 0;
  const ConvexPair pair{a, b, X_AB};
  const bool hinted = squaredNorm(hint) > 0;
  if (hinted && pair.depthAlong(hint) <= 0) {
    out.apart = -pair.depthAlong(hint);
    return;
  }
  if (!overlapByPortal(pair)) return;
  LeastDepth found = leastDepth(pair, hinted ? hint : betweenCentres(pair));
  if (!(found.depth > 0)) return;
  FacingFeatures features;
  features.find(pair, found.normal);
  if (takeNormalOfFace(pair, features, found)) features.find(pair, found.normal);
  if (!(found.depth > 0)) return;
  out.normal = found.normal;
  pointsBetween(features.a, features.b, {found.depth, found.midpoint}, out);
}

}  // namespace murosimf
