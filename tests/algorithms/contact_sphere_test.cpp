// The closed forms of a sphere against primitives, judged by support functions: the signed distance of a point p from a
// convex body is the largest n.p - h(n) over all unit vectors n, h the body's support function. A closed form is right
// if its own normal reaches its distance and no other direction exceeds it.
#include <gtest/gtest.h>

#include "book/page.h"
#include "murosimf/algorithms/collision/hull_shape.h"
#include "murosimf/algorithms/sphere_contact.h"
#include "murosimf/math/random.h"

namespace murosimf {
namespace {

struct Dice {
  RandomStream stream{20, "contact_sphere_test", 0};
  std::uint64_t step = 0;
  double uniform(double low, double high) { return stream.uniform(step++, low, high); }
  Vector3 direction() {
    const double z = uniform(-1, 1), angle = uniform(-kPi, kPi), s = sqrt(1 - z * z);
    return {s * cos(angle), s * sin(angle), z};
  }
  Vector3 inBox(double size) { return {uniform(-size, size), uniform(-size, size), uniform(-size, size)}; }
  Rotation3 rotation() { return rotationExp(direction() * uniform(0, 3)); }
  Pose pose() { return {rotation(), inBox(2)}; }
  Shape shape(int kind) {
    const double a = uniform(0.02, 0.2), b = uniform(0.02, 0.2), c = uniform(0.02, 0.2);
    if (kind == 0) return makeBox({a, b, c});
    if (kind == 1) return makeCylinder(a, b);
    if (kind == 2) return makeSphere(a);
    if (kind == 3) return makeEllipsoid({a, a, c});
    if (kind == 4) return makeCapsule(a, b);
    return makeEllipsoid({a, b, c});
  }
};
constexpr int kShapeKinds = 6;
constexpr int kPoses = 10000;

double support(const Shape& s, const Vector3& n) {
  const Vector3& a = s.half_size;
  if (s.kind == ShapeKind::kBox) return a.x * abs(n.x) + a.y * abs(n.y) + a.z * abs(n.z);
  if (s.kind == ShapeKind::kCylinder) return a.x * sqrt(n.x * n.x + n.y * n.y) + a.z * abs(n.z);
  if (s.kind == ShapeKind::kCapsule) return a.x + a.z * abs(n.z);
  return norm(Vector3{a.x * n.x, a.y * n.y, a.z * n.z});
}
double distanceAlong(const Shape& s, const Vector3& n, const Vector3& p) { return dot(n, p) - support(s, n); }

/// Largest distance along 400 directions, the best of them refined by shrinking random steps.
double sampledDistance(const Shape& s, const Vector3& p, Dice& dice) {
  Vector3 best{0, 0, 1};
  double distance = distanceAlong(s, best, p);
  const auto attempt = [&](const Vector3& n) {
    const double d = distanceAlong(s, n, p);
    if (d > distance) distance = d, best = n;
  };
  for (int i = 0; i < 400; ++i) attempt(dice.direction());
  for (int k = 0; k < 3; ++k)
    for (double sign : {-1.0, 1.0}) {
      Vector3 axis;
      axis[k] = sign;
      attempt(axis);
    }
  for (double step = 0.3; step > 1e-5; step *= 0.98) attempt(normalized(best + dice.direction() * step));
  return distance;
}

TEST(SphereContact, DistanceIsReachedByTheNormalAndExceededByNoDirection) {
  Dice dice;
  for (int i = 0; i < 1000; ++i) {
    const Shape shape = dice.shape(i % kShapeKinds);
    const Vector3 p = dice.inBox(0.25);
    const NearestPoint nearest = nearestOn(shape, p);
    ASSERT_NEAR(norm(nearest.normal), 1, 1e-12);
    ASSERT_NEAR(distanceAlong(shape, nearest.normal, p), nearest.distance, 1e-12) << i;
    const double sampled = sampledDistance(shape, p, dice);
    ASSERT_LE(sampled, nearest.distance + 1e-12) << i;
    ASSERT_GE(sampled, nearest.distance - 1e-3) << i;
  }
}

TEST(SphereContact, NearestPointLiesOnTheSurfaceAndOnTheNormal) {
  Dice dice;
  for (int i = 0; i < kPoses; ++i) {
    const Shape shape = dice.shape(i % kShapeKinds);
    const Vector3 p = dice.inBox(0.25);
    const NearestPoint nearest = nearestOn(shape, p);
    ASSERT_NEAR(norm(nearest.point + nearest.normal * nearest.distance - p), 0, 1e-10) << i;
    ASSERT_NEAR(nearestOn(shape, nearest.point).distance, 0, 1e-12) << i;
  }
}

TEST(SphereContact, MovedApartByItsDepthAlongTheNormalTheSphereJustTouches) {
  Dice dice;
  for (int i = 0; i < kPoses; ++i) {
    const Shape shape = dice.shape(i % kShapeKinds);
    const Pose X_WS = dice.pose();
    const double radius = dice.uniform(0.03, 0.1);
    const Vector3 p_WC = X_WS.translation + dice.inBox(0.3);
    const SphereContact contact = sphereAgainstShape(p_WC, radius, shape, X_WS);
    const SphereContact moved = sphereAgainstShape(p_WC + contact.normal * contact.depth, radius, shape, X_WS);
    ASSERT_NEAR(moved.depth, 0, 1e-9) << i;
    ASSERT_NEAR(norm(moved.normal - contact.normal), 0, 1e-6) << i;
  }
}

TEST(SphereContact, ContactMovesWithTheTwoBodies) {
  Dice dice;
  for (int i = 0; i < kPoses; ++i) {
    const Shape shape = dice.shape(i % kShapeKinds);
    const Pose X_WS = dice.pose(), X_VW = dice.pose();
    const Vector3 p_WC = X_WS.translation + dice.inBox(0.2);
    const SphereContact here = sphereAgainstShape(p_WC, 0.065, shape, X_WS);
    const SphereContact there = sphereAgainstShape(X_VW * p_WC, 0.065, shape, X_VW * X_WS);
    ASSERT_NEAR(here.depth, there.depth, 1e-9) << i;
    ASSERT_NEAR(norm(X_VW * here.point - there.point), 0, 1e-9) << i;
    ASSERT_NEAR(norm(X_VW.rotation * here.normal - there.normal), 0, 1e-9) << i;
  }
}

TEST(SphereContact, PointIsHalfwayBetweenTheWitnessPoints) {
  Dice dice;
  for (int i = 0; i < 1000; ++i) {
    const Shape shape = dice.shape(i % kShapeKinds);
    const Pose X_WS = dice.pose();
    const Vector3 p_WC = X_WS.translation + dice.inBox(0.2);
    const SphereContact contact = sphereAgainstShape(p_WC, 0.065, shape, X_WS);
    const Vector3 on_sphere = p_WC - contact.normal * 0.065;
    const Vector3 on_shape = X_WS * nearestOn(shape, applyInverse(X_WS, p_WC)).point;
    ASSERT_NEAR(norm((on_sphere + on_shape) * 0.5 - contact.point), 0, 1e-12);
  }
}

TEST(SphereContact, PlaneIsTheFaceOfAHugeBox) {
  Dice dice;
  for (int i = 0; i < 1000; ++i) {
    const Pose X_WS = dice.pose();
    const Vector3 p_WC = X_WS * Vector3{dice.uniform(-1, 1), dice.uniform(-1, 1), dice.uniform(-0.05, 0.2)};
    const SphereContact plane = sphereAgainstPlane(p_WC, 0.065, X_WS);
    const SphereContact box = sphereAgainstShape(p_WC, 0.065, makeBox({10, 10, 10}), X_WS * Pose{{}, {0, 0, -5}});
    ASSERT_NEAR(plane.depth, box.depth, 1e-12);
    ASSERT_NEAR(norm(plane.point - box.point), 0, 1e-12);
    ASSERT_NEAR(norm(plane.normal - box.normal), 0, 1e-12);
  }
}

TEST(SphereContact, TwoSpheresTouchOnTheLineOfTheirCentres) {
  book::Page page({book::Chapter::kCollisions,
                   "Two spheres touch on the line of their centres",
                   R"(d = r_1 + r_2 - |p_1 - p_2|)",
                   "Geometry",
                   {{"r_1, r_2", "radii, here 0.06 and 0.04", "m"}, {"p_1, p_2", "centres", "m"}},
                   {"distance of the centres", "m"},
                   {"depth $d$", "m"}});
  page.curve(0.01, 0.17, [](double distance) { return 0.1 - distance; });
  Dice dice;
  for (int i = 0; i < 1000; ++i) {
    const Vector3 p_WC = dice.inBox(1), p_WD = p_WC + dice.inBox(0.1);
    const SphereContact contact = sphereAgainstSphere(p_WC, 0.06, p_WD, 0.04);
    ASSERT_NEAR(contact.depth, 0.1 - norm(p_WC - p_WD), 1e-15);
    if (i < 100) {
      ASSERT_TRUE(page.near(norm(p_WC - p_WD), contact.depth, 0.1 - norm(p_WC - p_WD), 1e-15));
    }
    const SphereContact as_shape = sphereAgainstShape(p_WC, 0.06, makeSphere(0.04), {{}, p_WD});
    ASSERT_NEAR(norm(contact.normal - as_shape.normal), 0, 1e-12);
    const SphereContact other = sphereAgainstSphere(p_WD, 0.04, p_WC, 0.06);
    ASSERT_NEAR(norm(contact.normal + other.normal), 0, 1e-12);
    ASSERT_NEAR(norm(contact.point - other.point), 0, 1e-12);
  }
}

TEST(SphereContact, CentreInsideABoxLeavesByTheNearestFace) {
  const NearestPoint side = nearestOnBox({0.08, 0.01, -0.02}, {0.1, 0.1, 0.1});
  EXPECT_EQ(side.normal, (Vector3{1, 0, 0}));
  EXPECT_NEAR(side.distance, -0.02, 1e-15);
  const NearestPoint below = nearestOnBox({0.02, 0.01, -0.09}, {0.1, 0.1, 0.1});
  EXPECT_EQ(below.normal, (Vector3{0, 0, -1}));
  EXPECT_NEAR(below.distance, -0.01, 1e-15);
}

TEST(SphereContact, CylinderHasSideDiscAndRim) {
  const double h = 0.6;
  EXPECT_EQ(nearestOnCylinder({0.3, 0, 0.2}, 0.1, h).normal, (Vector3{1, 0, 0}));
  EXPECT_EQ(nearestOnCylinder({0.05, 0.02, 0.7}, 0.1, h).normal, (Vector3{0, 0, 1}));
  const NearestPoint rim = nearestOnCylinder({0.13, 0, 0.64}, 0.1, h);
  EXPECT_NEAR(rim.distance, 0.05, 1e-15);
  EXPECT_NEAR(norm(rim.normal - Vector3{0.6, 0, 0.8}), 0, 1e-12);
  EXPECT_NEAR(nearestOnCylinder({0.09, 0, 0.58}, 0.1, h).distance, -0.01, 1e-15);
}

TEST(SphereContact, EllipsoidIsFoundOnItsAxesAndAtItsCentre) {
  const Vector3 radii{0.03, 0.05, 0.1};
  for (double sign : {-1.0, 1.0}) {
    EXPECT_NEAR(nearestOnEllipsoid({sign * 0.2, 0, 0}, radii).distance, 0.17, 1e-15);
    EXPECT_NEAR(nearestOnEllipsoid({0, sign * 0.2, 0}, radii).distance, 0.15, 1e-15);
    EXPECT_NEAR(nearestOnEllipsoid({0, 0, sign * 0.2}, radii).distance, 0.1, 1e-15);
  }
  const NearestPoint centre = nearestOnEllipsoid({0, 0, 0}, radii);
  EXPECT_NEAR(centre.distance, -0.03, 1e-15);
  EXPECT_NEAR(abs(centre.normal.x), 1, 1e-15);
  // On the long axis near the centre the nearest point lies beside the axis: x_z = a_z^2 z/(a_z^2 - a_x^2).
  const NearestPoint beside = nearestOnEllipsoid({0, 0, 0.04}, radii);
  EXPECT_NEAR(beside.point.z, 0.01 * 0.04 / (0.01 - 0.0009), 1e-12);
  EXPECT_NEAR(beside.point.y, 0, 1e-15);
}

TEST(SphereContact, EllipsoidKeepsItsDigitsCloseToItsLongAxes) {
  const Vector3 radii{0.03, 0.05, 0.1};
  for (double off = 1e-3; off > 1e-14; off *= 0.1) {
    const Vector3 p{off, 0, 0.04};
    const NearestPoint near = nearestOnEllipsoid(p, radii), on = nearestOnEllipsoid({0, 0, 0.04}, radii);
    EXPECT_NEAR(norm(near.point + near.normal * near.distance - p), 0, 1e-12) << off;
    EXPECT_NEAR(near.distance, on.distance + off * near.normal.x, 3 * off * off + 1e-12) << off;
  }
}

HullShape cubeHull(const Vector3& edges) {
  std::vector<Vector3> corners;
  for (int i = 0; i < 8; ++i)
    corners.push_back({(i & 1) != 0 ? edges.x : 0, (i & 2) != 0 ? edges.y : 0, (i & 4) != 0 ? edges.z : 0});
  return makeConvex(corners);
}

TEST(SphereContact, HullOfABoxesCornersIsTouchedAsTheBox) {
  Dice dice;
  for (int i = 0; i < kPoses; ++i) {
    const Vector3 edges{dice.uniform(0.02, 0.2), dice.uniform(0.02, 0.2), dice.uniform(0.02, 0.2)};
    const HullShape hull = cubeHull(edges);
    const Pose X_WS = dice.pose();
    const Vector3 p_WC = X_WS.translation + dice.inBox(0.2);
    const SphereContact box = sphereAgainstShape(p_WC, 0.065, makeBox(edges), X_WS);
    const SphereContact contact = sphereAgainstShape(p_WC, 0.065, hull.shape, X_WS, hull.hull.get());
    if (box.depth < -0.1) {  // farther than anybody asks
      ASSERT_LE(contact.depth, -0.1 + 1e-12) << i;
      continue;
    }
    ASSERT_NEAR(contact.depth, box.depth, 1e-12) << i;
    if (box.depth > 0.064) continue;  // inside, two faces may be equally near
    ASSERT_NEAR(norm(contact.normal - box.normal), 0, 1e-9) << i;
    ASSERT_NEAR(norm(contact.point - box.point), 0, 1e-12) << i;
  }
}

TEST(SphereContact, NearestPointOfAHullIsOneBeyondWhoseNormalNoVertexLies) {
  Dice dice;
  for (int i = 0; i < 300; ++i) {
    const Vector3 size{dice.uniform(0.01, 0.3), dice.uniform(0.01, 0.3), dice.uniform(0.01, 0.3)};
    std::vector<Vector3> points;
    for (int k = 0; k < 6 + i; ++k) {
      const Vector3 d = dice.direction();
      points.push_back({d.x * size.x, d.y * size.y, d.z * size.z});
    }
    const HullShape hull = makeConvex(points);
    for (int k = 0; k < 30; ++k) {
      const Vector3 p = dice.inBox(0.5);
      const NearestPoint nearest = nearestOn(hull.shape, p, hull.hull.get());
      ASSERT_NEAR(norm(nearest.normal), 1, 1e-9);
      ASSERT_NEAR(norm(nearest.point + nearest.normal * nearest.distance - p), 0, 1e-9);
      const Vector3& farthest = hull.hull->vertex(hull.hull->farthestVertex(nearest.normal));
      ASSERT_NEAR(dot(nearest.normal, p - farthest), nearest.distance, 1e-7) << i << " " << k;
    }
  }
}

}  // namespace
}  // namespace murosimf
