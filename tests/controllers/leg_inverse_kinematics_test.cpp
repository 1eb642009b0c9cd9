#include "player/leg_inverse_kinematics.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "book/page.h"

namespace murosimf::controllers {
namespace {

struct Row {
  Vector3 p;
  double yaw, pitch, roll;  // degrees
  LegAngles angles;         // degrees
};

// Worked out independently of this code, to the digits printed.
TEST(LegInverseKinematics, AgreesWithTheReferenceTable) {
  const std::array<Row, 4> rows{{
      {{0, 0, -.22}, 0, 0, 0, {0, 0, -28.3576, 56.7153, -28.3576, 0}},
      {{.03, .01, -.21}, 10, -6, 0, {10.1310, 1.2459, -40.3190, 63.6918, -29.3742, -1.2527}},
      {{-.04, -.02, -.20}, -15, 0, 5, {-15, -8.4386, -25.5428, 69.8792, -44.3364, 13.4386}},
      {{.05, .02, -.15}, 20, 10, -8, {19.8783, .6903, -70.1318, 100.7894, -20.6569, -8.7009}},
  }};
  for (const Row& row : rows) {
    const LegSolution leg =
        solveLeg(row.p, fromRollPitchYaw(Vector3{degrees(row.roll), degrees(row.pitch), degrees(row.yaw)}));
    EXPECT_TRUE(leg.within_reach);
    for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(leg.angles[i], degrees(row.angles[i]), degrees(5.1e-5)) << i;
  }
}

Rotation3 footRotation(const LegAngles& q) {
  return rotationZ(q[0]) * rotationX(q[1]) * rotationY(q[2] + q[3] + q[4]) * rotationX(q[5]);
}
Vector3 anklePosition(const LegAngles& q) {
  const Vector3 shank = rotationY(q[3]) * Vector3{0, 0, -kShank};
  return rotationZ(q[0]) * (rotationX(q[1]) * (rotationY(q[2]) * (Vector3{0, 0, -kThigh} + shank)));
}

RC_GTEST_PROP(LegInverseKinematics, UndoesForwardKinematics, ()) {
  const auto draw = [](int low, int high) { return degrees(0.001 * *rc::gen::inRange(1000 * low, 1000 * high)); };
  const LegAngles q{draw(-60, 60), draw(-35, 60), draw(-110, 45), draw(2, 134), draw(-70, 70), draw(-45, 45)};
  // The closed form has the hip above the foot (r_z > 0) and turns no joint beyond a quarter turn past it.
  RC_PRE(applyTransposed(footRotation(q), -anklePosition(q)).z > 0.02);
  const LegAngles found = solveLeg(anklePosition(q), footRotation(q)).angles;
  for (std::size_t i = 0; i < 6; ++i) RC_ASSERT(std::abs(found[i] - q[i]) < 1e-9);
}

/// The largest difference of two rotations' axes.
double difference(const Rotation3& a, const Rotation3& b) {
  return std::max({norm(a.x - b.x), norm(a.y - b.y), norm(a.z - b.z)});
}

TEST(LegInverseKinematics, PutsTheFootWhereItIsWantedFromFoldedToStretched) {
  book::Page page({book::Chapter::kRobots,
                   "Leg inverse kinematics puts the foot where it is wanted, from the folded to the stretched leg",
                   "p = R_z(q_1) R_x(q_2) R_y(q_3) \\left[ (0, 0, -a) + R_y(q_4) (0, 0, -b) \\right]\n"
                   "R = R_z(q_1) R_x(q_2) R_y(q_3 + q_4 + q_5) R_x(q_6)",
                   "Closed form [Pieper 1968], put into forward kinematics; allowed: rounding",
                   {{"p, R", "ankle from the hip; foot in the pelvis, in three turns of the leg", "m, 1"},
                    {"a, b", "thigh and shank, here both 0.125", "m"}},
                   {"reach $|p| / (a + b)$", ""},
                   {"error of the foot", "m, 1"}});
  for (int i = 0; i <= 24; ++i) {
    const double reach = 0.4 + 0.599 * i / 24;
    double position = 0, rotation = 0;
    for (const Vector3& turn : {Vector3{0, 0, 0}, Vector3{10, -15, 20}, Vector3{-8, 12, -30}}) {
      const Rotation3 R = fromRollPitchYaw(degrees(1) * turn);
      const Vector3 p = R * (rotationY(0.2) * Vector3{0, 0, -reach * (kThigh + kShank)});
      const LegSolution leg = solveLeg(p, R);
      EXPECT_TRUE(leg.within_reach) << reach;
      position = std::max(position, norm(anklePosition(leg.angles) - p));
      rotation = std::max(rotation, difference(footRotation(leg.angles), R));
    }
    EXPECT_TRUE(page.series("ankle [m]").below(reach, position, 1e-14));
    EXPECT_TRUE(page.series("axes of the foot").below(reach, rotation, 1e-14));
  }
}

TEST(LegInverseKinematics, StretchesToItsLimitBeyondReach) {
  const LegSolution leg = solveLeg({0, 0, -0.3}, {});
  EXPECT_FALSE(leg.within_reach);
  EXPECT_LT(leg.angles[kKnee], degrees(1.2));
  EXPECT_NEAR(leg.angles[kHipPitch] + leg.angles[kKnee] + leg.angles[kAnklePitch], 0, 1e-12);  // foot stays level
}

}  // namespace
}  // namespace murosimf::controllers
