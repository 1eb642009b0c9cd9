#include "murosimf/algorithms/collision/detect_contact.h"

#include <compare>

#include "murosimf/algorithms/collision/collision_pairs.h"
#include "murosimf/algorithms/collision/convex_pair.h"

namespace murosimf {
namespace {

using Detector = void (*)(const CollisionShape&, const CollisionShape&, const Pose&, const Vector3& hint,
                          ContactManifold&);
using ClosedForm = void (*)(const CollisionShape&, const CollisionShape&, const Pose&, ContactManifold&);

/// A closed form needs no hint.
template <ClosedForm form>
void closed(const CollisionShape& a, const CollisionShape& b, const Pose& X_AB, const Vector3&, ContactManifold& out) {
  form(a, b, X_AB, out);
}
void none(const CollisionShape&, const CollisionShape&, const Pose&, const Vector3&, ContactManifold& out) {
  out.count = 0;
}

/// Rows and columns in the order of CollisionKind; below the diagonal nothing is asked.
constexpr Detector kConvexPair = convexAgainstConvex;
constexpr Detector kDetectors[kCollisionKinds][kCollisionKinds] = {
    {none, closed<planeAgainstSphere>, closed<planeAgainstBox>, closed<planeAgainstCapsule>,
     closed<planeAgainstCylinder>, closed<planeAgainstEllipsoid>, closed<planeAgainstConvex>},
    {none, closed<sphereAgainstSphere>, closed<sphereAgainstBox>, closed<sphereAgainstCapsule>,
     closed<sphereAgainstCylinder>, closed<sphereAgainstEllipsoid>, closed<sphereAgainstConvex>},
    {none, none, boxAgainstBox, closed<boxAgainstCapsule>, kConvexPair, kConvexPair, kConvexPair},
    {none, none, none, closed<capsuleAgainstCapsule>, kConvexPair, kConvexPair, kConvexPair},
    {none, none, none, none, kConvexPair, kConvexPair, kConvexPair},
    {none, none, none, none, none, kConvexPair, kConvexPair},
    {none, none, none, none, none, none, kConvexPair}};

std::partial_ordering order(const Vector3& a, const Vector3& b) {
  if (a.x != b.x) return a.x <=> b.x;
  if (a.y != b.y) return a.y <=> b.y;
  return a.z <=> b.z;
}

std::partial_ordering order(const ConvexHull& a, const ConvexHull& b) {
  if (a.vertices().size() != b.vertices().size()) return a.vertices().size() <=> b.vertices().size();
  for (int i = 0; i < static_cast<int>(a.vertices().size()); ++i)
    if (const auto c = order(a.vertex(i), b.vertex(i)); c != 0) return c;
  return std::partial_ordering::equivalent;
}

/// Whether B is to be treated first, so that a pair is computed alike however it is named.
bool isTurned(const CollisionShape& a, const Pose& X_WA, const CollisionShape& b, const Pose& X_WB) {
  if (a.kind != b.kind) return b.kind < a.kind;
  if (const auto c = order(b.half_size, a.half_size); c != 0) return c < 0;
  if (a.hull != b.hull)
    if (const auto c = order(*b.hull, *a.hull); c != 0) return c < 0;
  if (const auto c = order(X_WB.translation, X_WA.translation); c != 0) return c < 0;
  if (const auto c = order(X_WB.rotation.x, X_WA.rotation.x); c != 0) return c < 0;
  return order(X_WB.rotation.y, X_WA.rotation.y) < 0;
}

/// A first. out.normal from B to A.
void detectInOrder(const CollisionShape& a, const Pose& X_WA, const CollisionShape& b, const Pose& X_WB,
                   const Vector3& last_normal, ContactManifold& out) {
  out.apart = 0;
  const Pose X_AB{{applyTransposed(X_WA.rotation, X_WB.rotation.x), applyTransposed(X_WA.rotation, X_WB.rotation.y),
                   applyTransposed(X_WA.rotation, X_WB.rotation.z)},
                  applyInverse(X_WA, X_WB.translation)};
  const Vector3 hint = applyTransposed(X_WA.rotation, last_normal);
  kDetectors[static_cast<int>(a.kind)][static_cast<int>(b.kind)](a, b, X_AB, hint, out);
  if (out.count == 0) return;
  out.normal = X_WA.rotation * out.normal;
  for (int i = 0; i < out.count; ++i) out.points[i].position = X_WA * out.points[i].position;
}

}  // namespace

void detectContact(const CollisionShape& a, const Pose& X_WA, const CollisionShape& b, const Pose& X_WB,
                   ContactManifold& out, const Vector3& last_normal) {
  if (isTurned(a, X_WA, b, X_WB)) {
    detectInOrder(b, X_WB, a, X_WA, -last_normal, out);
    out.normal = -out.normal;
  } else {
    detectInOrder(a, X_WA, b, X_WB, last_normal, out);
  }
}

}  // namespace murosimf
