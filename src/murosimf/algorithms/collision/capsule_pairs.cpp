// A capsule against a capsule and a box: what lies within a radius of a segment. Along the segment's unit direction u
// from its middle c a point is c + t u, |t| <= l.
#include <utility>

#include "murosimf/algorithms/collision/collision_pairs.h"
#include "murosimf/algorithms/collision/line_distance.h"
#include "murosimf/algorithms/sphere_contact.h"

namespace murosimf {
namespace {

struct Segment {
  Vector3 c, u;
  double l;
  Vector3 at(double t) const { return plusScaled(c, u, t); }
};

constexpr double kNearlyParallel = 0.01;  // sine of the angle between axes that are given several points
constexpr double kParallel = 1e-9;        // below this sine no point of the axes is nearest
constexpr double kTouching = 1e-10;       // [m] distance of axes that has no sure direction any more

/// Two capsules. A's axis is z of its frame, so that its point s is (0, 0, s).
class TwoCapsules {
 public:
  TwoCapsules(const CollisionShape& a, const Segment& b, double radius_b)
      : a_(a.half_size), b_(b), reach_(a_.x + radius_b), sine_(sqrt(b.u.x * b.u.x + b.u.y * b.u.y)) {}

  void findContacts(ContactManifold& out) {
    CandidatePoints candidates;
    const double s = nearest();
    const double t = clamp(dot(b_.u, Vector3{0, 0, s} - b_.c), -b_.l, b_.l);
    const Vector3 gap = Vector3{0, 0, s} - b_.at(t);
    out.apart = norm(gap) - reach_;
    setNormal(gap, out.normal);
    bool single = true;
    if (sine_ < kNearlyParallel) single = !addEnds(s, out.normal, candidates);
    if (single) add(s, t, out.normal, 0, candidates);
    chooseFour(candidates, out);
  }

 private:
  /// The point of A's axis nearest to B's [Ericson 2005, 5.1.9].
  double nearest() const {
    const double square = sine_ * sine_, along = b_.u.z, c_along = dot(b_.u, b_.c);
    double s = sine_ > kParallel ? clamp((b_.c.z - along * c_along) / square, -a_.z, a_.z) : 0.0;
    const double t = clamp(s * along - c_along, -b_.l, b_.l);
    return clamp(b_.c.z + t * along, -a_.z, a_.z);
  }
  void setNormal(const Vector3& gap, Vector3& normal) const {
    const double distance = norm(gap);
    if (distance > kTouching) {
      normal = gap * (1 / distance);
    } else if (sine_ > kParallel) {  // crossing axes: across both
      normal = Vector3{-b_.u.y, b_.u.x, 0} * (1 / sine_);
    } else {
      normal = {1, 0, 0};
    }
  }
  void add(double s, double t, const Vector3& n, std::uint32_t feature, CandidatePoints& out) const {
    const Vector3 p_a{0, 0, s}, p_b = b_.at(t);
    const Vector3 middle = (p_a + p_b + n * (reach_ - 2 * a_.x)) * 0.5;
    out.add(middle, reach_ - norm(p_a - p_b), feature);
  }
  /// Both ends of what nearly parallel axes share, and the nearest point if it lies between. @return false if they
  /// share nothing
  bool addEnds(double s, const Vector3& normal, CandidatePoints& out) const {
    const double half = b_.l * abs(b_.u.z);
    const double low = max(-a_.z, b_.c.z - half), high = min(a_.z, b_.c.z + half);
    if (!(high > low)) return false;
    const auto partner = [&](double z) { return clamp((z - b_.c.z) / b_.u.z, -b_.l, b_.l); };
    const double margin = 0.01 * (high - low);
    const bool nearest_is_low = s<low + margin, nearest_is_high = s> high - margin;
    const bool parallel = sine_ < kParallel;
    const auto addNearest = [&](std::uint32_t feature) {
      add(s, clamp(dot(b_.u, Vector3{0, 0, s} - b_.c), -b_.l, b_.l), normal, feature, out);
    };
    if (nearest_is_low && !parallel)
      addNearest(1);
    else
      add(low, partner(low), normal, 1, out);
    if (nearest_is_high && !parallel)
      addNearest(2);
    else
      add(high, partner(high), normal, 2, out);
    if (!parallel && !nearest_is_low && !nearest_is_high) addNearest(3);
    return true;
  }

  Vector3 a_;
  Segment b_;
  double reach_, sine_;
};

/// How far p lies outside a box along each axis, signed; zero within its extent.
Vector3 excess(const Vector3& p, const Vector3& a) {
  return {p.x - clamp(p.x, -a.x, a.x), p.y - clamp(p.y, -a.y, a.y), p.z - clamp(p.z, -a.z, a.z)};
}

void sort(double* values, int count) {
  for (int i = 1; i < count; ++i)
    for (int k = i; k > 0 && values[k] < values[k - 1]; --k) std::swap(values[k], values[k - 1]);
}

/// The t of the segment's point nearest to the box. The slope u.excess(t) of half the squared distance never falls and
/// is linear between the places where the segment crosses one of the six planes of the faces, so the root is found
/// between two of these; the middle where many points are nearest.
double nearestToBox(const Segment& segment, const Vector3& a) {
  double t[8] = {-segment.l, segment.l};
  int count = 2;
  for (int k = 0; k < 3; ++k)
    for (const double side : {-a[k], a[k]}) {
      const double crossing = (side - segment.c[k]) / segment.u[k];
      if (abs(crossing) < segment.l) t[count++] = crossing;
    }
  sort(t, count);
  const auto slope = [&](double at) { return dot(segment.u, excess(segment.at(at), a)); };
  double begin = t[0], end = t[count - 1];
  double last = slope(begin);
  if (last > 0) return begin;
  for (int i = 1; i < count; ++i) {
    const double here = slope(t[i]);
    if (last < 0 && here >= 0) begin = fma(t[i] - t[i - 1], last / (last - here), t[i - 1]);
    if (last <= 0 && here > 0) {
      end = last < 0 ? begin : t[i - 1];
      break;
    }
    last = here;
  }
  if (last < 0) return end;
  return 0.5 * (begin + end);
}

/// A box, A, and a capsule, B, in the box's frame.
class BoxAndCapsule {
 public:
  BoxAndCapsule(const Vector3& half_size, const Segment& segment, double radius)
      : a_(half_size), b_(segment), radius_(radius) {}

  void findContacts(ContactManifold& out) {
    const double t = nearestToBox(b_, a_);
    const Vector3 p = b_.at(t), gap = excess(p, a_);
    const double distance = norm(gap);
    out.apart = distance - radius_;
    if (distance >= radius_) return;
    if (distance <= kTouching) return findInside(out);
    CandidatePoints candidates;
    out.normal = gap * (-1 / distance);
    const double depth = radius_ - distance;
    const Vector3 middle = p + out.normal * (0.5 * (radius_ + distance));
    const int axis = mainAxisOf(out.normal);
    if (abs(out.normal[axis]) > kFlat) addAlongFace(axis, -out.normal[axis], candidates);
    finish(middle, depth, candidates, out);
  }

 private:
  static constexpr double kFlat = 0.99863;  // cosine of 3 degrees between normal and face

  static int mainAxisOf(const Vector3& n) {
    const int axis = abs(n.y) > abs(n.x) ? 1 : 0;
    return abs(n.z) > abs(n[axis]) ? 2 : axis;
  }
  /// Both ends of the part of the segment that lies over (or under) a face.
  void addAlongFace(int axis, double side, CandidatePoints& out) const {
    double begin = -b_.l, end = b_.l;
    for (int k = 0; k < 3; ++k) {
      if (k == axis) continue;
      const double slope = b_.u[k];
      if (slope == 0) {
        if (abs(b_.c[k]) > a_[k]) return;
        continue;
      }
      const double low = ((slope > 0 ? -a_[k] : a_[k]) - b_.c[k]) / slope;
      const double high = ((slope > 0 ? a_[k] : -a_[k]) - b_.c[k]) / slope;
      begin = max(begin, low), end = min(end, high);
    }
    if (begin > end) return;
    const double outward = side < 0 ? -1.0 : 1.0;
    const auto name = static_cast<std::uint32_t>(4 * (2 * axis + (side < 0 ? 1 : 0)));
    for (const double t : {begin, end}) {
      Vector3 p = b_.at(t);
      const double height = outward * p[axis] - a_[axis];
      p[axis] -= outward * 0.5 * (radius_ + height);
      out.add(p, radius_ - height, name + (t > begin ? 2 : 1));
      if (begin == end) break;
    }
  }
  /// The exact deepest point joins what the face gives, unless it is there already.
  void finish(const Vector3& middle, double depth, CandidatePoints& candidates, ContactManifold& out) const {
    constexpr double kSame = 1e-12;  // [m]
    double most = 0;
    for (int i = 0; i < candidates.count; ++i) most = max(most, candidates.points[i].depth);
    if (most < depth - kSame) candidates.add(middle, depth, 0);
    chooseFour(candidates, out);
  }
  /// The axis runs through the box: shortest way out over the normals of box + segment, which are the faces' and the
  /// products of edges with the segment.
  void findInside(ContactManifold& out) {
    int best = -1;
    double least = 0;
    Vector3 normal;
    const auto attempt = [&](const Vector3& w, int number) {
      const double apart = dot(w, b_.c);
      const double depth = a_.x * abs(w.x) + a_.y * abs(w.y) + a_.z * abs(w.z) + b_.l * abs(dot(w, b_.u)) - abs(apart);
      if (best >= 0 && !(depth < least)) return;
      best = number, least = depth, normal = apart > 0 ? -w : w;
    };
    for (int k = 0; k < 3; ++k) {
      Vector3 face;
      face[k] = 1;
      attempt(face, k);
    }
    for (int k = 0; k < 3; ++k) {
      Vector3 edge;
      edge[k] = 1;
      const Vector3 across = cross(edge, b_.u);
      const double sine = norm(across);
      if (sine > kParallel) attempt(across * (1 / sine), 3 + k);
    }
    out.normal = normal;
    CandidatePoints candidates;
    const double depth = radius_ + least;
    if (best < 3) addAlongFace(best, -normal[best], candidates);
    finish(best < 3 ? tipInFace(normal, depth) : pointOnEdge(best - 3, normal), depth, candidates, out);
  }
  Vector3 tipInFace(const Vector3& n, double depth) const {
    const Vector3 tip = b_.at(dot(n, b_.u) < 0 ? -b_.l : b_.l);
    return tip + n * (radius_ - 0.5 * depth);
  }
  /// Midway between edge and axis, and half a radius on: between edge and surface.
  Vector3 pointOnEdge(int k, const Vector3& n) const {
    Vector3 p, edge;
    for (int m = 0; m < 3; ++m) p[m] = m == k ? 0.0 : n[m] > 0 ? -a_[m] : a_[m];
    edge[k] = 1;
    return midpointOfLines(p, edge, b_.c, b_.u) + n * (0.5 * radius_);
  }

  Vector3 a_;
  Segment b_;
  double radius_;
};

Segment axisOf(const CollisionShape& capsule, const Pose& X) {
  return {X.translation, X.rotation.z, capsule.half_size.z};
}

}  // namespace

void capsuleAgainstCapsule(const CollisionShape& a, const CollisionShape& b, const Pose& X_AB, ContactManifold& out) {
  TwoCapsules(a, axisOf(b, X_AB), b.half_size.x).findContacts(out);
}

void boxAgainstCapsule(const CollisionShape& a, const CollisionShape& b, const Pose& X_AB, ContactManifold& out) {
  out.count = 0;
  BoxAndCapsule(a.half_size, axisOf(b, X_AB), b.half_size.x).findContacts(out);
}

}  // namespace murosimf
