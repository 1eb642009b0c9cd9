// Depths of the closed forms against formulas and searches of their own.
#include <gtest/gtest.h>

#include "algorithms/collision/random_pairs.h"
#include "book/page.h"

namespace murosimf::collision_test {
namespace {

constexpr int kPoses = 5000;

/// Least value of a convex function of one variable, by golden sections.
template <class Function>
double leastOf(double low, double high, Function f) {
  constexpr double kGolden = 0.6180339887498949;
  for (int i = 0; i < 90; ++i) {
    const double l = high - kGolden * (high - low), r = low + kGolden * (high - low);
    (f(l) < f(r) ? high : low) = f(l) < f(r) ? r : l;
  }
  return f(0.5 * (low + high));
}

double depthOf(const Pair& pair) {
  ContactManifold out;
  detectContact(pair.a, pair.X_WA, pair.b, pair.X_WB, out);
  return out.count > 0 ? deepest(out).depth : 0;
}

void corners(const CollisionShape& box, const Pose& X, Vector3 (&out)[8]) {
  for (int i = 0; i < 8; ++i)
    out[i] = X * Vector3{(i & 1) != 0 ? box.half_size.x : -box.half_size.x,
                         (i & 2) != 0 ? box.half_size.y : -box.half_size.y,
                         (i & 4) != 0 ? box.half_size.z : -box.half_size.z};
}

/// Overlap of two boxes along an axis, both ways out, from their corners.
double overlapOfCorners(const Vector3 (&a)[8], const Vector3 (&b)[8], const Vector3& n) {
  double low_a = dot(n, a[0]), high_a = low_a, low_b = dot(n, b[0]), high_b = low_b;
  for (int i = 1; i < 8; ++i) {
    low_a = min(low_a, dot(n, a[i])), high_a = max(high_a, dot(n, a[i]));
    low_b = min(low_b, dot(n, b[i])), high_b = max(high_b, dot(n, b[i]));
  }
  return min(high_a - low_b, high_b - low_a);
}

double distanceToSegment(const Vector3& p, const Pose& X, double half_length) {
  const Vector3 p_S = applyInverse(X, p);
  return norm(p_S - Vector3{0, 0, clamp(p_S.z, -half_length, half_length)});
}

TEST(ClosedForm, TwoBoxesOverlapByTheLeastOfFifteenAxes) {
  book::Page page({book::Chapter::kCollisions,
                   "Two boxes overlap by the least of fifteen axes",
                   R"(d = \min_n \; \min(\max a_n - \min b_n, \; \max b_n - \min a_n))",
                   "Separating axes, computed from all corners",
                   {{"n", "normals of the faces, products of the edges", ""}, {"a_n, b_n", "corners along n", "m"}},
                   {"least overlap", "m"},
                   {"depth $d$", "m"}});
  Dice dice(200);
  for (int i = 0; i < kPoses; ++i) {
    const Pair pair = randomPair(CollisionKind::kBox, CollisionKind::kBox, dice);
    Vector3 a[8], b[8];
    corners(pair.a, pair.X_WA, a);
    corners(pair.b, pair.X_WB, b);
    const Rotation3 &A = pair.X_WA.rotation, &B = pair.X_WB.rotation;
    double faces = 1, all = 1;
    for (const Vector3& n : {A.x, A.y, A.z, B.x, B.y, B.z}) faces = min(faces, overlapOfCorners(a, b, n));
    for (const Vector3& u : {A.x, A.y, A.z})
      for (const Vector3& w : {B.x, B.y, B.z})
        if (const Vector3 n = cross(u, w); norm(n) > 1e-6) all = min(all, overlapOfCorners(a, b, normalized(n)));
    all = min(all, faces);
    const double found = depthOf(pair);
    if (abs(all) < 1e-9) continue;  // they only just touch
    if (all < 0) {
      ASSERT_EQ(found, 0) << i;
      continue;
    }
    // Edges have to be shallower than faces by 0.8 % and a micrometre.
    const bool face_wins = all >= 0.992 * faces - 1e-6;
    ASSERT_NEAR(found, face_wins ? faces : all, 1e-9) << i;
    if (i % 20 == 0) {
      ASSERT_TRUE(page.near(all, found, face_wins ? faces : all, 1e-9));
    }
  }
}

TEST(ClosedForm, TwoCapsulesOverlapByTheDistanceOfTheirAxes) {
  book::Page page({book::Chapter::kCollisions,
                   "Two capsules overlap by the distance of their axes",
                   R"(d = \max(0, \; r_1 + r_2 - \mathrm{dist}(a_1, a_2)))",
                   "Geometry; the distance is searched along one axis",
                   {{"a_1, a_2", "axes, as segments", ""}, {"r_1, r_2", "radii", "m"}},
                   {"distance of the axes less the radii", "m"},
                   {"depth $d$", "m"}});
  Dice dice(201);
  for (int i = 0; i < kPoses; ++i) {
    const Pair pair = randomPair(CollisionKind::kCapsule, CollisionKind::kCapsule, dice);
    const double half = pair.a.half_size.z;
    const double distance = leastOf(-half, half, [&](double s) {
      return distanceToSegment(pair.X_WA * Vector3{0, 0, s}, pair.X_WB, pair.b.half_size.z);
    });
    const double overlap = pair.a.half_size.x + pair.b.half_size.x - distance;
    if (i % 20 == 0) {
      ASSERT_TRUE(page.near(-overlap, depthOf(pair), max(0.0, overlap), 1e-9)) << i;
    }
    ASSERT_NEAR(depthOf(pair), max(0.0, overlap), 1e-9) << i;
  }
}

TEST(ClosedForm, BoxAndCapsuleOverlapByTheDistanceOfBoxAndAxis) {
  book::Page page({book::Chapter::kCollisions,
                   "Box and capsule overlap by the distance of box and axis",
                   R"(d = \max(0, \; r - \mathrm{dist}(B, a)))",
                   "Geometry; the distance is searched along the axis",
                   {{"B", "box", ""}, {"a", "axis of the capsule, a segment", ""}, {"r", "its radius", "m"}},
                   {"distance of box and axis less the radius", "m"},
                   {"depth $d$", "m"}});
  Dice dice(202);
  for (int i = 0; i < kPoses; ++i) {
    const Pair pair = randomPair(CollisionKind::kBox, CollisionKind::kCapsule, dice);
    const Vector3& a = pair.a.half_size;
    const double half = pair.b.half_size.z, radius = pair.b.half_size.x;
    const double distance = leastOf(-half, half, [&](double t) {
      const Vector3 p = applyInverse(pair.X_WA, pair.X_WB * Vector3{0, 0, t});
      const Vector3 gap{max(0.0, abs(p.x) - a.x), max(0.0, abs(p.y) - a.y), max(0.0, abs(p.z) - a.z)};
      return norm(gap);
    });
    if (distance < 1e-8) {
      ASSERT_GT(depthOf(pair), radius - 1e-8) << i;
    } else {
      ASSERT_NEAR(depthOf(pair), max(0.0, radius - distance), 1e-9) << i;
      if (i % 20 == 0) {
        ASSERT_TRUE(page.near(distance - radius, depthOf(pair), max(0.0, radius - distance), 1e-9));
      }
    }
  }
}

TEST(ClosedForm, ABoxAndTheHullOfItsCornersAreTheSameToASphere) {
  Dice dice(203);
  for (int i = 0; i < kPoses; ++i) {
    const Pair with_box = randomPair(CollisionKind::kSphere, CollisionKind::kBox, dice);
    Vector3 points[8];
    corners(with_box.b, {}, points);
    const ConvexHull hull(points);
    Pair with_hull = with_box;
    with_hull.b = collisionConvex(hull);
    ASSERT_NEAR(depthOf(with_hull), depthOf(with_box), 1e-9) << i;
  }
}

TEST(ClosedForm, DepthsOnThePlaneAreThoseOfTheTextbook) {
  book::Page page({book::Chapter::kCollisions,
                   "Tilted shapes are as deep in a plane as the textbook says",
                   "d_{box} = a s + b c - h, \\quad d_{cylinder} = r s + b c - h, \\quad d_{capsule} = r + b c - h\n"
                   R"(d_{ellipsoid} = \sqrt{a^2 s^2 + b^2 c^2} - h, \quad d_{sphere} = r - h)",
                   "Support functions of the shapes",
                   {{"s, c", "sine and cosine of the tilt", ""},
                    {"a, b, r", "half edges, half lengths, radii", "m"},
                    {"h", "height of the centre, here 0.03", "m"}},
                   {"tilt", "rad"},
                   {"depth $d$", "m"}});
  const CollisionShape plane = collisionPlane();
  constexpr double kHeight = 0.03;
  struct Textbook {
    const char* name;
    CollisionShape shape;
    double (*reach)(double s, double c);  ///< of the shape downwards from its centre
  };
  const Textbook all[] = {
      {"sphere", collisionSphere(0.12), [](double, double) { return 0.12; }},
      {"box", collisionBox({0.2, 0.1, 0.3}), [](double s, double c) { return 0.05 * s + 0.15 * c; }},
      {"cylinder", collisionCylinder(0.07, 0.3), [](double s, double c) { return 0.07 * s + 0.15 * c; }},
      {"capsule", collisionCapsule(0.05, 0.3), [](double, double c) { return 0.05 + 0.15 * c; }},
      {"ellipsoid", collisionEllipsoid({0.05, 0.06, 0.15}),
       [](double s, double c) { return sqrt(0.06 * 0.06 * s * s + 0.15 * 0.15 * c * c); }}};
  for (const Textbook& each : all) {
    const auto depth = [&](double angle) { return each.reach(sin(angle), cos(angle)) - kHeight; };
    page.series(each.name).curve(0, 1.5, depth);
    for (const double angle : {0.05, 0.3, 0.6, 0.9, 1.2, 1.5}) {
      const double found = depthOf({plane, each.shape, {}, {rotationX(angle), {2, 3, kHeight}}});
      EXPECT_TRUE(page.near(angle, found, depth(angle), 1e-12)) << each.name;
    }
  }
}

TEST(ClosedForm, PlanesDoNotTouchOneAnother) {
  EXPECT_EQ(depthOf({collisionPlane(), collisionPlane(), {}, {rotationX(1.0), {0, 0, -1}}}), 0);
}

}  // namespace
}  // namespace murosimf::collision_test
