// A sphere, A, against everything but planes. In A's frame its centre is the origin.
#include "murosimf/algorithms/collision/collision_pairs.h"
#include "murosimf/algorithms/collision/hull_distance.h"
#include "murosimf/algorithms/sphere_contact.h"

namespace murosimf {
namespace {

/// nearest: on B, to the sphere's centre, in B's frame.
void finish(const NearestPoint& nearest, double radius, const Pose& X_AB, ContactManifold& out) {
  out.count = 0;
  const double depth = radius - nearest.distance;
  out.apart = -depth;
  if (!(depth > 0)) return;
  out.normal = X_AB.rotation * nearest.normal;
  out.points[0] = {out.normal * (-0.5 * (radius + nearest.distance)), depth, 0};
  out.count = 1;
}

Vector3 centreOfA(const Pose& X_AB) { return applyInverse(X_AB, Vector3{}); }

}  // namespace

void sphereAgainstSphere(const CollisionShape& a, const CollisionShape& b, const Pose& X_AB, ContactManifold& out) {
  out.count = 0;
  const double distance = norm(X_AB.translation), depth = a.half_size.x + b.half_size.x - distance;
  out.apart = -depth;
  if (!(depth > 0)) return;
  out.normal = distance > 0 ? X_AB.translation * (-1 / distance) : Vector3{0, 0, 1};
  out.points[0] = {out.normal * (0.5 * depth - a.half_size.x), depth, 0};
  out.count = 1;
}

void sphereAgainstBox(const CollisionShape& a, const CollisionShape& b, const Pose& X_AB, ContactManifold& out) {
  finish(nearestOnBox(centreOfA(X_AB), b.half_size), a.half_size.x, X_AB, out);
}

void sphereAgainstCapsule(const CollisionShape& a, const CollisionShape& b, const Pose& X_AB, ContactManifold& out) {
  finish(nearestOnCapsule(centreOfA(X_AB), b.half_size.x, b.half_size.z), a.half_size.x, X_AB, out);
}

void sphereAgainstCylinder(const CollisionShape& a, const CollisionShape& b, const Pose& X_AB, ContactManifold& out) {
  finish(nearestOnCylinder(centreOfA(X_AB), b.half_size.x, b.half_size.z), a.half_size.x, X_AB, out);
}

void sphereAgainstEllipsoid(const CollisionShape& a, const CollisionShape& b, const Pose& X_AB, ContactManifold& out) {
  finish(nearestOnEllipsoid(centreOfA(X_AB), b.half_size), a.half_size.x, X_AB, out);
}

void sphereAgainstConvex(const CollisionShape& a, const CollisionShape& b, const Pose& X_AB, ContactManifold& out) {
  finish(nearestOnHull(centreOfA(X_AB), *b.hull, a.half_size.x), a.half_size.x, X_AB, out);
}

}  // namespace murosimf
