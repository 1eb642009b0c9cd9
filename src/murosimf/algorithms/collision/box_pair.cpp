// Two boxes: separating axes, then the corners of what their faces share.
#include "murosimf/algorithms/collision/collision_pairs.h"
#include "murosimf/algorithms/collision/line_distance.h"
#include "murosimf/algorithms/collision/surface_feature.h"

namespace murosimf {
namespace {

/// Edges win over faces only when they are this much shallower: a face gives up to four points, an edge one.
constexpr double kEdgeShare = 0.992, kEdgeMargin = 1e-6;  // of the depth; [m]
constexpr double kParallel = 1e-6;                        // sine between edges whose product is no axis any more
constexpr double kSameAxis = 0.98;                        // cosine to the last normal within which it is kept

/// Whether one of the 15 axes surely separates the boxes: most pairs that are looked at, found without a root or a
/// division. Edges' axes are not of unit length here; kSlack covers the rounding of those that are nearly parallel.
bool surelyApart(const Vector3& a, const Vector3& b, const Pose& X_AB) {
  constexpr double kSlack = 1e-9;
  const Vector3& t = X_AB.translation;
  const Vector3 columns[3] = {X_AB.rotation.x, X_AB.rotation.y, X_AB.rotation.z};
  Vector3 size[3];  // of the columns' components
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i < 3; ++i) size[j][i] = abs(columns[j][i]) + kSlack;
  }
  for (int i = 0; i < 3; ++i)
    if (abs(t[i]) > a[i] + size[0][i] * b.x + size[1][i] * b.y + size[2][i] * b.z) return true;
  for (int j = 0; j < 3; ++j)
    if (abs(dot(t, columns[j])) > b[j] + dot(a, size[j])) return true;
  for (int i = 0; i < 3; ++i) {
    const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
    for (int j = 0; j < 3; ++j) {
      const int j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      const double along = abs(t[i2] * columns[j][i1] - t[i1] * columns[j][i2]);
      if (along > a[i1] * size[j][i2] + a[i2] * size[j][i1] + b[j1] * size[j2][i] + b[j2] * size[j1][i]) return true;
    }
  }
  return false;
}

/// One of the 15 axes: n points from B to A, and the boxes overlap by depth along it. Edges: i of A, j of B.
struct Axis {
  Vector3 normal;
  double depth = 0;
  int i = -1, j = -1;
  bool isEdge() const { return i >= 0; }
};

class SeparatingAxes {
 public:
  SeparatingAxes(const Vector3& a, const Vector3& b, const Pose& X_AB) : a_(a), b_(b), X_(X_AB) {
    for (int i = 0; i < 3; ++i) axis_of_a_[i][i] = 1;
    axis_of_b_[0] = X_.rotation.x, axis_of_b_[1] = X_.rotation.y, axis_of_b_[2] = X_.rotation.z;
  }
  /// @return false if an axis separates the boxes
  bool search(const Vector3& hint) {
    hint_ = hint;
    for (int i = 0; i < 3; ++i)
      if (!tryFace(axis_of_a_[i]) || !tryFace(axis_of_b_[i])) return false;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        if (!tryEdges(i, j)) return false;
    return true;
  }
  Axis best() const {
    const double thinner = min(min(a_.x, min(a_.y, a_.z)), min(b_.x, min(b_.y, b_.z)));
    const Axis& shallowest = edge_.isEdge() && edge_.depth < kEdgeShare * face_.depth - kEdgeMargin ? edge_ : face_;
    const bool deep = shallowest.depth > 0.5 * thinner && hinted_along_ > kSameAxis;
    return deep ? hinted_ : shallowest;
  }
  const Vector3& edgeOfB(int j) const { return axis_of_b_[j]; }

 private:
  bool tryFace(const Vector3& axis) { return take(axis, -1, -1, face_); }
  bool tryEdges(int i, int j) {
    const Vector3 across = cross(axis_of_a_[i], axis_of_b_[j]);
    const double sine = norm(across);
    return sine < kParallel || take(across * (1 / sine), i, j, edge_);
  }
  bool take(const Vector3& axis, int i, int j, Axis& least) {
    const Vector3 axis_B = applyTransposed(X_.rotation, axis);
    const double apart = dot(axis, X_.translation);
    const double reach_a = a_.x * abs(axis.x) + a_.y * abs(axis.y) + a_.z * abs(axis.z);
    const double reach_b = b_.x * abs(axis_B.x) + b_.y * abs(axis_B.y) + b_.z * abs(axis_B.z);
    const Axis found{apart > 0 ? -axis : axis, reach_a + reach_b - abs(apart), i, j};
    if (!(found.depth > 0)) return false;
    if (!taken_ || found.depth < least.depth || (i >= 0 && !least.isEdge())) least = found;
    taken_ = true;
    const double along = abs(dot(hint_, axis));
    if (along > hinted_along_) {
      const Vector3 normal = dot(hint_, axis) < 0 ? -axis : axis;
      hinted_along_ = along, hinted_ = {normal, reach_a + reach_b + dot(normal, X_.translation), i, j};
    }
    return true;
  }

  Vector3 a_, b_;
  Pose X_;
  Vector3 axis_of_a_[3], axis_of_b_[3];
  Vector3 hint_;
  bool taken_ = false;
  Axis face_, edge_, hinted_;
  double hinted_along_ = 0;
};

void pointOfEdges(const Vector3& a, const CollisionShape& b, const Pose& X_AB, const Axis& axis, const Vector3& edge_b,
                  ContactManifold& out) {
  const Vector3 &n = axis.normal, n_B = applyTransposed(X_AB.rotation, n);
  Vector3 p_A, p_B = supportPoint(b, n_B), edge_a;
  for (int k = 0; k < 3; ++k) p_A[k] = k == axis.i ? 0.0 : n[k] > 0 ? -a[k] : a[k];
  edge_a[axis.i] = 1;
  p_B[axis.j] = 0;
  const auto feature = static_cast<std::uint32_t>(1 + 3 * axis.i + axis.j);
  out.points[0] = {midpointOfLines(p_A, edge_a, X_AB * p_B, edge_b), axis.depth, feature};
  out.count = 1;
}

Vector3 clamped(const Vector3& p, const Vector3& a) {
  return {clamp(p.x, -a.x, a.x), clamp(p.y, -a.y, a.y), clamp(p.z, -a.z, a.z)};
}

}  // namespace

void boxAgainstBox(const CollisionShape& a, const CollisionShape& b, const Pose& X_AB, const Vector3& hint,
                   ContactManifold& out) {
  out.count = 0;
  if (surelyApart(a.half_size, b.half_size, X_AB)) return;
  SeparatingAxes axes(a.half_size, b.half_size, X_AB);
  if (!axes.search(hint)) return;
  const Axis axis = axes.best();
  out.normal = axis.normal;
  if (axis.isEdge()) return pointOfEdges(a.half_size, b, X_AB, axis, axes.edgeOfB(axis.j), out);
  const Vector3 n_B = applyTransposed(X_AB.rotation, axis.normal);
  SurfaceFeature face_a, face_b;
  facingFaceOfBox(a.half_size, -axis.normal, face_a);
  facingFaceOfBox(b.half_size, n_B, face_b);
  transformFeature(X_AB, face_b);
  // The face belongs to one of the boxes; the other one's farthest corner is the deepest.
  const bool face_of_a = dot(face_a.normal, axis.normal) < -dot(face_b.normal, axis.normal);
  const Vector3 tip = face_of_a ? clamped(X_AB * supportPoint(b, n_B), a.half_size) - axis.normal * (0.5 * axis.depth)
                                : X_AB * clamped(applyInverse(X_AB, supportPoint(a, -axis.normal)), b.half_size) +
                                      axis.normal * (0.5 * axis.depth);
  pointsBetween(face_a, face_b, {axis.depth, tip}, out);
}

}  // namespace murosimf
