// Distances along rays against closed forms.

#include "murosimf/algorithms/range_caster.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

#include "murosimf/algorithms/ray_distance.h"
#include "murosimf/math/random.h"

namespace murosimf {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kExact = 1e-9;  // [m]; the scanner's promise is 1e-6

/// A fan of rays from -pi/2 to pi/2.
std::vector<Vector3> fan(int rays) {
  std::vector<Vector3> all;
  for (int i = 0; i < rays; ++i) {
    const SinCos<double> a = sincos(-kPi / 2 + kPi * i / (rays - 1));
    all.push_back({a.cos, a.sin, 0});
  }
  return all;
}

struct Scan {
  explicit Scan(std::vector<Vector3> rays = fan(181), double largest = 10) : directions(std::move(rays)) {
    caster = std::make_unique<RangeCaster>(directions, largest, std::vector<std::uint32_t>{7});
    distances.resize(directions.size());
  }
  void add(const Shape& shape, const Pose& X_WS, std::uint32_t owner = 1) {
    Drawable& thing = scene.drawables.emplace_back();
    thing.shape = shape, thing.X_WS = X_WS, thing.owner = owner;
  }
  void from(const Pose& X_WS) { caster->cast(scene, X_WS, distances); }

  std::vector<Vector3> directions;
  std::unique_ptr<RangeCaster> caster;
  RayScene scene;
  std::vector<double> distances;
};

const Pose kHeld{Rotation3{}, {0, 0, 0.5}};

TEST(RangeCaster, AWallStandsAtItsDistanceOverTheCosine) {
  Scan scan;
  scan.add(makeBox({0.2, 40, 4}), {Rotation3{}, {2.1, 0, 1}});
  scan.from(kHeld);
  for (std::size_t i = 0; i < scan.directions.size(); ++i) {
    const double distance = scan.directions[i].x > 0 ? 2 / scan.directions[i].x : kNever;
    if (distance > 10)
      EXPECT_EQ(scan.distances[i], kNever);
    else
      EXPECT_NEAR(scan.distances[i], distance, kExact);
  }
}

TEST(RangeCaster, AnUprightCylinderIsACircleInThePlane) {
  const double x = 1.5, y = -0.4, radius = 0.3;
  Scan scan;
  scan.add(makeCylinder(radius, 2), {Rotation3{}, {x, y, 0.9}});
  scan.from(kHeld);
  int hits = 0;
  for (std::size_t i = 0; i < scan.directions.size(); ++i) {
    const Vector3& d = scan.directions[i];
    const double along = d.x * x + d.y * y, beside = d.x * y - d.y * x;
    if (along < 0 || std::fabs(beside) >= radius) {
      EXPECT_EQ(scan.distances[i], kNever);
      continue;
    }
    ++hits;
    EXPECT_NEAR(scan.distances[i], along - std::sqrt(radius * radius - beside * beside), kExact);
  }
  EXPECT_GT(hits, 15);
}

TEST(RangeCaster, ASphereAtAnotherHeightIsASmallerCircle) {
  const double radius = 0.25, above = 0.15, cut = std::sqrt(radius * radius - above * above);
  Scan scan;
  scan.add(makeSphere(radius), {Rotation3{}, {2, 0, 0.5 + above}});
  scan.from(kHeld);
  EXPECT_NEAR(scan.distances[90], 2 - cut, kExact);
  for (std::size_t i = 0; i < scan.directions.size(); ++i) {
    const Vector3& d = scan.directions[i];
    const double beside = 2 * d.y;
    if (d.x > 0 && std::fabs(beside) < cut)
      EXPECT_NEAR(scan.distances[i], 2 * d.x - std::sqrt(cut * cut - beside * beside), kExact);
    else
      EXPECT_EQ(scan.distances[i], kNever);
  }
}

TEST(RangeCaster, ATurnedBoxShowsTheFaceThatIsNearer) {
  // A square of edge 1 m, turned by 45 degrees, its corner at x = 2 - 1/sqrt(2): faces x = 2 - 1/sqrt(2) + |y|.
  Scan scan;
  scan.add(makeBox({1, 1, 1}), {rotationZ(kPi / 4), {2, 0, 0.5}});
  scan.from(kHeld);
  const double corner = 2 - std::sqrt(0.5);
  for (std::size_t i = 0; i < scan.directions.size(); ++i) {
    const Vector3& d = scan.directions[i];
    const double t = corner / (d.x - std::fabs(d.y));
    if (d.x > std::fabs(d.y) && t * std::fabs(d.y) < std::sqrt(0.5) - 1e-9)
      EXPECT_NEAR(scan.distances[i], t, kExact);
    else
      EXPECT_EQ(scan.distances[i], kNever);
  }
}

TEST(RangeCaster, SlantedRaysMeetTheGroundAtHeightOverSine) {
  std::vector<Vector3> rays;
  for (int i = 1; i <= 80; ++i) rays.push_back({std::cos(i * kPi / 180), 0, -std::sin(i * kPi / 180)});
  rays.push_back({1, 0, 0}), rays.push_back({0, 0, 1});
  Scan scan(rays);
  scan.from({rotationZ(1.2), {3, -1, 0.5}});
  for (std::size_t i = 0; i < 80; ++i) {
    const double distance = 0.5 / std::sin(static_cast<double>(i + 1) * kPi / 180);
    if (distance > 10)
      EXPECT_EQ(scan.distances[i], kNever);
    else
      EXPECT_NEAR(scan.distances[i], distance, kExact);
  }
  EXPECT_EQ(scan.distances[80], kNever);
  EXPECT_EQ(scan.distances[81], kNever);
}

TEST(RangeCaster, TheNearestOfSeveralThingsIsTold) {
  Scan scan;
  for (const double x : {3.0, 1.0, 2.0}) scan.add(makeSphere(0.1), {Rotation3{}, {x, 0, 0.5}});
  scan.add(makeSphere(0.1), {Rotation3{}, {0.5, 0, 0.5}}, 7);  // hidden
  scan.from(kHeld);
  EXPECT_NEAR(scan.distances[90], 0.9, kExact);
}

TEST(RangeCaster, WhatIsFartherThanTheSensorReachesIsNothing) {
  Scan scan(fan(3), 1.5);
  scan.add(makeSphere(0.1), {Rotation3{}, {1.7, 0, 0.5}});
  scan.from(kHeld);
  EXPECT_EQ(scan.distances[1], kNever);
}

/// A point of the ray lies on the surface where this is 0, inside where it is below.
double surface(const Shape& s, const Vector3& p) {
  const Vector3& a = s.half_size;
  const double round = std::sqrt(p.x * p.x + p.y * p.y), high = std::fabs(p.z);
  switch (s.kind) {
    case ShapeKind::kBox:
    case ShapeKind::kConvex:
      return std::max({std::fabs(p.x) - a.x, std::fabs(p.y) - a.y, high - a.z});
    case ShapeKind::kCylinder:
      return std::max(round - a.x, high - a.z);
    case ShapeKind::kCapsule:
      return std::hypot(round, std::max(high - a.z, 0.0)) - a.x;
    case ShapeKind::kEllipsoid:
      break;
  }
  return std::sqrt(p.x * p.x / (a.x * a.x) + p.y * p.y / (a.y * a.y) + p.z * p.z / (a.z * a.z)) - 1;
}

TEST(RayDistance, EndsOnTheSurfaceAndPassesThroughNothingBefore) {
  const Shape shapes[] = {makeBox({0.4, 0.7, 0.2}), makeEllipsoid({0.3, 0.5, 0.2}), makeCylinder(0.3, 0.5),
                          makeCapsule(0.2, 0.6)};
  const RandomStream random(1, "rays", 0);
  int hits = 0;
  for (const Shape& shape : shapes) {
    for (std::uint64_t i = 0; i < 2000; ++i) {
      const Vector3 p{random.uniform(6 * i, -2, 2), random.uniform(6 * i + 1, -2, 2), random.uniform(6 * i + 2, -2, 2)};
      const Vector3 to{random.uniform(6 * i + 3, -0.5, 0.5), random.uniform(6 * i + 4, -0.5, 0.5),
                       random.uniform(6 * i + 5, -0.5, 0.5)};
      const Vector3 d = (to - p) * (1 / norm(to - p));
      if (surface(shape, p) <= 0) continue;
      const double t = rayDistance(shape, p, d), end = std::min(t, 6.0);
      if (t < kNever) {
        ++hits;
        EXPECT_NEAR(surface(shape, p + d * t), 0, 1e-9);
      }
      for (int k = 1; k < 60; ++k) EXPECT_GT(surface(shape, p + d * (end * k / 60.0)), -1e-9);
    }
  }
  EXPECT_GT(hits, 3000);
}

TEST(RayDistance, ARayThatBeginsInsideGoesNowhere) {
  EXPECT_EQ(rayDistance(makeSphere(1), {0.2, 0, 0}, {1, 0, 0}), 0);
  EXPECT_EQ(rayDistance(makeBox({1, 1, 1}), {0.2, 0, 0}, {0, 0, 1}), 0);
}

TEST(RayDistance, AMeshOfABoxIsTheBox) {
  const Vector3 edges{0.4, 0.7, 0.2};
  std::vector<Vector3> corners;
  for (int i = 0; i < 8; ++i)
    corners.push_back({((i & 1) != 0 ? 0.5 : -0.5) * edges.x, ((i & 2) != 0 ? 0.5 : -0.5) * edges.y,
                       ((i & 4) != 0 ? 0.5 : -0.5) * edges.z});
  const std::vector<TriangleCorners> faces{{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                                           {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  const TriangleMesh mesh(corners, faces);
  const RandomStream random(2, "rays", 0);
  int hits = 0;
  for (std::uint64_t i = 0; i < 3000; ++i) {
    const Vector3 p{random.uniform(6 * i, -2, 2), random.uniform(6 * i + 1, -2, 2), random.uniform(6 * i + 2, 0.3, 2)};
    const Vector3 to{random.uniform(6 * i + 3, -0.3, 0.3), random.uniform(6 * i + 4, -0.4, 0.4), 0};
    const Vector3 d = (to - p) * (1 / norm(to - p));
    const double box = rayDistance(makeBox(edges), p, d), triangles = rayDistance(mesh, p, d);
    const bool at_rim = (box == kNever) != (triangles == kNever);  // corners are floats
    if (box == kNever || at_rim) continue;
    ++hits;
    EXPECT_NEAR(triangles, box, 1e-6);
  }
  EXPECT_GT(hits, 2000);
}

}  // namespace
}  // namespace murosimf
