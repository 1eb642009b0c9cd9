// Poses that leave methods without a direction: equal centres, parallel axes, shapes that only just touch.
#include <gtest/gtest.h>

#include <functional>

#include "algorithms/collision/random_pairs.h"

namespace murosimf::collision_test {
namespace {

void forEachPair(const std::function<void(CollisionKind, CollisionKind)>& work) {
  for (int a = 0; a < kCollisionKinds; ++a)
    for (int b = max(a, 1); b < kCollisionKinds; ++b)
      work(static_cast<CollisionKind>(a), static_cast<CollisionKind>(b));
}

/// What any contact must be: finite, with a unit normal along which the shapes overlap by its depth.
void expectSane(const Pair& pair, const ContactManifold& m) {
  const std::string names = nameOf(pair.a.kind) + " " + nameOf(pair.b.kind);
  ASSERT_GE(m.count, 0) << names;
  ASSERT_LE(m.count, 4) << names;
  if (m.count == 0) return;
  ASSERT_NEAR(norm(m.normal), 1, 1e-9) << names;
  for (int i = 0; i < m.count; ++i) {
    ASSERT_GT(m.points[i].depth, 0) << names;
    ASSERT_LT(norm(m.points[i].position - pair.X_WB.translation), 10) << names;
  }
  if (pair.a.kind != CollisionKind::kPlane) {
    ASSERT_NEAR(overlapAlong(pair, m.normal), deepest(m).depth, 1e-9) << names;
  }
}

TEST(DegeneratePair, ShapesWithTheSameCentreHaveAWayOut) {
  Dice dice(400);
  forEachPair([&](CollisionKind a, CollisionKind b) {
    for (int i = 0; i < 200; ++i) {
      Pair pair{randomShape(a, dice), randomShape(b, dice), {}, {}};
      if (i % 2 == 0) pair.X_WA = pair.X_WB = dice.pose();
      if (i % 4 == 0) pair.X_WB.rotation = dice.rotation();
      if (i % 8 == 0 && a == b) pair.b = pair.a;
      if (i % 3 == 0) pair.X_WB.translation += dice.direction() * 1e-12;
      ContactManifold m;
      detectContact(pair.a, pair.X_WA, pair.b, pair.X_WB, m);
      const bool both_hulls_about_the_origin = a != CollisionKind::kConvex && b != CollisionKind::kConvex;
      if (both_hulls_about_the_origin) {
        EXPECT_GT(m.count, 0) << nameOf(a) << " " << nameOf(b) << i;
      }
      expectSane(pair, m);
    }
  });
}

TEST(DegeneratePair, AxesMayBeParallelAndFacesInOnePlane) {
  Dice dice(401);
  forEachPair([&](CollisionKind a, CollisionKind b) {
    for (int i = 0; i < 500; ++i) {
      Pair pair{randomShape(a, dice), randomShape(b, dice), {}, {}};
      const Vector3 &size_a = pair.a.half_size, &size_b = pair.b.half_size;
      pair.X_WB.translation = {(size_a.x + size_b.x) * (dice.below(3) - 1), (size_a.y + size_b.y) * (dice.below(3) - 1),
                               (size_a.z + size_b.z) * (dice.below(3) - 1)};
      if (dice.below(2) == 0) pair.X_WB.translation = pair.X_WB.translation * (1 - 1e-3);
      if (dice.below(2) == 0) pair.X_WB.rotation = rotationX(kPi * dice.below(3) / 2);
      ContactManifold m;
      detectContact(pair.a, pair.X_WA, pair.b, pair.X_WB, m);
      expectSane(pair, m);
    }
  });
}

TEST(DegeneratePair, NearlyParallelAxesMakeNoJump) {
  Dice dice(402);
  forEachPair([&](CollisionKind a, CollisionKind b) {
    for (int i = 0; i < 30; ++i) {
      Pair pair{randomShape(a, dice), randomShape(b, dice), {}, {}};
      const Vector3 n = a == CollisionKind::kPlane ? Vector3{0, 0, -1} : Vector3{0, 0, 1};
      pair.X_WB.translation = n * (1e-3 - overlapAlong(pair, n));
      double last = -1;
      for (const double tilt : {0.0, 1e-14, 1e-12, 1e-10, 1e-8, 1e-7}) {
        pair.X_WB.rotation = rotationX(tilt) * rotationY(0.7 * tilt);
        ContactManifold m;
        detectContact(pair.a, pair.X_WA, pair.b, pair.X_WB, m);
        expectSane(pair, m);
        const double depth = m.count > 0 ? deepest(m).depth : 0;
        if (last >= 0) {
          EXPECT_NEAR(depth, last, 1e-6) << nameOf(a) << " " << nameOf(b) << " " << tilt;
        }
        last = depth;
      }
    }
  });
}

TEST(DegeneratePair, ShapesThatOnlyJustTouchMayBeCalledEither) {
  Dice dice(403);
  forEachPair([&](CollisionKind a, CollisionKind b) {
    for (int i = 0; i < 200; ++i) {
      Pair pair = randomPair(a, b, dice);
      ContactManifold m;
      detectContact(pair.a, pair.X_WA, pair.b, pair.X_WB, m);
      if (m.count == 0) continue;
      pair.X_WA.translation += m.normal * deepest(m).depth;
      detectContact(pair.a, pair.X_WA, pair.b, pair.X_WB, m);
      EXPECT_TRUE(m.count == 0 || deepest(m).depth < 1e-9) << nameOf(a) << " " << nameOf(b);
      expectSane(pair, m);
    }
  });
}

}  // namespace
}  // namespace murosimf::collision_test
