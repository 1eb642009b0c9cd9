// What it costs to find out how two shapes touch: every pair of kinds, against two spheres.

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <memory>

#include "murosimf/algorithms/collision/detect_contact.h"
#include "murosimf/math/random.h"
#include "paired_ratio.h"

namespace murosimf::bench {
namespace {

constexpr int kPoses = 256, kRounds = 25;

/// Parts of robots: 0.05 to 0.2 m long. The hull has 32 vertices or fewer.
class Shapes {
 public:
  Shapes() {
    std::vector<Vector3> points;
    for (int i = 0; i < 32; ++i) points.push_back(direction() * 0.08);
    hull_ = std::make_unique<ConvexHull>(points);
  }
  CollisionShape shape(CollisionKind kind) {
    const double a = uniform(0.05, 0.2), b = uniform(0.05, 0.2), c = uniform(0.05, 0.2);
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
        return collisionEllipsoid({0.5 * a, 0.5 * b, 0.5 * c});
      case CollisionKind::kConvex:
        return collisionConvex(*hull_);
      case CollisionKind::kSphere:
        break;
    }
    return collisionSphere(0.5 * a);
  }
  Rotation3 rotation() { return rotationExp(direction() * uniform(0, 3)); }
  Vector3 direction() {
    const double z = uniform(-1, 1), angle = uniform(-kPi, kPi), s = sqrt(1 - z * z);
    return {s * cos(angle), s * sin(angle), z};
  }
  double uniform(double low, double high) { return stream_.uniform(step_++, low, high); }

 private:
  RandomStream stream_{7, "collision_benchmark", 0};
  std::uint64_t step_ = 0;
  std::unique_ptr<ConvexHull> hull_;
};

struct TouchingPair {
  CollisionShape a, b;
  Pose X_WA, X_WB;
};

/// The farthest points of both along a random direction meet, 0.1 to 10 mm deep; those that touch elsewhere too or not
/// at all are drawn again.
TouchingPair touchingPair(Shapes& shapes, CollisionKind a, CollisionKind b) {
  for (;;) {
    TouchingPair pair{shapes.shape(a), shapes.shape(b), {}, {shapes.rotation(), {}}};
    const bool plane = a == CollisionKind::kPlane;
    if (!plane) pair.X_WA.rotation = shapes.rotation();
    const Vector3 n = plane ? Vector3{0, 0, -1} : shapes.direction();
    const Vector3 tip_a = plane ? Vector3{} : pair.X_WA * supportPoint(pair.a, applyTransposed(pair.X_WA.rotation, -n));
    const Vector3 tip_b = pair.X_WB * supportPoint(pair.b, applyTransposed(pair.X_WB.rotation, n));
    pair.X_WB.translation = tip_a - tip_b + n * std::exp(shapes.uniform(std::log(1e-4), std::log(1e-2)));
    ContactManifold found;
    detectContact(pair.a, pair.X_WA, pair.b, pair.X_WB, found);
    if (found.count > 0) return pair;
  }
}

std::string nameOf(CollisionKind kind) {
  constexpr std::array<const char*, kCollisionKinds> kNames{"plane",    "sphere",    "box",   "capsule",
                                                            "cylinder", "ellipsoid", "convex"};
  return kNames[static_cast<std::size_t>(kind)];
}

double checksum = 0;  // so that no detection can be left out

std::function<void()> detectionOf(const std::vector<TouchingPair>& pairs) {
  return [pairs] {
    ContactManifold found;
    for (const TouchingPair& pair : pairs) {
      detectContact(pair.a, pair.X_WA, pair.b, pair.X_WB, found);
      checksum += found.points[0].depth;
    }
  };
}

std::vector<Row> everyPair() {
  Shapes shapes;
  std::vector<std::string> names;
  std::vector<std::function<void()>> detections;
  for (int a = 0; a < kCollisionKinds; ++a) {
    for (int b = std::max(a, 1); b < kCollisionKinds; ++b) {
      const auto kind_a = static_cast<CollisionKind>(a), kind_b = static_cast<CollisionKind>(b);
      std::vector<TouchingPair> pairs;
      for (int i = 0; i < kPoses; ++i) pairs.push_back(touchingPair(shapes, kind_a, kind_b));
      names.push_back(fmt::format("pair_{}_{}", nameOf(kind_a), nameOf(kind_b)));
      detections.push_back(detectionOf(pairs));
    }
  }
  std::vector<TouchingPair> spheres;
  for (int i = 0; i < kPoses; ++i)
    spheres.push_back(touchingPair(shapes, CollisionKind::kSphere, CollisionKind::kSphere));
  const std::vector<Comparison> results = compareFrames(detections, detectionOf(spheres), kRounds);
  std::vector<Row> rows;
  for (std::size_t i = 0; i < results.size(); ++i) {
    constexpr double kPerPair = 1e9 / kPoses;
    const Comparison& c = results[i];
    Row& row =
        rows.emplace_back(Row{names[i], 1 / c.ratio, c.ours * kPerPair, c.peer * kPerPair, "ns/pair", isaOf(1), ""});
    row.text = fmt::format("{:28} {:7} {:6.1f} times the cost of two spheres ({:.0f} ns a pair)", row.name, row.isa,
                           row.ratio, row.ours);
  }
  return rows;
}

}  // namespace

std::vector<Part> collisionParts() { return {everyPair}; }

}  // namespace murosimf::bench
