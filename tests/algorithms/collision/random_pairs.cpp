#include "algorithms/collision/random_pairs.h"

#include <algorithm>
#include <array>
#include <deque>
#include <limits>

namespace murosimf::collision_test {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// A box of 8 corners, a prism of 6 sides, and clouds of 8 to 60 points on and in ellipsoids.
const std::deque<ConvexHull>& hulls() {
  static const std::deque<ConvexHull> all = [] {
    std::deque<ConvexHull> made;
    Dice dice(1000);
    for (int i = 0; i < 24; ++i) {
      const Vector3 size{dice.uniform(0.02, 0.15), dice.uniform(0.02, 0.15), dice.uniform(0.02, 0.15)};
      const Vector3 offset = dice.inBox(0.05);
      std::vector<Vector3> points;
      const int count = i % 4 == 0 ? 8 : i % 4 == 1 ? 12 : 8 + dice.below(53);
      for (int k = 0; k < count; ++k) {
        Vector3 p = dice.direction();
        if (i % 4 == 0) p = {(k & 1) != 0 ? 1.0 : -1.0, (k & 2) != 0 ? 1.0 : -1.0, (k & 4) != 0 ? 1.0 : -1.0};
        if (i % 4 == 1) {
          const int side = k / 2;
          p = {cos(side * kPi / 3), sin(side * kPi / 3), (k & 1) != 0 ? 1.0 : -1.0};
        }
        points.push_back(offset + Vector3{p.x * size.x, p.y * size.y, p.z * size.z});
      }
      made.emplace_back(points);
    }
    return made;
  }();
  return all;
}

/// 642 directions: an icosahedron whose triangles are divided three times.
const std::vector<Vector3>& sphereDirections() {
  static const std::vector<Vector3> all = [] {
    const double g = 0.5 * (1 + sqrt(5.0));
    std::vector<Vector3> corners;
    for (const double s : {-1.0, 1.0})
      for (const double t : {-g, g})
        for (const Vector3& p : {Vector3{0, s, t}, Vector3{s, t, 0}, Vector3{t, 0, s}})
          corners.push_back(normalized(p));
    std::vector<std::array<Vector3, 3>> triangles;
    for (std::size_t i = 0; i < 12; ++i)
      for (std::size_t j = i + 1; j < 12; ++j)
        for (std::size_t k = j + 1; k < 12; ++k)
          if (dot(corners[i], corners[j]) > 0.4 && dot(corners[j], corners[k]) > 0.4 &&
              dot(corners[k], corners[i]) > 0.4)
            triangles.push_back({corners[i], corners[j], corners[k]});
    for (int level = 0; level < 3; ++level) {
      std::vector<std::array<Vector3, 3>> finer;
      for (const auto& [p, q, r] : triangles) {
        const Vector3 pq = normalized(p + q), qr = normalized(q + r), rp = normalized(r + p);
        for (const auto& t :
             {std::array{p, pq, rp}, std::array{pq, q, qr}, std::array{rp, qr, r}, std::array{pq, qr, rp}})
          finer.push_back(t);
      }
      triangles = std::move(finer);
    }
    std::vector<Vector3> result;
    for (const auto& triangle : triangles)
      for (const Vector3& p : triangle)
        if (std::none_of(result.begin(), result.end(), [&](const Vector3& q) { return norm(p - q) < 1e-9; }))
          result.push_back(p);
    return result;
  }();
  return all;
}

Rotation3 quarterTurns(Dice& dice) {
  const double quarter = 0.5 * kPi, x = quarter * dice.below(4), y = quarter * dice.below(4);
  return rotationX(x) * (rotationY(y) * rotationZ(quarter * dice.below(4)));
}

Vector3 axisOf(const Rotation3& R, int number) { return number == 0 ? R.x : number == 1 ? R.y : R.z; }

/// Normals of faces and directions of edges in world axes.
void addFlatParts(const CollisionShape& shape, const Rotation3& R, std::vector<Vector3>& normals,
                  std::vector<Vector3>& edges) {
  if (shape.kind == CollisionKind::kBox)
    for (const Vector3& e : {R.x, R.y, R.z}) normals.push_back(e), normals.push_back(-e), edges.push_back(e);
  if (shape.kind == CollisionKind::kCapsule || shape.kind == CollisionKind::kCylinder) edges.push_back(R.z);
  if (shape.kind == CollisionKind::kCylinder) normals.push_back(R.z), normals.push_back(-R.z);
  if (shape.kind != CollisionKind::kConvex) return;
  for (const auto& face : shape.hull->faces()) {
    normals.push_back(R * face.normal);
    const auto loop = shape.hull->corners(face);
    for (std::size_t i = 0; i < loop.size(); ++i)
      if (const int k = loop[(i + 1) % loop.size()]; k > loop[i])
        edges.push_back(R * normalized(shape.hull->vertex(k) - shape.hull->vertex(loop[i])));
  }
}

struct Minimum {
  double depth;
  Vector3 normal;
};

/// Random steps downhill that shrink by `shrink` when they fail.
Minimum refined(const Pair& pair, Minimum m, double step, double shrink, Dice& dice) {
  for (; step > 1e-6; step *= shrink) {
    const Vector3 n = normalized(m.normal + dice.direction() * step);
    const double depth = overlapAlong(pair, n);
    if (depth < m.depth) m = {depth, n}, step *= 1.3;
  }
  return m;
}

/// Where a straight edge leans on something, the overlap has a kink along the great circle across the edge, in which
/// random steps get stuck. Golden sections along each circle that passes near.
Minimum alongKinks(const Pair& pair, Minimum m, const std::vector<Vector3>& edges) {
  constexpr double kGolden = 0.6180339887498949;
  for (const Vector3& u : edges) {
    if (abs(dot(u, m.normal)) > 0.1) continue;
    const Vector3 x = normalized(m.normal - u * dot(u, m.normal)), y = cross(u, x);
    const auto at = [&](double angle) {
      const Vector3 n = x * cos(angle) + y * sin(angle);
      return Minimum{overlapAlong(pair, n), n};
    };
    double low = -0.1, high = 0.1;
    while (high - low > 1e-6) {
      const double l = high - kGolden * (high - low), r = low + kGolden * (high - low);
      (at(l).depth < at(r).depth ? high : low) = at(l).depth < at(r).depth ? r : l;
    }
    if (const Minimum found = at(0.5 * (low + high)); found.depth < m.depth) m = found;
  }
  return m;
}

/// `minima`: other directions that might be as good.
bool isUnique(const Pair& pair, const Minimum& best, const std::vector<Minimum>& minima) {
  const bool boxes = pair.a.kind == CollisionKind::kBox && pair.b.kind == CollisionKind::kBox;
  const double rise = 3e-6 + 0.015 * best.depth;
  for (const Minimum& m : minima) {
    const double cosine = dot(m.normal, best.normal);
    if (cosine < 0.99985 && m.depth < best.depth + rise) return false;        // 1 degree apart
    if (cosine < 0.9962 && m.depth < 1.05 * best.depth + 2e-5) return false;  // 5 degrees apart
  }
  const Vector3 x = normalized(cross(best.normal, abs(best.normal.x) < 0.7 ? Vector3{1, 0, 0} : Vector3{0, 1, 0}));
  const Vector3 y = cross(best.normal, x);
  for (const double degrees : {1.0, 2.0, 3.5, 5.0, 7.0, 10.0})
    for (int i = 0; i < 16; ++i) {
      const double angle = 2 * kPi * i / 16, radius = degrees * kPi / 180;
      const Vector3 n = normalized(best.normal + (x * cos(angle) + y * sin(angle)) * radius);
      if (overlapAlong(pair, n) < best.depth + (degrees > 1 || boxes ? rise : 3e-6)) return false;
    }
  return true;
}

}  // namespace

std::string nameOf(CollisionKind kind) {
  constexpr const char* kNames[kCollisionKinds] = {"plane",    "sphere",    "box",   "capsule",
                                                   "cylinder", "ellipsoid", "convex"};
  return kNames[static_cast<int>(kind)];
}

bool isClosedForm(CollisionKind a, CollisionKind b) {
  if (b < a) std::swap(a, b);
  const bool box_or_capsule = b == CollisionKind::kBox || b == CollisionKind::kCapsule;
  return a <= CollisionKind::kSphere || box_or_capsule;
}

CollisionShape randomShape(CollisionKind kind, Dice& dice) {
  const double a = dice.uniform(0.02, 0.3), b = dice.uniform(0.02, 0.3), c = dice.uniform(0.02, 0.3);
  switch (kind) {
    case CollisionKind::kPlane:
      return collisionPlane();
    case CollisionKind::kBox:
      return collisionBox({a, b, c});
    case CollisionKind::kCapsule:
      return collisionCapsule(0.5 * a, b);
    case CollisionKind::kCylinder:
      return collisionCylinder(0.5 * a, b);
    case CollisionKind::kEllipsoid:
      return collisionEllipsoid({0.5 * a, dice.below(3) == 0 ? 0.5 * a : 0.5 * b, 0.5 * c});
    case CollisionKind::kConvex:
      return collisionConvex(hulls()[static_cast<std::size_t>(dice.below(static_cast<int>(hulls().size())))]);
    case CollisionKind::kSphere:
      break;
  }
  return collisionSphere(0.5 * a);
}

Pair randomPair(CollisionKind a, CollisionKind b, Dice& dice) {
  Pair pair{randomShape(a, dice), randomShape(b, dice), dice.pose(), {}, dice.below(4) == 0};
  pair.X_WB.rotation = dice.rotation();
  Vector3 direction = a == CollisionKind::kPlane ? -pair.X_WA.rotation.z : dice.direction();
  if (pair.aligned) {
    constexpr double kTilts[4] = {1e-2, 1e-5, 1e-9, 0};
    const Rotation3 turn = quarterTurns(dice);
    const Vector3 axis = dice.direction();
    const Rotation3 tilt = rotationExp(axis * kTilts[dice.below(4)]);
    pair.X_WB.rotation = pair.X_WA.rotation * turn * tilt;
    if (dice.below(2) == 0 && a != CollisionKind::kPlane) direction = axisOf(pair.X_WA.rotation, dice.below(3));
  }
  const double depth = exp(dice.uniform(log(1e-5), log(1e-2)));
  // The farthest points of both meet, up to a sideways shift that tries edges and the middle of faces too.
  const auto farthest = [](const CollisionShape& shape, const Pose& X, const Vector3& n) {
    if (shape.kind == CollisionKind::kPlane) return X.translation;
    return X * supportPoint(shape, applyTransposed(X.rotation, n));
  };
  Vector3 aside = a == CollisionKind::kPlane ? dice.inBox(3) : dice.inBox(dice.below(2) * 0.03);
  aside -= direction * dot(direction, aside);
  const Vector3 gap = farthest(pair.a, pair.X_WA, -direction) - farthest(pair.b, pair.X_WB, direction);
  pair.X_WB.translation = gap + aside + direction * depth;
  return pair;
}

double reach(const CollisionShape& shape, const Vector3& n) {
  const Vector3& a = shape.half_size;
  const double off_axis = sqrt(n.x * n.x + n.y * n.y);
  double most = -kInfinite;
  switch (shape.kind) {
    case CollisionKind::kPlane:
      return n.z > 1 - 1e-12 ? 0 : kInfinite;
    case CollisionKind::kSphere:
      return a.x;
    case CollisionKind::kBox:
      return a.x * abs(n.x) + a.y * abs(n.y) + a.z * abs(n.z);
    case CollisionKind::kCapsule:
      return a.x + a.z * abs(n.z);
    case CollisionKind::kCylinder:
      return a.x * off_axis + a.z * abs(n.z);
    case CollisionKind::kEllipsoid:
      return norm(Vector3{a.x * n.x, a.y * n.y, a.z * n.z});
    case CollisionKind::kConvex:
      for (const Vector3& v : shape.hull->vertices()) most = max(most, dot(n, v));
  }
  return most;
}

double overlapAlong(const Pair& pair, const Vector3& n) {
  const double reach_a = reach(pair.a, applyTransposed(pair.X_WA.rotation, -n));
  const double reach_b = reach(pair.b, applyTransposed(pair.X_WB.rotation, n));
  return reach_a + reach_b + dot(n, pair.X_WB.translation - pair.X_WA.translation);
}

double distanceOutside(const CollisionShape& shape, const Pose& X_WS, const Vector3& p_W) {
  const Vector3 p = applyInverse(X_WS, p_W);
  if (shape.kind == CollisionKind::kPlane) return p.z;
  double most = -kInfinite;
  for (const Vector3& n : sphereDirections()) most = max(most, dot(n, p) - reach(shape, n));
  return most;
}

Sweep sweepDirections(const Pair& pair, Dice& dice) {
  if (pair.a.kind == CollisionKind::kPlane) {
    const Vector3 down = -pair.X_WA.rotation.z;
    return {overlapAlong(pair, down), down, true};
  }
  std::vector<Vector3> normals, edges_a, edges_b;
  addFlatParts(pair.a, pair.X_WA.rotation, normals, edges_a);
  addFlatParts(pair.b, pair.X_WB.rotation, normals, edges_b);
  for (const Vector3& u : edges_a)
    for (const Vector3& w : edges_b)
      if (const Vector3 n = cross(u, w); norm(n) > 1e-6)
        normals.push_back(normalized(n)), normals.push_back(-normals.back());
  normals.insert(normals.end(), sphereDirections().begin(), sphereDirections().end());
  std::vector<Minimum> minima;
  for (const Vector3& n : normals) minima.push_back({overlapAlong(pair, n), n});
  std::sort(minima.begin(), minima.end(), [](const Minimum& l, const Minimum& r) { return l.depth < r.depth; });
  // Starts no closer to one another than 10 degrees.
  std::vector<Minimum> starts;
  for (const Minimum& m : minima) {
    if (starts.size() == 6) break;
    if (std::none_of(starts.begin(), starts.end(), [&](const Minimum& s) { return dot(s.normal, m.normal) > 0.985; }))
      starts.push_back(m);
  }
  minima.resize(std::min<std::size_t>(minima.size(), 200));  // the others are no rivals
  for (Minimum& m : starts) m = refined(pair, m, 0.1, 0.93, dice);
  std::sort(starts.begin(), starts.end(), [](const Minimum& l, const Minimum& r) { return l.depth < r.depth; });
  Minimum best = refined(pair, starts.front(), 0.03, 0.975, dice);
  edges_a.insert(edges_a.end(), edges_b.begin(), edges_b.end());
  best = refined(pair, alongKinks(pair, best, edges_a), 1e-3, 0.9, dice);
  minima.insert(minima.end(), starts.begin(), starts.end());
  return {best.depth, best.normal, isUnique(pair, best, minima)};
}

}  // namespace murosimf::collision_test
