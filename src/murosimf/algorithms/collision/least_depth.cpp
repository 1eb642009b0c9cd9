#include "murosimf/algorithms/collision/least_depth.h"

#include <limits>

#include "murosimf/algorithms/collision/growing_hull.h"
#include "murosimf/algorithms/collision/unset_array.h"

namespace murosimf {
namespace {

constexpr int kPoints = 64, kTriangles = 2 * kPoints + 32;
constexpr double kTolerance = 1e-7, kRelativeTolerance = 1e-4;  // [m], of the depth
constexpr double kCoplanar = 1e-13;                             // [m] above a triangle that still lies in its plane

class DepthSearch {
 public:
  DepthSearch(const ConvexPair& pair, const Vector3& start)
      : pair_(pair), hull_({difference_.all(), triangles_.all(), rim_.all(), free_.all()}) {
    whole_ = startTetrahedron(start);
  }

  LeastDepth run() {
    while (whole_) {
      const int nearest = nearestTriangle();
      if (nearest < 0) break;
      const HullTriangle& t = hull_.triangle(nearest);
      const double depth = addSupport(t.normal);
      if (depth < best_.depth) best_ = {depth, t.normal, {}};
      if (depth <= 0 || depth - t.offset <= tolerance(depth)) break;
      if (count_ == kPoints) break;
      whole_ = hull_.add(count_ - 1, nearest, kCoplanar);
    }
    if (best_.depth > 0) interpolate();
    return best_;
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
  static double tolerance(double depth) { return kTolerance + kRelativeTolerance * depth; }

  /// Where the origin's foot stands in a triangle: its shares of the corners, negative outside.
  struct Foot {
    double share[3] = {1, 0, 0};
    std::size_t corner[3] = {0, 0, 0};
    Vector3 normal;
    double inside = -std::numeric_limits<double>::infinity();  // the least share
  };
  Foot footIn(const HullTriangle& t) const {
    Foot foot;
    for (int k = 0; k < 3; ++k) foot.corner[k] = static_cast<std::size_t>(t.vertex[k]);
    const Vector3 &a = difference_[foot.corner[0]], &b = difference_[foot.corner[1]], &c = difference_[foot.corner[2]];
    const Vector3 across = cross(b - a, c - a);
    const double per_area = 1 / dot(t.normal, across);
    foot.share[0] = dot(t.normal, cross(b, c)) * per_area;
    foot.share[1] = dot(t.normal, cross(c, a)) * per_area;
    foot.share[2] = dot(t.normal, cross(a, b)) * per_area;
    foot.normal = t.normal;
    foot.inside = min(foot.share[0], min(foot.share[1], foot.share[2]));
    return foot;
  }
  /// A flat part of the surface is made of several triangles that are all nearest; the one in which the foot stands
  /// tells the points.
  Foot bestFoot() const {
    Foot best;
    const int nearest = nearestTriangle();
    if (nearest < 0) return best;
    const double limit = hull_.triangle(nearest).offset + tolerance(best_.depth);
    for (int i = 0; i < hull_.used(); ++i) {
      const HullTriangle& t = hull_.triangle(i);
      if (!t.alive || t.thin || t.offset > limit) continue;
      const Foot foot = footIn(t);
      if (foot.inside > best.inside) best = foot;
    }
    return best;
  }
  /// Points by the foot's shares, and the normal too, if that is shallower: on a smooth surface.
  void interpolate() {
    Foot foot = bestFoot();
    double sum = 0;
    for (double& s : foot.share) s = max(s, 0.0), sum += s;
    best_.midpoint = {};
    Vector3 smooth;
    for (int k = 0; k < 3; ++k) {
      best_.midpoint += middle_[foot.corner[k]] * (foot.share[k] / sum);
      smooth += direction_[foot.corner[k]] * (foot.share[k] / sum);
    }
    // The normal of another triangle may be a trace shallower, but belongs to other points.
    LeastDepth found = best_;
    found.depth += tolerance(found.depth);
    attempt(foot.normal, found);
    if (squaredNorm(smooth) > 0.25) attempt(normalized(smooth), found);
    if (!(found.normal == best_.normal)) best_ = found;
  }
  void attempt(const Vector3& n, LeastDepth& found) const {
    const double depth = pair_.depthAlong(n);
    if (depth < found.depth) found.depth = depth, found.normal = n;
  }

  const ConvexPair& pair_;
  UnsetArray<Vector3, kPoints + 1> difference_, middle_, direction_;
  UnsetArray<HullTriangle, kTriangles> triangles_;
  UnsetArray<HullRim, kTriangles> rim_;
  UnsetArray<int, kTriangles> free_;
  GrowingHull hull_;
  int count_ = 0;
  bool whole_ = false;
  LeastDepth best_;
};

}  // namespace

LeastDepth leastDepth(const ConvexPair& pair, const Vector3& start) { return DepthSearch(pair, start).run(); }

}  // namespace murosimf
