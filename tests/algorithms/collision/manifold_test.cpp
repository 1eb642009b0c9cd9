// Bodies that stand or lie have as many points as hold them, at the places where they should be, and keep them.
#include <gtest/gtest.h>

#include <memory>
#include <set>

#include "algorithms/collision/random_pairs.h"

namespace murosimf::collision_test {
namespace {

constexpr double kDepth = 1e-3;

ContactManifold detect(const CollisionShape& a, const Pose& X_WA, const CollisionShape& b, const Pose& X_WB,
                       const Vector3& last_normal = {}) {
  ContactManifold out;
  detectContact(a, X_WA, b, X_WB, out, last_normal);
  return out;
}

/// Area of the points' outline across the normal, whatever their order; 0 for fewer than three.
double areaOf(const ContactManifold& m) {
  double area = 0;
  for (int i = 0; i < m.count; ++i)
    for (int j = 0; j < i; ++j)
      for (int k = 0; k < j; ++k) {
        const Vector3 u = m.points[j].position - m.points[i].position, w = m.points[k].position - m.points[i].position;
        area += 0.5 * abs(dot(m.normal, cross(u, w)));
      }
  return m.count == 4 ? 0.5 * area : area;  // the four triangles of a convex quadrangle cover it twice
}

std::set<std::uint32_t> featuresOf(const ContactManifold& m) {
  std::set<std::uint32_t> features;
  for (int i = 0; i < m.count; ++i) features.insert(m.points[i].feature);
  return features;
}

void expectDepth(const ContactManifold& m, double depth) {
  for (int i = 0; i < m.count; ++i) EXPECT_NEAR(m.points[i].depth, depth, 1e-9);
}

CollisionShape cubeHull(const Vector3& half) {
  static std::vector<std::unique_ptr<ConvexHull>> kept;
  std::vector<Vector3> points;
  for (int i = 0; i < 8; ++i)
    points.push_back(
        {(i & 1) != 0 ? half.x : -half.x, (i & 2) != 0 ? half.y : -half.y, (i & 4) != 0 ? half.z : -half.z});
  return collisionConvex(*kept.emplace_back(std::make_unique<ConvexHull>(points)));
}

TEST(Manifold, AFlatBottomStandsOnFourPointsOfThePlane) {
  const Vector3 half{0.05, 0.04, 0.03};
  for (const CollisionShape& box : {collisionBox(half * 2.0), cubeHull(half)}) {
    const ContactManifold m = detect(box, {{}, {1, 2, half.z - kDepth}}, collisionPlane(), {});
    ASSERT_EQ(m.count, 4);
    EXPECT_EQ(m.normal, (Vector3{0, 0, 1}));
    expectDepth(m, kDepth);
    EXPECT_NEAR(areaOf(m), 4 * half.x * half.y, 1e-12);
    EXPECT_NEAR(m.points[0].position.z, -0.5 * kDepth, 1e-12);
  }
}

TEST(Manifold, ACylinderStandsOnFourPointsAndLiesOnTwo) {
  const CollisionShape can = collisionCylinder(0.05, 0.12);
  const ContactManifold standing = detect(can, {{}, {0, 0, 0.06 - kDepth}}, collisionPlane(), {});
  ASSERT_EQ(standing.count, 4);
  EXPECT_GT(areaOf(standing), 1.9 * 0.05 * 0.05);  // a square in the circle has 2 r^2
  const ContactManifold lying = detect(can, {rotationX(0.5 * kPi), {0, 0, 0.05 - kDepth}}, collisionPlane(), {});
  ASSERT_EQ(lying.count, 2);
  expectDepth(lying, kDepth);
  EXPECT_NEAR(norm(lying.points[0].position - lying.points[1].position), 0.12, 1e-9);
  const ContactManifold tilted = detect(can, {rotationX(0.5), {0, 0, 0.05}}, collisionPlane(), {});
  EXPECT_NEAR(deepest(tilted).depth, 0.06 * cos(0.5) + 0.05 * sin(0.5) - 0.05, 1e-12);
}

TEST(Manifold, AStandingCylinderKeepsItsPointsWhenItTurnsAboutThePlanesNormalOrTiltsALittle) {
  const CollisionShape can = collisionCylinder(0.05, 0.12);
  const auto features = featuresOf(detect(can, {{}, {0, 0, 0.06 - kDepth}}, collisionPlane(), {}));
  Dice dice(300);
  int kept = 0;
  for (int i = 0; i < 100; ++i) {
    const Rotation3 R = rotationZ(dice.uniform(-3, 3)) * rotationX(dice.uniform(-1e-7, 1e-7));
    const ContactManifold m = detect(can, {R, {0, 0, 0.06 - kDepth}}, collisionPlane(), {});
    EXPECT_EQ(m.count, 4);
    EXPECT_GT(areaOf(m), 1.8 * 0.05 * 0.05);
    kept += featuresOf(m) == features ? 1 : 0;
  }
  EXPECT_GE(kept, 50);  // a tilt may choose another square of the eight points
}

TEST(Manifold, StackedBoxesShareTheRectangleOfTheirFaces) {
  const CollisionShape lower = collisionBox({0.2, 0.1, 0.05}), upper = collisionBox({0.1, 0.3, 0.05});
  for (const double turn : {0.0, 1e-9, 1e-4, 0.01}) {
    const ContactManifold m = detect(upper, {rotationZ(turn), {0.02, 0, 0.05 - kDepth}}, lower, {});
    ASSERT_EQ(m.count, 4) << turn;
    EXPECT_NEAR(m.normal.z, 1, 1e-12);
    expectDepth(m, kDepth);
    EXPECT_NEAR(areaOf(m), 0.1 * 0.1, 1e-3) << turn;
    EXPECT_NEAR(m.points[0].position.z, 0.025 - 0.5 * kDepth, 1e-12);
  }
}

TEST(Manifold, BoxesKeepTheirFeaturesWhileTheyMoveALittle) {
  const CollisionShape lower = collisionBox({0.2, 0.1, 0.05}), upper = collisionBox({0.1, 0.3, 0.05});
  const Pose X_lower{rotationZ(0.3), {1, 2, 3}};
  const auto pose = [&](double x, double tilt) { return X_lower * Pose{rotationX(tilt), {x, 0.01, 0.05 - kDepth}}; };
  const auto features = featuresOf(detect(upper, pose(0.02, 1e-4), lower, X_lower));
  EXPECT_EQ(features.size(), 4U);
  for (const double x : {0.021, 0.025, 0.03})
    for (const double tilt : {1e-4, 3e-4, 1e-3})
      EXPECT_EQ(featuresOf(detect(upper, pose(x, tilt), lower, X_lower)), features) << x << " " << tilt;
}

TEST(Manifold, CrossedEdgesTouchInOnePointMidwayBetweenThem) {
  const CollisionShape box = collisionBox({0.1, 0.1, 0.1});
  const double diagonal = 0.05 * sqrt(2.0);
  const Pose X_WA{rotationX(0.25 * kPi), {0, 0, 2 * diagonal - kDepth}}, X_WB{rotationY(0.25 * kPi), {}};
  const ContactManifold m = detect(box, X_WA, box, X_WB);
  ASSERT_EQ(m.count, 1);
  EXPECT_NEAR(m.normal.z, 1, 1e-12);
  EXPECT_NEAR(m.points[0].depth, kDepth, 1e-12);
  EXPECT_NEAR(norm(m.points[0].position - Vector3{0, 0, diagonal - 0.5 * kDepth}), 0, 1e-12);
}

TEST(Manifold, ADeepBoxLeavesByTheSideWhereItCameIn) {
  const CollisionShape slab = collisionBox({0.3, 0.3, 0.02}), foot = collisionBox({0.2, 0.1, 0.03});
  // 21 mm into the slab's 20 mm: the far side is nearer.
  const Pose X_foot{{}, {0, 0, 0.025 - 0.021 - 0.01}};
  EXPECT_LT(detect(foot, X_foot, slab, {}).normal.z, 0);
  const ContactManifold kept = detect(foot, X_foot, slab, {}, {0, 0, 1});
  EXPECT_GT(kept.normal.z, 0);
  EXPECT_NEAR(deepest(kept).depth, 0.031, 1e-12);
  EXPECT_LT(detect(slab, {}, foot, X_foot, {0, 0, -1}).normal.z, 0);
}

TEST(Manifold, ParallelCapsulesTouchWithBothEndsOfWhatTheyShare) {
  const CollisionShape a = collisionCapsule(0.03, 0.2), b = collisionCapsule(0.02, 0.1);
  const Pose X_WA{rotationX(0.5 * kPi), {0, 0, 0.05 - kDepth}};
  for (const double turn : {0.0, kPi, 1e-3}) {
    const ContactManifold m = detect(a, X_WA, b, {rotationZ(turn) * rotationX(0.5 * kPi), {0, 0.08, 0}});
    ASSERT_GE(m.count, 2);
    EXPECT_NEAR(m.normal.z, 1, 1e-3);
    double low = 1, high = -1;
    for (int i = 0; i < m.count; ++i) {
      low = min(low, m.points[i].position.y), high = max(high, m.points[i].position.y);
      EXPECT_NEAR(m.points[i].depth, kDepth, 1e-4);
    }
    EXPECT_NEAR(low, 0.03, 1e-4);
    EXPECT_NEAR(high, 0.1, 1e-4);
  }
}

TEST(Manifold, ALyingCapsuleTouchesABoxWithBothEnds) {
  const CollisionShape box = collisionBox({0.2, 0.2, 0.1}), limb = collisionCapsule(0.03, 0.1);
  for (const double tilt : {0.0, 1e-3, -1e-3}) {
    const Pose X_WA{rotationY(0.5 * kPi + tilt), {0.02, 0, 0.08 - kDepth}};
    const ContactManifold m = detect(limb, X_WA, box, {});
    ASSERT_EQ(m.count, 2) << tilt;
    EXPECT_NEAR(m.normal.z, 1, 1e-12);
    EXPECT_NEAR(deepest(m).depth, kDepth + 0.05 * sin(abs(tilt)), 1e-12);
    EXPECT_NEAR(abs(m.points[0].position.x - m.points[1].position.x), 0.1, 1e-4);
  }
  // Half of it beyond the edge: the edge holds what is beyond.
  const ContactManifold half = detect(limb, {rotationY(0.5 * kPi), {0.1, 0, 0.08 - kDepth}}, box, {});
  ASSERT_EQ(half.count, 2);
  EXPECT_NEAR(max(half.points[0].position.x, half.points[1].position.x), 0.1, 1e-9);
}

TEST(Manifold, IterativePairsStandOnSeveralPointsToo) {
  const CollisionShape can = collisionCylinder(0.05, 0.12), table = collisionBox({0.4, 0.4, 0.1});
  const ContactManifold standing = detect(can, {{}, {0.02, 0.01, 0.11 - kDepth}}, table, {});
  ASSERT_EQ(standing.count, 4);
  EXPECT_NEAR(standing.normal.z, 1, 1e-12);
  expectDepth(standing, kDepth);
  EXPECT_GT(areaOf(standing), 1.9 * 0.05 * 0.05);
  const ContactManifold lying = detect(can, {rotationX(0.5 * kPi), {0, 0, 0.1 - kDepth}}, table, {});
  ASSERT_EQ(lying.count, 2);
  expectDepth(lying, kDepth);
  const ContactManifold cans = detect(can, {{}, {0.02, 0, 0.12 - kDepth}}, can, {});
  EXPECT_EQ(cans.count, 4);
  expectDepth(cans, kDepth);
  const CollisionShape cube = cubeHull({0.05, 0.05, 0.05});
  for (const CollisionShape& under : {table, cubeHull({0.2, 0.2, 0.05})}) {
    const ContactManifold m = detect(cube, {rotationZ(0.4), {0.02, 0.01, 0.1 - kDepth}}, under, {});
    ASSERT_EQ(m.count, 4);
    EXPECT_NEAR(m.normal.z, 1, 1e-9);
    expectDepth(m, kDepth);
    EXPECT_NEAR(areaOf(m), 0.01, 1e-9);
  }
}

TEST(Manifold, NeverHasMoreThanFourPointsAndNamesEachDifferently) {
  Dice dice(301);
  for (int i = 0; i < 20000; ++i) {
    const int a = dice.below(kCollisionKinds), b = max(a, 1);
    const Pair pair = randomPair(static_cast<CollisionKind>(a),
                                 static_cast<CollisionKind>(b + dice.below(kCollisionKinds - b)), dice);
    const ContactManifold m = detect(pair.a, pair.X_WA, pair.b, pair.X_WB);
    ASSERT_LE(m.count, 4);
    EXPECT_EQ(featuresOf(m).size(), static_cast<std::size_t>(m.count))
        << i << " " << nameOf(pair.a.kind) << " " << nameOf(pair.b.kind) << std::hex << " " << m.points[0].feature
        << " " << m.points[1].feature << " " << m.points[2].feature << " " << m.points[3].feature;
    for (int k = 0; k < m.count; ++k) ASSERT_GT(m.points[k].depth, 0);
  }
}

}  // namespace
}  // namespace murosimf::collision_test
