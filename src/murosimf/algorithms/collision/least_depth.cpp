#include "murosimf/algorithms/collision/least_depth.h"

#include <limits>

#include "murosimf/algorithms/collision/growing_hull.h"

namespace murosimf {
namespace {

constexpr int kPoints = 64, kTriangles = 2 * kPoints + 32;
constexpr double kTolerance = 1e-7, kRelativeTolerance = 1e-4;  // [m], of the depth
constexpr double kCoplanar = 1e-13;                             // [m] above a triangle that still lies in its plane

class DepthSearch {
 public:
  DepthSearch(const ConvexPair& pair, const Vector3& start)
      : pair_(pair), hull_({difference_, triangles_, rim_, free_}) {
    whole_ = startTetrahedron(start);
  }

  LeastDepth run() {
    while (whole_) {
      const int nearest = nearestTriangle();
      if (nearest < 0) break;
      const HullTriangle& t = hull_.triangle(nearest);
      const double depth = addSupport(t.normal);
      keepBest(t, depth);
      if (depth <= 0 || depth - t.offset <= kTolerance + kRelativeTolerance * depth) break;
      if (count_ == kPoints) break;
      whole_ = hull_.add(count_ - 1, nearest, kCoplanar);
    }
    return best_.depth <= 0 || !found_ ? best_ : interpolated();
  }

 private:
  /// @return h(n)
  double addSupport(const Vector3& n) {
    const auto i = static_cast<std::size_t>(count_++);
    const Vector3 p_a = pair_.supportOfA(-n), p_b = pair_.supportOfB(n);
    difference_[i] = p_b - p_a;
    middle_[i] = (p_a + p_b) * 0.5;
    direction_[i] = n;
    return dot(n, difference_[i]);
  }
  /// Takes the farther one of the support points along n and -n, measured from point 0.
  void addFarther(const Vector3& n) {
    const double along = dot(n, difference_[0]);
    const double ahead = addSupport(n) - along;
    const double behind = addSupport(-n) + along;
    --count_;
    if (behind <= ahead) return;
    const auto i = static_cast<std::size_t>(count_);
    difference_[i - 1] = difference_[i];
    middle_[i - 1] = middle_[i];
    direction_[i - 1] = direction_[i];
  }
  /// @return false if a direction separates the shapes or they have no volume
  bool startTetrahedron(const Vector3& start) {
    best_ = {addSupport(start), start, middle_[0]};
    if (best_.depth <= 0) return false;
    addSupport(-start);
    const Vector3 axis = difference_[1] - difference_[0];
    const Vector3 x = abs(axis.x) < abs(axis.y) ? Vector3{1, 0, 0} : Vector3{0, 1, 0};
    addFarther(normalized(cross(axis, x)));
    const Vector3 across = cross(axis, difference_[2] - difference_[0]);
    addFarther(normalized(across));
    return hull_.start({0, 1, 2, 3});
  }
  int nearestTriangle() const {
    int nearest = -1;
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < hull_.used(); ++i) {
      const HullTriangle& t = hull_.triangle(i);
      if (t.offset < least && !t.thin) least = t.offset, nearest = i;
    }
    return nearest;
  }
  void keepBest(const HullTriangle& t, double depth) {
    if (found_ && depth >= best_.depth) return;
    found_ = true;
    best_ = {depth, t.normal, {}};
    for (int k = 0; k < 3; ++k) corner_[k] = static_cast<std::size_t>(t.vertex[k]);
  }
  /// The origin's foot in the best triangle, by its shares of the corners.
  LeastDepth interpolated() const {
    const Vector3 &a = difference_[corner_[0]], &b = difference_[corner_[1]], &c = difference_[corner_[2]];
    const Vector3& n = best_.normal;
    double share[3] = {dot(n, cross(b, c)), dot(n, cross(c, a)), dot(n, cross(a, b))};
    double sum = 0;
    for (double& s : share) s = max(s, 0.0), sum += s;
    LeastDepth result = best_;
    if (!(sum > 0)) {
      result.midpoint = middle_[corner_[0]];
      return result;
    }
    Vector3 smooth;
    for (int k = 0; k < 3; ++k) {
      result.midpoint += middle_[corner_[k]] * (share[k] / sum);
      smooth += direction_[corner_[k]] * (share[k] / sum);
    }
    if (squaredNorm(smooth) < 0.25) return result;
    smooth = normalized(smooth);
    const double depth = pair_.depthAlong(smooth);
    if (depth < result.depth) result.depth = depth, result.normal = smooth;
    return result;
  }

  const ConvexPair& pair_;
  Vector3 difference_[kPoints + 1], middle_[kPoints + 1], direction_[kPoints + 1];
  HullTriangle triangles_[kTriangles];
  HullRim rim_[kTriangles];
  int free_[kTriangles];
  GrowingHull hull_;
  int count_ = 0;
  bool whole_ = false, found_ = false;
  LeastDepth best_;
  std::size_t corner_[3] = {0, 0, 0};
};

}  // namespace

LeastDepth leastDepth(const ConvexPair& pair, const Vector3& start) { return DepthSearch(pair, start).run(); }

}  // namespace murosimf
