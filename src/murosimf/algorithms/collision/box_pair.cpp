// Two boxes: separating axes, then the corners of what their faces share.
#include <limits>

#include "murosimf/algorithms/collision/collision_pairs.h"
#include "murosimf/algorithms/collision/line_distance.h"
#include "murosimf/algorithms/collision/surface_feature.h"

namespace murosimf {
namespace {

/// Edges win over faces only when they are this much shallower: a face gives up to four points, an edge one.
constexpr double kEdgeShare = 0.992, kEdgeMargin = 1e-6;  // of the depth; [m]
constexpr double kParallel = 1e-6;                        // sine between edges whose product is no axis any more
constexpr double kSameAxis = 0.98;                        // cosine to the last normal within which it is kept

/// One of the 15 axes: n points from B to A, and the boxes overlap by depth along it. Edges: i of A, j of B.
struct Axis {
  Vector3 normal;
  double depth = 0;
  int i = -1, j = -1;
  bool isEdge() const { return i >= 0; }
};

/// The axis along which two boxes overlap least. Products of edges are compared without making them of unit length:
/// most pairs have none that wins over the faces.
class SeparatingAxes {
 public:
  SeparatingAxes(const Vector3& a, const Vector3& b, const Pose& X_AB) : a_(a), b_(b), X_(X_AB) {
    for (int i = 0; i < 3; ++i) axis_of_a_[i][i] = 1;
    axis_of_b_[0] = X_.rotation.x, axis_of_b_[1] = X_.rotation.y, axis_of_b_[2] = X_.rotation.z;
    for (int j = 0; j < 3; ++j) {
      for (int i = 0; i < 3; ++i) size_[j][i] = abs(axis_of_b_[j][i]);
    }
  }
  /// @return false if an axis separates the boxes
  bool search() { return searchFaces() && searchEdges(); }
  /// A lower bound of their distance, where an axis does.
  double apart() const { return apart_; }
  Axis best(const Vector3& hint) const {
    const Axis least = edge_i_ < 0 ? along(face_) : along(edgeAxis(edge_i_, edge_j_), edge_i_, edge_j_);
    const double thinner = min(min(a_.x, min(a_.y, a_.z)), min(b_.x, min(b_.y, b_.z)));
    return least.depth > 0.5 * thinner ? nearest(hint, least) : least;
  }
  const Vector3& edgeOfB(int j) const { return axis_of_b_[j]; }

 private:
  bool searchFaces() {
    const Vector3& t = X_.translation;
    const auto take = [&](double depth, const Vector3& axis) {
      if (depth < face_depth_) face_depth_ = depth, face_ = axis;
    };
    for (int i = 0; i < 3; ++i) {
      take(a_[i] + size_[0][i] * b_.x + size_[1][i] * b_.y + size_[2][i] * b_.z - abs(t[i]), axis_of_a_[i]);
      take(b_[i] + dot(a_, size_[i]) - abs(dot(t, axis_of_b_[i])), axis_of_b_[i]);
    }
    apart_ = -face_depth_;
    return face_depth_ > 0;
  }
  /// With e_i x f_j, of length s: the overlap along it is `scaled` / s.
  bool searchEdges() {
    const Vector3& t = X_.translation;
    const double limit = max(0.0, kEdgeShare * face_depth_ - kEdgeMargin);
    double least_squared = limit * limit;
    for (int i = 0; i < 3; ++i) {
      const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
      for (int j = 0; j < 3; ++j) {
        const int j1 = (j + 1) % 3, j2 = (j + 2) % 3;
        const Vector3 &f = axis_of_b_[j], &size = size_[j];
        const double squared_sine = f[i1] * f[i1] + f[i2] * f[i2];
        if (squared_sine < kParallel * kParallel) continue;
        const double reach = a_[i1] * size[i2] + a_[i2] * size[i1] + b_[j1] * size_[j2][i] + b_[j2] * size_[j1][i];
        const double scaled = reach - abs(t[i2] * f[i1] - t[i1] * f[i2]);
        apart_ = -scaled;
        if (!(scaled > 0)) return false;
        if (scaled * scaled >= least_squared * squared_sine) continue;
        least_squared = scaled * scaled / squared_sine;
        edge_i_ = i, edge_j_ = j;
      }
    }
    return true;
  }
  Vector3 edgeAxis(int i, int j) const { return normalized(cross(axis_of_a_[i], axis_of_b_[j])); }
  /// The overlap along a normal whose sign is given, and along an axis whose sign is not.
  double depthAlong(const Vector3& normal) const {
    const Vector3 normal_B = applyTransposed(X_.rotation, normal);
    return a_.x * abs(normal.x) + a_.y * abs(normal.y) + a_.z * abs(normal.z) + b_.x * abs(normal_B.x) +
           b_.y * abs(normal_B.y) + b_.z * abs(normal_B.z) + dot(normal, X_.translation);
  }
  Axis along(const Vector3& axis, int i = -1, int j = -1) const {
    const Vector3 normal = dot(axis, X_.translation) > 0 ? -axis : axis;
    return {normal, depthAlong(normal), i, j};
  }
  /// The axis nearest to the last normal, where there is one near it.
  Axis nearest(const Vector3& hint, const Axis& least) const {
    Axis found = least;
    double nearest = kSameAxis;
    const auto attempt = [&](const Vector3& axis, int i, int j) {
      const double cosine = dot(hint, axis);
      if (!(abs(cosine) > nearest)) return;
      const Vector3 normal = cosine < 0 ? -axis : axis;
      nearest = abs(cosine), found = {normal, depthAlong(normal), i, j};
    };
    for (int i = 0; i < 3; ++i) attempt(axis_of_a_[i], -1, -1), attempt(axis_of_b_[i], -1, -1);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        if (squaredNorm(cross(axis_of_a_[i], axis_of_b_[j])) >= kParallel * kParallel) attempt(edgeAxis(i, j), i, j);
    return found;
  }

  Vector3 a_, b_;
  Pose X_;
  Vector3 axis_of_a_[3], axis_of_b_[3];
  Vector3 size_[3];  // of the components of B's axes
  Vector3 face_;
  double face_depth_ = std::numeric_limits<double>::infinity(), apart_ = 0;
  int edge_i_ = -1, edge_j_ = -1;  // where edges win over faces
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
  SeparatingAxes axes(a.half_size, b.half_size, X_AB);
  if (!axes.search()) {
    out.apart = axes.apart();
    return;
  }
  const Axis axis = axes.best(hint);
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
