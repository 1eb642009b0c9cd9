// Impulses of a single contact against their closed forms.
#include "murosimf/algorithms/contact_law.h"

#include <gtest/gtest.h>

#include "book/page.h"
#include "murosimf/math/random.h"

namespace murosimf {
namespace {

SurfacePair pairOf(NormalLaw law, double stiffness, double restitution_factor) {
  SurfacePair pair;
  pair.normal_law = law;
  pair.stiffness = stiffness;
  pair.restitution_factor = restitution_factor;
  return pair;
}

TEST(NormalLaw, FactorGoesFromOneToTheRestitutionFactor) {
  for (double s_b : {0.0, 0.25, 1.0}) {
    const SurfacePair smooth = pairOf(NormalLaw::kSmooth, 1e3, s_b);
    EXPECT_NEAR(normalFactor(smooth, -1), 1, 1e-12);
    EXPECT_NEAR(normalFactor(smooth, 0), 0.5 * (1 + s_b), 1e-15);
    EXPECT_NEAR(normalFactor(smooth, 1), s_b, 1e-12);
    const SurfacePair paper = pairOf(NormalLaw::kPaper, 1e3, s_b);
    EXPECT_EQ(normalFactor(paper, -1e-9), 1);
    EXPECT_EQ(normalFactor(paper, 1e-9), s_b);
  }
}

TEST(NormalLaw, HuntCrossleyRestitutionSolvesItsEquationAndIsBounded) {
  SurfacePair pair = pairOf(NormalLaw::kHuntCrossley, 1e4, 0);
  // Values of d for v = 1 m/s: e .59, .71, .77.
  const double expected[][2] = {{1.01, 0.59}, {0.61, 0.71}, {0.43, 0.77}};
  for (const auto& [d, e] : expected) {
    pair.dissipation = d;
    EXPECT_NEAR(restitution(pair, 1), e, 0.007);
  }
  book::Page page({book::Chapter::kRestAndImpact,
                   "Restitution of Hunt-Crossley solves its equation at every speed",
                   R"(a (1 + e) = \ln\frac{1 + a}{1 - a e}, \quad a = d v)",
                   "[Hunt & Crossley 1975], solved for a linear spring",
                   {{"e", "restitution", ""}, {"d", "dissipation, here 0.6", "s/m"}},
                   {"speed $v$", "m/s", true},
                   {"both sides of the equation", "", true}});
  for (double v : {1e-5, 1e-3, 0.1, 1.0, 10.0}) {
    pair.dissipation = 0.6;
    const double e = restitution(pair, v), a = 0.6 * v;
    EXPECT_TRUE(page.near(v, a * (1 + e), log((1 + a) / (1 - a * e)), 1e-8 * (1 + a * a)));
    EXPECT_LT(e * v, 1 / 0.6);
  }
}

TEST(NormalImpulse, SolvesTheMidpointRule) {
  const RandomStream dice(1, "normal", 0);
  for (std::uint64_t i = 0; i < 5000; ++i) {
    const NormalLaw law = i % 2 ? NormalLaw::kSmooth : NormalLaw::kHuntCrossley;
    const SurfacePair pair = pairOf(law, dice.uniform(8 * i, 1e3, 1e6), dice.uniform(8 * i + 1));
    const NormalStep step{dice.uniform(8 * i + 2, -1e-3, 1e-2), dice.uniform(8 * i + 3, -3, 3),
                          dice.uniform(8 * i + 4, -3, 3),       dice.uniform(8 * i + 5, 0.1, 20),
                          dice.uniform(8 * i + 6, 1e-4, 4e-3),  pair.stiffness};
    const double p = normalImpulse(step, pair);
    const double theta = midpointWeight(pair.stiffness, step.response, step.dt);
    // p - h f(x_m(p), u_m(p)) rises with p: its root lies between two impulses where it has opposite signs.
    const auto residual = [&](double impulse) {
      const double u = (1 - theta) * step.start_speed + theta * (step.end_speed + step.response * impulse);
      const double x = step.depth - theta * step.dt * u;
      return impulse - (x > 0 ? step.dt * pair.stiffness * x * normalFactor(pair, u) : 0);
    };
    ASSERT_GE(p, 0);
    ASSERT_LE(residual(p * (1 - 1e-10)), 1e-14) << i;
    ASSERT_GE(residual(p * (1 + 1e-10)), -1e-14) << i;
  }
}

TEST(NormalImpulse, PaperIsLinearWithItsFactorFrozen) {
  const SurfacePair pair = pairOf(NormalLaw::kPaper, 2e3, 0.25);
  for (double u_0 : {-0.5, 0.5}) {
    const NormalStep step{3e-3, u_0, u_0 - 0.01, 5, 1e-3, pair.stiffness};
    const double p = normalImpulse(step, pair);
    const double u_m = 0.5 * (u_0 + step.end_speed + 5 * p);
    EXPECT_NEAR(p, 1e-3 * 2e3 * (u_0 < 0 ? 1.0 : 0.25) * (3e-3 - 0.5e-3 * u_m), 1e-15);
  }
}

TEST(NormalImpulse, WithoutOverlapThereIsNone) {
  const SurfacePair pair = pairOf(NormalLaw::kSmooth, 1e4, 0.5);
  EXPECT_EQ(normalImpulse({-1e-3, 0.1, 0.1, 5, 1e-3, 1e4}, pair), 0);
  EXPECT_EQ(normalImpulse({1e-4, 0.5, 0.5, 5, 1e-3, 1e4}, pair), 0) << "left before the step's middle";
}

TEST(NormalImpulse, TooLongAStepIsDampedTowardsImplicit) {
  EXPECT_EQ(midpointWeight(1e4, 4, 1e-3), 0.5);
  EXPECT_EQ(midpointWeight(1e6, 1, 1e-3), 0.5);
  EXPECT_NEAR(midpointWeight(1e6, 4, 1e-3), 0.75, 1e-15);
  EXPECT_NEAR(midpointWeight(1e12, 4, 1e-3), 1, 1e-3);
}

TEST(ResistanceImpulse, CoulombFrictionSolvesItsImplicitStep) {
  const RandomStream dice(1, "friction", 0);
  for (std::uint64_t i = 0; i < 2000; ++i) {
    const Vector3 u{dice.uniform(9 * i, -1, 1), dice.uniform(9 * i + 1, -1, 1), dice.uniform(9 * i + 2, -1, 1)};
    const double scale = exp(dice.uniform(9 * i + 3, -12, 2));
    const double limit = dice.uniform(9 * i + 4, 1e-4, 0.1), W = dice.uniform(9 * i + 5, 0.1, 20), v_s = 2e-3;
    const Vector3 p = resistanceImpulse(u * scale, W, {limit, v_s, 0});
    const Vector3 end = u * scale + p * W;
    ASSERT_LE(norm(p), limit * (1 + 1e-12));
    ASSERT_NEAR(norm(p + end * (limit / max(norm(end), v_s))), 0, 1e-11) << i;
    ASSERT_LE(dot(p, end), 0) << "friction feeds no motion";
  }
}

TEST(ResistanceImpulse, ViscousFrictionSolvesItsImplicitStep) {
  SurfacePair pair;
  pair.friction_law = FrictionLaw::kViscous;
  pair.viscous_friction = 10;
  const Vector3 u{0.3, -0.4, 0}, p = resistanceImpulse(u, 5, tangentialResistance(pair, 0.02));
  const Vector3 end = u + p * 5.0;
  EXPECT_NEAR(norm(p + end * (10 * 0.02)), 0, 1e-15);
}

TEST(ResistanceImpulse, RollingAndTurningResistanceAdd) {
  SurfacePair pair;
  pair.turning_friction = 2e-4;
  pair.rolling_resistance = 0.05;
  const double p_n = 0.01, radius = 0.065, W = 1500;
  for (double w : {1e-3, 0.1, 20.0}) {
    const Vector3 p = resistanceImpulse({0, w, 0}, W, turningResistance(pair, p_n, radius));
    const double end = w + W * p.y;
    EXPECT_NEAR(-p.y, 0.05 * radius * p_n * min(1.0, end / (pair.stick_speed / radius)) + 2e-4 * p_n * end, 1e-15) << w;
  }
}

TEST(LimitedImpulse, GivesNoMoreThanForceAndRestitutionAllow) {
  const NormalStep step{1e-3, -1, -1, 5, 1e-3, 1e4};
  EXPECT_EQ(limitedImpulse(0.01, step, 1e3, 10), 0.01);
  EXPECT_EQ(limitedImpulse(1, step, 100, 1e3), 0.1);
  EXPECT_DOUBLE_EQ(limitedImpulse(1, step, 1e9, 0.5), 0.3);
  EXPECT_EQ(limitedImpulse(1, {1e-3, -1, 2, 5, 1e-3, 1e4}, 1e9, 0.5), 0) << "already faster than the limit";
  EXPECT_NEAR(pushingForceLimit(3.3, 0.205, 0.065, 0.1), 16.18, 0.01);
  EXPECT_NEAR(pushingForceLimit(3.3, 0.205, 0.065, 5), 94.6, 0.1);
}

}  // namespace
}  // namespace murosimf
