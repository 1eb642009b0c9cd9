// A ball bounces, against closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "book/page.h"
#include "contact_scene.h"
#include "murosimf/algorithms/collision/hull_shape.h"
#include "murosimf/algorithms/contact_law.h"

namespace murosimf {
namespace {

constexpr double kGravity = 9.81;

/// Separating speed after the first impact (0: none within 2 s of contact), how long and how deep it was.
struct Impact {
  double speed = 0, duration = 0, depth = 0;
};
Impact impactOf(ContactScene& scene, double radius) {
  Impact impact;
  while (impact.duration < 2) {
    scene.advance();
    const double depth = radius - scene.ball().X_WB.translation.z;
    impact.depth = max(impact.depth, depth);
    if (depth > 0) impact.duration += scene.dt;
    if (depth < 0 && scene.ball().velocity.z > 0) {
      impact.speed = scene.ball().velocity.z;
      break;
    }
  }
  return impact;
}

TEST(Bounce, WithoutGravityReturnsTheRootOfTheRestitutionFactor) {
  // Mean over 8 phases of the first touch within a step; s_b = 1/4, so e = 1/2. w h of one undivided step of 1 ms.
  const double cases[][2] = {{0.12, 0.01}, {0.19, 0.01}, {0.34, 0.02}, {0.70, 0.07}};
  for (const auto& [phase, tolerance] : cases) {
    const BallType ball;
    double mean = 0, largest = 0;
    for (int i = 0; i < 8; ++i) {
      ContactScene scene;
      PairSolver::Settings undivided;
      undivided.largest_phase = 10;
      scene.solver = PairSolver(undivided);
      scene.frame.gravity = {};
      scene.addBall(ball, {0, 0, ball.radius + 1e-3 * (5 + i / 8.0)}, {0, 0, -1});
      scene.addGround(0, smoothSurface(ball.mass * phase * phase / (scene.dt * scene.dt), 0.25));
      const double e = impactOf(scene, ball.radius).speed;
      mean += e / 8;
      largest = max(largest, abs(e - 0.5));
    }
    EXPECT_NEAR(mean, 0.5, 0.5 * tolerance) << phase;
    EXPECT_LT(largest, 0.5 * 2 * tolerance) << phase;
  }
}

TEST(Bounce, SubstepsKeepRestitutionForStiffContacts) {
  book::Page page({book::Chapter::kRestAndImpact,
                   "However stiff the contact, a ball returns with the root of the restitution factor",
                   R"(e = \sqrt{s_b})",
                   "Spring of stiffness k on the way in and s_b k on the way out [Friedmann 2007]",
                   {{"e", "speed after over speed before the impact", ""}, {"s_b", "restitution factor", ""}},
                   {"stiffness $k$", "N/m", true},
                   {"restitution $e$", ""}});
  for (double stiffness : {1e3, 1e4, 1e5, 1e6})
    for (double s_b : {0.25, 0.5, 1.0}) {
      const BallType ball{0.057, 0.033, 0.55};
      ContactScene scene;
      scene.frame.gravity = {};
      scene.addBall(ball, {0, 0, ball.radius + 0.0052}, {0, 0, -1});
      scene.addGround(0, smoothSurface(stiffness, s_b));
      page.series("$s_b$ =", s_b).curve(1e3, 1e6, [&](double) { return std::sqrt(s_b); });
      const double e = impactOf(scene, ball.radius).speed;
      EXPECT_TRUE(page.near(stiffness, e, std::sqrt(s_b), 0.03 * std::sqrt(s_b))) << s_b;
    }
}

/// Speed with which a ball comes back that flies along -z at 1 m/s onto something that stands at the origin.
double speedBackFrom(const Shape& shape, const Pose& X_WS, const ConvexHull* hull, double s_b) {
  const BallType ball;
  ContactScene scene;
  scene.frame.gravity = {};
  scene.addBall(ball, {0, 0, 0.3}, {0, 0, -1});
  scene.addSolid(0, scene.addPartner(PartnerKind::kStatic, X_WS), shape, smoothSurface(1e5, s_b));
  scene.frame.pairs.back().hull = hull;
  scene.advance(0.4);
  EXPECT_NEAR(scene.ball().velocity.x, 0, 1e-9);
  EXPECT_NEAR(scene.ball().velocity.y, 0, 1e-9);
  return scene.ball().velocity.z;
}

TEST(Bounce, OffACapsuleAndAHullReturnsTheRootOfTheRestitutionFactor) {
  std::vector<Vector3> octahedron;
  for (const double x : {-0.1, 0.1}) octahedron.insert(octahedron.end(), {{x, 0, 0}, {0, x, 0}, {0, 0, x}});
  const HullShape hull = makeConvex(octahedron);
  const Rotation3 face_up = rotationY(-std::atan2(std::sqrt(2.0), 1.0)) * rotationZ(-kPi / 4);
  for (const double s_b : {0.25, 0.5, 1.0}) {
    const double e = std::sqrt(s_b);
    EXPECT_NEAR(speedBackFrom(makeCapsule(0.03, 0.2), {rotationX(kPi / 2), {}}, nullptr, s_b), e, 0.03 * e) << s_b;
    EXPECT_NEAR(speedBackFrom(makeCapsule(0.03, 0.2), {}, nullptr, s_b), e, 0.03 * e) << "on its end " << s_b;
    EXPECT_NEAR(speedBackFrom(hull.shape, {}, hull.hull.get(), s_b), e, 0.03 * e) << "on a corner " << s_b;
    EXPECT_NEAR(speedBackFrom(hull.shape, {face_up, {}}, hull.hull.get(), s_b), e, 0.03 * e) << "on a face " << s_b;
  }
}

TEST(Bounce, HuntCrossleyReturnsTheRootOfItsEquation) {
  book::Page page({book::Chapter::kRestAndImpact,
                   "A Hunt-Crossley contact returns the root of its equation",
                   R"(a (1 + e) = \ln\frac{1 + a}{1 - a e}, \quad a = d v)",
                   "[Hunt & Crossley 1975], solved for a linear spring",
                   {{"e", "speed after over speed before the impact", ""},
                    {"d", "dissipation of the force k x (1 + d x')", "s/m"},
                    {"v", "speed before the impact, here 1 m/s", "m/s"}},
                   {"dissipation $d$", "s/m"},
                   {"restitution $e$", ""}});
  page.series("").curve(0.05, 2.7, [](double d) {
    SurfacePair surface = smoothSurface(1e4, 0);
    surface.normal_law = NormalLaw::kHuntCrossley, surface.dissipation = d;
    return restitution(surface, 1);
  });
  for (double stiffness : {1e3, 1e4, 1e5})
    for (double dissipation : {0.43, 1.01, 2.5}) {
      const BallType ball;
      ContactScene scene;
      scene.frame.gravity = {};
      scene.addBall(ball, {0, 0, ball.radius + 0.0052}, {0, 0, -1});
      SurfacePair surface = smoothSurface(stiffness, 0);
      surface.normal_law = NormalLaw::kHuntCrossley;
      surface.dissipation = dissipation;
      scene.addGround(0, surface);
      const double e = restitution(surface, 1);
      page.series("$k$ [N/m] =", stiffness);
      EXPECT_TRUE(page.near(dissipation, impactOf(scene, ball.radius).speed, e, 0.03 * e)) << stiffness;
    }
}

TEST(Bounce, RestitutionDoesNotDependOnSpeedNorDirection) {
  for (double speed : {0.5, 2.0, 8.0}) {
    const BallType ball;
    ContactScene scene;
    scene.frame.gravity = {};
    scene.dt = 1e-4;
    scene.addBall(ball, {0, 0, ball.radius + 0.01}, {1, 2, -speed});
    scene.addGround(0, smoothSurface(3e3, 0.5));
    EXPECT_NEAR(impactOf(scene, ball.radius).speed / speed, std::sqrt(0.5), speed < 1 ? 0.02 : 0.005);
    EXPECT_EQ(scene.ball().velocity.x, 1);
    EXPECT_EQ(scene.ball().velocity.y, 2);
  }
}

/// Of a ball that comes with 1 m/s, without gravity, in steps of 10 us.
Impact impactAt1(const SurfacePair& surface) {
  const BallType ball;
  ContactScene scene;
  scene.frame.gravity = {};
  scene.dt = 1e-5;
  scene.addBall(ball, {0, 0, ball.radius + 1e-3}, {0, 0, -1});
  scene.addGround(0, surface);
  return impactOf(scene, ball.radius);
}

TEST(Bounce, ContactTimeAndDepthAreThoseOfTwoQuarterOscillations) {
  book::Page page(
      {book::Chapter::kRestAndImpact,
       "An impact lasts two quarter oscillations, one of each branch's spring",
       R"(T = \frac{\pi}{2} \sqrt{\frac{m}{k}} \left( 1 + \frac{1}{\sqrt{s_b}} \right))",
       "Springs k on the way in, s_b k on the way out [Friedmann 2007]",
       {{"T", "time in contact", "s"}, {"m", "mass, here 0.205 kg", "kg"}, {"k", "stiffness, here 3 kN/m", "N/m"}},
       {"restitution factor $s_b$", ""},
       {"time in contact $T$", "s"}});
  const double stiffness = 3e3, quarter = std::sqrt(BallType{}.mass / stiffness);
  const auto duration = [&](double s_b) { return 0.5 * kPi * quarter * (1 + 1 / std::sqrt(s_b)); };
  for (const NormalLaw law : {NormalLaw::kPaper, NormalLaw::kSmooth}) {
    const bool jumps = law == NormalLaw::kPaper;  // the other one's passage is 0.02 m/s wide
    page.series(jumps ? "paper" : "smooth").curve(0.2, 1, duration);
    for (const double s_b : {0.25, 0.5, 0.8}) {
      SurfacePair surface = smoothSurface(stiffness, s_b);
      surface.normal_law = law;
      const Impact impact = impactAt1(surface);
      EXPECT_TRUE(page.near(s_b, impact.duration, duration(s_b), jumps ? 3e-5 : 0.05 * quarter));
      EXPECT_NEAR(impact.depth, quarter, (jumps ? 1e-5 : 1e-3) * quarter);
    }
  }
}

// m u du = k x (1 - d u) dx on the way in: D^2 = 2 m/k (v/d - ln(1 + d v)/d^2).
TEST(Bounce, DepthOfHuntCrossleyIsThatOfItsWayIn) {
  book::Page page({book::Chapter::kRestAndImpact,
                   "A Hunt-Crossley contact is as deep as its way in says",
                   R"(D^2 = \frac{2 m}{k} \left( \frac{v}{d} - \frac{\ln(1 + d v)}{d^2} \right))",
                   "m u du = k x (1 - d u) dx, integrated from touch to standstill [Hunt & Crossley 1975]",
                   {{"D", "largest depth", "m"}, {"d", "dissipation", "s/m"}, {"v", "speed, here 1 m/s", "m/s"}},
                   {"dissipation $d$", "s/m", true},
                   {"largest depth $D$", "m"}});
  const auto depth = [](double d) {
    return std::sqrt(2 * BallType{}.mass / 3e3 * (1 / d - std::log(1 + d) / (d * d)));
  };
  page.curve(0.3, 25, depth);
  for (const double d : {0.43, 1.01, 3.0, 8.0, 20.0}) {
    SurfacePair surface = smoothSurface(3e3, 0);
    surface.normal_law = NormalLaw::kHuntCrossley;
    surface.dissipation = d;
    EXPECT_TRUE(page.near(d, impactAt1(surface).depth, depth(d), 1e-3 * depth(d)));
  }
}

double restitutionWithGravity(NormalLaw law, double s_b, double speed, double dt) {
  const BallType ball{0.057, 0.033, 0.55};
  ContactScene scene;
  scene.dt = dt;
  scene.addBall(ball, {0, 0, ball.radius}, {0, 0, -speed});
  SurfacePair surface = smoothSurface(3e3, s_b);
  surface.normal_law = law;
  scene.addGround(0, surface);
  return impactOf(scene, ball.radius).speed / speed;
}
/// delta = 2 m g/(s_c D), e = sqrt((s_b - delta)/(1 - delta)).
double restitutionFormula(double s_b, double speed) {
  const double m = 0.057, s_c = 3e3;
  const double depth = m * kGravity / s_c * (1 + std::sqrt(1 + s_c * speed * speed / (m * kGravity * kGravity)));
  const double delta = 2 * m * kGravity / (s_c * depth);
  return delta >= s_b ? 0 : std::sqrt((s_b - delta) / (1 - delta));
}

TEST(Bounce, GravityLowersRestitutionAsDerived) {
  book::Page page(
      {book::Chapter::kRestAndImpact,
       "Gravity lowers the restitution of slow impacts",
       "e = \\sqrt{\\frac{s_b - \\delta}{1 - \\delta}}, \\quad \\delta = \\frac{2 m g}{k D}\n"
       R"(D = \frac{m g}{k} \left( 1 + \sqrt{1 + \frac{k v^2}{m g^2}} \right))",
       "Energy of spring and height on the way in and on the way out",
       {{"D", "largest depth", "m"}, {"s_b", "restitution factor", ""}, {"v", "speed before the impact", "m/s"}},
       {"speed $v$", "m/s"},
       {"restitution $e$", ""}});
  page.series("$s_b$ = 0.25").curve(0.25, 3.2, [](double v) { return restitutionFormula(0.25, v); });
  page.series("$s_b$ = 0.64").curve(0.25, 3.2, [](double v) { return restitutionFormula(0.64, v); });
  const double cases[][3] = {{0.25, 1, 0.4279}, {0.25, 3, 0.4778}, {0.64, 1, 0.7797}};
  for (const auto& [s_b, speed, e] : cases) {
    EXPECT_NEAR(restitutionFormula(s_b, speed), e, 5e-5);
    page.series("paper, $s_b$ =", s_b);
    EXPECT_TRUE(page.near(speed, restitutionWithGravity(NormalLaw::kPaper, s_b, speed, 2e-6), e, 1e-4));
    page.series("smooth, $s_b$ =", s_b);
    EXPECT_TRUE(page.near(speed, restitutionWithGravity(NormalLaw::kSmooth, s_b, speed, 2e-6), e, 0.02 * e));
    EXPECT_NEAR(restitutionWithGravity(NormalLaw::kPaper, s_b, speed, 1e-3), e, 0.1 * e) << "factor frozen in a step";
    EXPECT_NEAR(restitutionWithGravity(NormalLaw::kSmooth, s_b, speed, 1e-3), e, 0.04 * e);
  }
}

TEST(Bounce, BelowTheCriticalSpeedThereIsNone) {
  const double critical = kGravity * std::sqrt(0.057 / 3e3) * std::sqrt((2 / 0.25 - 1) * (2 / 0.25 - 1) - 1);
  EXPECT_NEAR(critical, 0.2963, 5e-5);
  const auto returned = [&](NormalLaw law, double share) {
    return restitutionWithGravity(law, 0.25, share * critical, 1e-5);
  };
  EXPECT_EQ(returned(NormalLaw::kPaper, 0.98), 0);
  EXPECT_EQ(returned(NormalLaw::kSmooth, 0.95), 0) << "its passage is 0.02 m/s wide";
  for (const double share : {1.05, 1.2, 1.5}) {
    const double e = restitutionFormula(0.25, share * critical);
    EXPECT_NEAR(returned(NormalLaw::kPaper, share), e, 1e-3) << share;
    EXPECT_NEAR(returned(NormalLaw::kSmooth, share), e, share > 1.1 ? 0.02 : 0.03) << share;
  }
}

}  // namespace
}  // namespace murosimf
