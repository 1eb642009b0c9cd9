/// @file Inertias against textbook values and against sums over points.

#include "murosimf/robot/mass_properties.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>
#include <vector>

#include "murosimf/math/random.h"

namespace murosimf {
namespace {

TEST(MassProperties, BoxHasATwelfthOfMassTimesTheSquaredEdges) {
  const MassProperties box = boxMass(12, {1, 2, 3}, {4, 5, 6});
  EXPECT_EQ(box.I_C_B, (SymmetricMatrix{13, 10, 5, 0, 0, 0}));
  EXPECT_EQ(box.p_BC_B, (Vector3{4, 5, 6}));
}

TEST(MassProperties, TwoHalvesOfABoxWeldToTheBox) {
  const MassProperties whole = boxMass(2, {0.4, 0.2, 0.1}, {});
  const MassProperties halves =
      welded(boxMass(1, {0.2, 0.2, 0.1}, {-0.1, 0, 0}), boxMass(1, {0.2, 0.2, 0.1}, {0.1, 0, 0}));
  EXPECT_NEAR(halves.I_C_B.xx, whole.I_C_B.xx, 1e-16);
  EXPECT_NEAR(halves.I_C_B.yy, whole.I_C_B.yy, 1e-16);
  EXPECT_NEAR(halves.I_C_B.zz, whole.I_C_B.zz, 1e-16);
  EXPECT_NEAR(norm(halves.p_BC_B), 0, 1e-16);
}

TEST(MassProperties, WeldingNothingChangesNoBit) {
  const MassProperties box = boxMass(0.3, {0.1, 0.7, 0.3}, {0.1, 0.2, 0.3});
  EXPECT_EQ(welded(box, {}), box);
  EXPECT_EQ(welded({}, box), box);
  EXPECT_EQ(moved({}, box), box);
}

/// Mass, centre and inertia of points, from the definitions.
MassProperties sumOfPoints(const std::vector<double>& masses, const std::vector<Vector3>& points) {
  MassProperties sum;
  for (std::size_t i = 0; i < points.size(); ++i) {
    sum.mass += masses[i];
    sum.p_BC_B += points[i] * masses[i];
  }
  sum.p_BC_B = sum.p_BC_B * (1 / sum.mass);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector3 r = points[i] - sum.p_BC_B;
    sum.I_C_B.xx += masses[i] * (r.y * r.y + r.z * r.z);
    sum.I_C_B.yy += masses[i] * (r.x * r.x + r.z * r.z);
    sum.I_C_B.zz += masses[i] * (r.x * r.x + r.y * r.y);
    sum.I_C_B.xy -= masses[i] * r.x * r.y;
    sum.I_C_B.xz -= masses[i] * r.x * r.z;
    sum.I_C_B.yz -= masses[i] * r.y * r.z;
  }
  return sum;
}

double largestDifference(const MassProperties& a, const MassProperties& b) {
  const SymmetricMatrix &i = a.I_C_B, &k = b.I_C_B;
  double largest = abs(a.mass - b.mass) + norm(a.p_BC_B - b.p_BC_B);
  for (const double d : {i.xx - k.xx, i.yy - k.yy, i.zz - k.zz, i.xy - k.xy, i.xz - k.xz, i.yz - k.yz}) {
    largest = max(largest, abs(d));
  }
  return largest;
}

struct Points {
  std::vector<double> masses;
  std::vector<Vector3> places;
};
Points randomPoints(std::uint64_t seed) {
  const RandomStream dice(seed, "points", 0);
  Points points;
  for (std::uint64_t i = 0; i < 6; ++i) {
    points.masses.push_back(dice.uniform(4 * i, 0.1, 1));
    points.places.push_back({dice.uniform(4 * i + 1), dice.uniform(4 * i + 2), dice.uniform(4 * i + 3)});
  }
  return points;
}

RC_GTEST_PROP(MassProperties, MovingABodyIsMovingItsPoints, (std::uint64_t seed)) {
  const Points points = randomPoints(seed);
  const Pose X_AB{fromRollPitchYaw(Vector3{0.3, -1.1, 2.0}), {0.5, -0.2, 1.0}};
  std::vector<Vector3> seen_from_a;
  for (const Vector3& p : points.places) seen_from_a.push_back(X_AB * p);
  RC_ASSERT(largestDifference(moved(X_AB, sumOfPoints(points.masses, points.places)),
                              sumOfPoints(points.masses, seen_from_a)) < 1e-13);
}

RC_GTEST_PROP(MassProperties, BodiesOfPointsPassTheChecksAndTheirMomentsDoNotTurn, (std::uint64_t seed)) {
  const Points points = randomPoints(seed);
  const MassProperties body = sumOfPoints(points.masses, points.places);
  RC_ASSERT(massProblem(body).empty());
  const Vector3 moments = principalMoments(body.I_C_B);
  const Vector3 turned = principalMoments(moved({fromRollPitchYaw(Vector3{2, 1, -0.7}), {}}, body).I_C_B);
  RC_ASSERT(norm(moments - turned) < 1e-13);
  // Invariants of a symmetric matrix: trace and determinant.
  const SymmetricMatrix& i = body.I_C_B;
  const double determinant =
      i.xx * (i.yy * i.zz - i.yz * i.yz) - i.xy * (i.xy * i.zz - i.yz * i.xz) + i.xz * (i.xy * i.yz - i.yy * i.xz);
  RC_ASSERT(abs(moments.x + moments.y + moments.z - (i.xx + i.yy + i.zz)) < 1e-13);
  RC_ASSERT(abs(moments.x * moments.y * moments.z - determinant) < 1e-12);
}

TEST(MassProperties, OfAThinPlateAreOnTheEdgeOfWhatIsPossible) {
  MassProperties plate{.mass = 1, .I_C_B = {1.0 / 3, 2.0 / 3, 1.0, 0, 0, 0}};
  EXPECT_EQ(massProblem(plate), "");
  plate.I_C_B.zz = 1.00001;
  EXPECT_NE(massProblem(plate), "");
  plate.I_C_B.zz = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(massProblem(plate), "");
  plate = {};
  EXPECT_NE(massProblem(plate), "");
}

}  // namespace
}  // namespace murosimf
