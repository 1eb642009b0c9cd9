// Rotations and transforms against what defines them.

#include <gtest/gtest.h>

#include <cmath>

#include "book/page.h"
#include "murosimf/math/random.h"
#include "murosimf/math/transform.h"

namespace murosimf {
namespace {

Vector3 randomVector(std::uint64_t i, double size) {
  static const RandomStream random(6, "vectors", 0);
  return {random.uniform(3 * i, -size, size), random.uniform(3 * i + 1, -size, size),
          random.uniform(3 * i + 2, -size, size)};
}
double distance(const Vector3& a, const Vector3& b) { return norm(a - b); }
double distance(const Rotation3& a, const Rotation3& b) {
  return distance(a.x, b.x) + distance(a.y, b.y) + distance(a.z, b.z);
}
double distance(const Pose& a, const Pose& b) {
  return distance(a.rotation, b.rotation) + distance(a.translation, b.translation);
}

TEST(Vector, CrossAndDotAreThoseOfTheRightHand) {
  EXPECT_EQ(cross(Vector3{1, 0, 0}, Vector3{0, 1, 0}), (Vector3{0, 0, 1}));
  EXPECT_EQ(cross(Vector3{0, 1, 0}, Vector3{0, 0, 1}), (Vector3{1, 0, 0}));
  EXPECT_EQ(dot(Vector3{1, 2, 3}, Vector3{4, 5, 6}), 32);
  EXPECT_EQ(norm(Vector3{2, 3, 6}), 7);
  EXPECT_EQ(normalized(Vector3{}), Vector3{});
  EXPECT_NEAR(norm(normalized(Vector3{3, -4, 5})), 1, 1e-15);
}

TEST(Rotation, PositiveAnglesTurnByTheRightHand) {
  const double quarter = kPi / 2;
  EXPECT_LT(distance(rotationX(quarter) * Vector3{0, 1, 0}, {0, 0, 1}), 1e-15);
  EXPECT_LT(distance(rotationY(quarter) * Vector3{0, 0, 1}, {1, 0, 0}), 1e-15);
  EXPECT_LT(distance(rotationZ(quarter) * Vector3{1, 0, 0}, {0, 1, 0}), 1e-15);
}

TEST(Rotation, IsOrthonormalAndTheTransposeUndoesIt) {
  for (std::uint64_t i = 0; i < 1000; ++i) {
    const Rotation3 R = rotationExp(randomVector(i, 3));
    EXPECT_LT(distance(R * transposed(R), Rotation3{}), 1e-14);
    EXPECT_NEAR(dot(cross(R.x, R.y), R.z), 1, 1e-14);
    const Vector3 v = randomVector(i + 5000, 2);
    EXPECT_LT(distance(applyTransposed(R, R * v), v), 1e-14);
    EXPECT_LT(distance(orthonormalized(R), R), 1e-14);
  }
}

TEST(Rotation, ExponentialTurnsAboutItsAxisByItsLength) {
  EXPECT_LT(distance(rotationExp(Vector3{0, 0, 0.7}), rotationZ(0.7)), 1e-15);
  EXPECT_LT(distance(rotationExp(Vector3{0.7, 0, 0}), rotationX(0.7)), 1e-15);
  EXPECT_EQ(rotationExp(Vector3{}), Rotation3{});
  for (std::uint64_t i = 0; i < 1000; ++i) {
    const Vector3 w = randomVector(i, 2);
    EXPECT_LT(distance(rotationExp(w) * w, w), 1e-14);
    EXPECT_LT(distance(rotationExp(w) * rotationExp(w), rotationExp(w * 2.0)), 1e-14);
  }
}

TEST(Rotation, LogarithmUndoesTheExponential) {
  book::Page page({book::Chapter::kNumbers,
                   "The logarithm of a rotation undoes the exponential",
                   R"(|\log(\exp(w)) - w|)",
                   "Rodrigues' formula and its inverse [Murray, Li, Sastry 1994]",
                   {{"w", "axis times angle", "rad"}},
                   {"angle $|w|$", "rad"},
                   {"error", "rad", true}});
  for (std::uint64_t i = 0; i < 1000; ++i) {
    const Vector3 w = randomVector(i, 1.7);  // |w| < pi
    EXPECT_TRUE(page.below(norm(w), distance(rotationLog(rotationExp(w)), w), 1e-13));
    const Vector3 tiny = w * 1e-12;
    EXPECT_LT(distance(rotationLog(rotationExp(tiny)), tiny), 1e-24);
  }
  EXPECT_EQ(rotationLog(Rotation3{}), Vector3{});
}

TEST(Rotation, RollPitchYawAreThoseOfUrdf) {
  for (std::uint64_t i = 0; i < 1000; ++i) {
    const Vector3 angles = randomVector(i, 1.5);
    const Rotation3 R = fromRollPitchYaw(angles);
    EXPECT_LT(distance(R, rotationZ(angles.z) * (rotationY(angles.y) * rotationX(angles.x))), 1e-15);
    EXPECT_LT(distance(toRollPitchYaw(R), angles), 1e-13);
  }
}

TEST(Rotation, InterpolationTurnsAtAConstantRate) {
  const Rotation3 a = rotationExp(Vector3{0.3, -0.2, 0.5}), b = a * rotationExp(Vector3{0.4, 0.8, -0.3});
  EXPECT_LT(distance(interpolate(a, b, 0.0), a), 1e-15);
  EXPECT_LT(distance(interpolate(a, b, 1.0), b), 1e-15);
  const Rotation3 third = interpolate(a, b, 1.0 / 3), two_thirds = interpolate(a, b, 2.0 / 3);
  EXPECT_LT(distance(transposed(a) * third, transposed(third) * two_thirds), 1e-15);
}

TEST(Transform, ComposesAndInverts) {
  for (std::uint64_t i = 0; i < 1000; ++i) {
    const Pose X_AB{rotationExp(randomVector(i, 2)), randomVector(i + 2000, 3)};
    const Pose X_BC{rotationExp(randomVector(i + 4000, 2)), randomVector(i + 6000, 3)};
    const Vector3 p_C = randomVector(i + 8000, 1);
    EXPECT_LT(distance((X_AB * X_BC) * p_C, X_AB * (X_BC * p_C)), 1e-14);
    EXPECT_LT(distance(X_AB * inverse(X_AB), Pose{}), 1e-14);
    EXPECT_LT(distance(applyInverse(X_AB, X_AB * p_C), p_C), 1e-14);
  }
}

TEST(Transform, InterpolatesOnTheStraightPath) {
  const Pose a{rotationZ(0.2), {1, 2, 3}}, b{rotationZ(1.0), {2, 0, 3}};
  const Pose middle = interpolate(a, b, 0.5);
  EXPECT_LT(distance(middle, Pose{rotationZ(0.6), {1.5, 1, 3}}), 1e-15);
  EXPECT_EQ(toPose({1, 2, 0.5}, 0.3).translation, (Vector3{1, 2, 0.3}));
}

}  // namespace
}  // namespace murosimf
