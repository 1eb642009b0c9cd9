// A plane against everything. In its frame A the plane is z = 0, the normal from B to A is -z, and the depth of a
// point of B is -z.
#include "murosimf/algorithms/collision/collision_pairs.h"
#include "murosimf/algorithms/collision/round_rim.h"

namespace murosimf {
namespace {

constexpr Vector3 kDown{0, 0, -1};

void addLowPoint(const Vector3& p_A, int feature, CandidatePoints& candidates) {
  candidates.add({p_A.x, p_A.y, 0.5 * p_A.z}, -p_A.z, static_cast<std::uint32_t>(feature));
}

void finish(const CandidatePoints& candidates, ContactManifold& out) {
  out.normal = kDown;
  chooseFour(candidates, out);
}

void finishWithOne(const Vector3& lowest_A, ContactManifold& out) {
  CandidatePoints one;
  addLowPoint(lowest_A, 0, one);
  finish(one, out);
}

}  // namespace

void planeAgainstSphere(const CollisionShape&, const CollisionShape& b, const Pose& X_AB, ContactManifold& out) {
  finishWithOne(X_AB.translation + kDown * b.half_size.x, out);
}

void planeAgainstEllipsoid(const CollisionShape&, const CollisionShape& b, const Pose& X_AB, ContactManifold& out) {
  finishWithOne(X_AB * supportPoint(b, applyTransposed(X_AB.rotation, kDown)), out);
}

void planeAgainstBox(const CollisionShape&, const CollisionShape& b, const Pose& X_AB, ContactManifold& out) {
  const Rotation3& R = X_AB.rotation;
  const Vector3 x = R.x * b.half_size.x, y = R.y * b.half_size.y, z = R.z * b.half_size.z;
  CandidatePoints candidates;
  for (int corner = 0; corner < 8; ++corner) {
    const Vector3 p = X_AB.translation + ((corner & 1) != 0 ? x : -x) + ((corner & 2) != 0 ? y : -y);
    addLowPoint(p + ((corner & 4) != 0 ? z : -z), corner, candidates);
  }
  finish(candidates, out);
}

void planeAgainstCapsule(const CollisionShape&, const CollisionShape& b, const Pose& X_AB, ContactManifold& out) {
  CandidatePoints candidates;
  const Vector3 half_axis = X_AB.rotation.z * b.half_size.z, low = X_AB.translation + kDown * b.half_size.x;
  addLowPoint(low - half_axis, 0, candidates);
  addLowPoint(low + half_axis, 1, candidates);
  finish(candidates, out);
}

void planeAgainstCylinder(const CollisionShape&, const CollisionShape& b, const Pose& X_AB, ContactManifold& out) {
  const double radius = b.half_size.x, half_length = b.half_size.z;
  const Vector3 down_B = applyTransposed(X_AB.rotation, kDown);
  const double slope = sqrt(down_B.x * down_B.x + down_B.y * down_B.y);
  const double per_slope = slope > 0 ? 1 / slope : 0.0;
  Vector3 rim[kRimPoints];
  const int lowest = placeOnRim(down_B.x * per_slope, down_B.y * per_slope, rim);
  const int lower_disc = down_B.z < 0 ? 0 : 1;
  const Vector3 to_lower{0, 0, lower_disc == 1 ? half_length : -half_length};
  CandidatePoints candidates;
  for (int i = 0; i < kRimPoints; ++i)
    addLowPoint(X_AB * (rim[i] * radius + to_lower), kRimPoints * lower_disc + i, candidates);
  addLowPoint(X_AB * (rim[lowest] * radius - to_lower), kRimPoints * (1 - lower_disc) + lowest, candidates);
  finish(candidates, out);
}

void planeAgainstConvex(const CollisionShape&, const CollisionShape& b, const Pose& X_AB, ContactManifold& out) {
  // A hull of many vertices may have more low ones than there is room for: what counts of a full list is kept.
  CandidatePoints candidates;
  out.normal = kDown;
  const int vertices = static_cast<int>(b.hull->vertices().size());
  for (int i = 0; i < vertices; ++i) {
    if (candidates.count == CandidatePoints::kMost) {
      chooseFour(candidates, out);
      candidates.count = 0;
      for (int k = 0; k < out.count; ++k) candidates.points[candidates.count++] = out.points[k];
    }
    addLowPoint(X_AB * b.hull->vertex(i), i, candidates);
  }
  finish(candidates, out);
}

}  // namespace murosimf
