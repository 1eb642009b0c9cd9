// Contact with the ground against closed forms: rest, restitution, friction, tipping, rolling.

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "book/page.h"
#include "modules/single_body.h"
#include "murosimf/algorithms/contact_law.h"

namespace murosimf::motion {
namespace {

constexpr double kG = 9.81, kMass = 2;

SurfacePair turf(double stiffness = 1e4) {
  SurfacePair pair;
  pair.stiffness = stiffness, pair.restitution_factor = 0.3, pair.dissipation = 5;
  pair.friction = 0.6, pair.stick_speed = 2e-3, pair.viscous_friction = 10;
  return pair;
}
RobotBlueprint box() { return bodyOf(makeBox({0.2, 0.1, 0.06}), boxMass(kMass, {0.2, 0.1, 0.06}, {})); }
RobotBlueprint ball(double radius) {
  return bodyOf(
      makeSphere(radius),
      {kMass, {}, {.4 * kMass * radius * radius, .4 * kMass * radius * radius, .4 * kMass * radius * radius, 0, 0, 0}});
}

struct RestOf {
  const char* contact;
  double depth;  ///< in m g / s_c
};
class GroundContacts : public testing::TestWithParam<RestOf> {};

TEST_P(GroundContacts, CarryABoxAtTheDepthOfTheirLaw) {
  SingleBody b(box(), turf(), 1e-3, GetParam().contact, "implicit_euler");
  b.set({Rotation3{}, {0, 0, 0.0299}});
  b.run(2);
  EXPECT_NEAR(0.03 - b.pose().translation.z, GetParam().depth * kMass * kG / 1e4, 1e-7);
  EXPECT_LT(norm(b.velocity().v), 1e-6);
}
INSTANTIATE_TEST_SUITE_P(Laws, GroundContacts,
                         testing::Values(RestOf{"hunt_crossley_contact", 1}, RestOf{"smooth_contact", 2 / 1.3}),
                         [](const auto& test) { return std::string(test.param.contact); });

TEST(GroundContact, PaperLawRestsBetweenTheDepthsOfItsTwoFactors) {
  SingleBody b(box(), turf(), 1e-3, "paper_contact", "implicit_euler");
  b.set({Rotation3{}, {0, 0, 0.0299}});
  b.run(2);
  const double shallow = kMass * kG / 1e4, depth = 0.03 - b.pose().translation.z;
  EXPECT_GT(depth, shallow);
  EXPECT_LT(depth, shallow / 0.3);
}

/// Speed with which a ball leaves the ground over that with which it came, after an impact at `speed`.
double restitutionOf(const char* contact, const SurfacePair& pair, double speed) {
  SingleBody b(ball(0.05), pair, 0.05 / std::sqrt(pair.stiffness) / 50, contact, "runge_kutta_4");
  b.set({Rotation3{}, {0, 0, 0.05}}, {{}, {0, 0, -speed}});
  b.step();
  while (b.pose().translation.z < 0.05) b.step();
  return b.worldVelocity().z / speed;
}

TEST(GroundContact, PaperAndSmoothReturnTheSquareRootOfTheirFactor) {
  // With gravity e = sqrt((s_b - delta)/(1 - delta)), delta = 2 m g/(s_c D), D the largest depth [physics of eq. 1].
  book::Page page({book::Chapter::kRestAndImpact,
                   "The ground of robots returns the root of its factor, less what gravity takes",
                   "e = \\sqrt{\\frac{s_b - \\delta}{1 - \\delta}}, \\quad \\delta = \\frac{2 m g}{k D}\n"
                   R"(D = \frac{m g}{k} \left( 1 + \sqrt{1 + \frac{k v^2}{m g^2}} \right))",
                   "Energy of spring and height on the way in and on the way out",
                   {{"D", "largest depth", "m"},
                    {"s_b", "restitution factor, here 0.3", ""},
                    {"k", "stiffness, here 10 kN/m", "N/m"}},
                   {"speed $v$", "m/s"},
                   {"restitution $e$", ""}});
  const auto expected = [](double speed) {
    const double mg = kMass * kG, s_c = 1e4;
    const double D = mg / s_c * (1 + std::sqrt(1 + s_c * speed * speed / (mg * kG)));
    const double delta = 2 * mg / (s_c * D);
    return std::sqrt((0.3 - delta) / (1 - delta));
  };
  page.series("paper").curve(1, 4, expected);
  for (const double speed : {1.5, 2.0, 3.0, 4.0}) {
    EXPECT_TRUE(page.series("paper").near(speed, restitutionOf("paper_contact", turf(), speed), expected(speed), 1e-3));
    // Its passage is .02 m/s wide.
    EXPECT_TRUE(
        page.series("smooth").near(speed, restitutionOf("smooth_contact", turf(), speed), expected(speed), 1e-2));
  }
}

TEST(GroundContact, HuntCrossleyReturnsTheRootOfItsEquation) {
  SurfacePair pair = turf(1e8);  // so stiff that gravity does nothing during the impact
  pair.normal_law = NormalLaw::kHuntCrossley;
  book::Page page({book::Chapter::kRestAndImpact,
                   "The ground of robots returns the root of Hunt and Crossley's equation",
                   R"(a (1 + e) = \ln\frac{1 + a}{1 - a e}, \quad a = d v)",
                   "[Hunt & Crossley 1975], solved for a linear spring",
                   {{"d", "dissipation", "s/m"}, {"v", "speed before the impact, here 1", "m/s"}},
                   {"dissipation $d$", "s/m"},
                   {"restitution $e$", ""}});
  const auto expected = [&](double dissipation) {
    pair.dissipation = dissipation;
    return restitution(pair, 1);
  };
  page.curve(0.1, 2, expected);
  for (const double dissipation : {0.2, 0.6, 1.2, 2.0}) {
    const double e = expected(dissipation);
    EXPECT_TRUE(page.near(dissipation, restitutionOf("hunt_crossley_contact", pair, 1), e, 2e-3));
  }
}

TEST(GroundContact, DryFrictionStopsABoxAfterTheLengthOfCoulombsLaw) {
  book::Page page({book::Chapter::kFriction,
                   "A sliding box stops after the length of Coulomb's law",
                   R"(s = \frac{v_0^2}{2 \mu g})",
                   "Coulomb's law",
                   {{"\\mu", "coefficient of friction, here 0.6", ""}},
                   {"speed at first $v_0$", "m/s"},
                   {"way until it stands $s$", "m"}});
  const auto way = [](double v) { return v * v / (2 * 0.6 * kG); };
  page.curve(0, 1.1, way);
  for (const double speed : {0.3, 0.5, 0.8, 1.0}) {
    SingleBody b(box(), turf(), 1e-3, "hunt_crossley_contact", "implicit_euler");
    b.set({Rotation3{}, {0, 0, 0.03 - kMass * kG / 1e4}}, {{}, {speed, 0, 0}});
    b.run(1);
    EXPECT_TRUE(page.near(speed, b.pose().translation.x, way(speed), 1e-3));
    EXPECT_LT(std::fabs(b.worldVelocity().x), 1e-6);
  }
}

TEST(GroundContact, ViscousFrictionSlowsABoxExponentially) {
  SurfacePair pair = turf();
  pair.viscous_friction = 0.5;
  SingleBody b(box(), pair, 1e-3, "smooth_contact", "implicit_euler");
  b.set({Rotation3{}, {0, 0, 0.03 - 2 / 1.3 * kMass * kG / 1e4}}, {{}, {0.5, 0, 0}});
  book::Page page({book::Chapter::kFriction,
                   "Viscous friction slows a box of a robot's dynamics exponentially",
                   R"(v = v_0 \, e^{-c_v g t})",
                   "Newton with friction c_v F_n v [Friedmann 2007]",
                   {{"c_v", "viscous friction, here 0.5", "s/m"}},
                   {"time $t$", "s"},
                   {"speed $v$", "m/s"}});
  const auto speed = [](double t) { return 0.5 * std::exp(-0.5 * kG * t); };
  page.curve(0, 0.4, speed);
  for (int i = 1; i <= 8; ++i) {
    b.run(0.05);
    EXPECT_TRUE(page.near(0.05 * i, b.worldVelocity().x, speed(0.05 * i), 2e-3));
  }
}

TEST(GroundContact, SlidingBallRollsAwayWithFiveSeventhsOfItsSpeed) {
  book::Page page(
      {book::Chapter::kRolling,
       "A solid ball that slides rolls away with 5/7 of its speed",
       "v = v_0 - \\mu g t, \\quad r \\omega = \\frac{5}{2} \\mu g t \\quad \\mathrm{until} \\; v = r \\omega = "
       "\\frac{5}{7} v_0",
       "Coulomb's law, I = 2/5 m r^2",
       {{"\\mu", "coefficient of friction, here 0.6", ""}, {"\\omega", "spin", "rad/s"}},
       {"time $t$", "s"},
       {"speed", "m/s"}});
  SurfacePair pair = turf();
  SingleBody b(ball(0.05), pair, 1e-3, "hunt_crossley_contact", "implicit_euler");
  b.set({Rotation3{}, {0, 0, 0.05 - kMass * kG / 1e4}}, {{}, {1, 0, 0}});
  const auto speed = [](double t) { return std::max(5.0 / 7, 1 - 0.6 * kG * t); };
  const auto spin = [](double t) { return std::min(5.0 / 7, 2.5 * 0.6 * kG * t); };
  page.series("$v$").curve(0, 0.15, speed), page.series("$r \\omega$").curve(0, 0.15, spin);
  for (int i = 1; i <= 15; ++i) {
    b.run(0.01);
    EXPECT_TRUE(page.series("$v$").near(0.01 * i, b.worldVelocity().x, speed(0.01 * i), 0.01));
    const double turning = (b.pose().rotation * b.velocity().w).y * 0.05;
    // While it slides its lever is shorter than r by the depth of the contact, 2 mm of 50.
    EXPECT_TRUE(page.series("$r \\omega$").near(0.01 * i, turning, spin(0.01 * i), i < 6 ? 0.025 : 0.01));
  }
  b.run(0.35);
  EXPECT_NEAR(b.worldVelocity().x, 5.0 / 7, 0.01);
  EXPECT_NEAR((b.pose().rotation * b.velocity().w).y * 0.05, 5.0 / 7, 0.01);
}

/// Whether a box of this width and height that leans by `angle` about its lower edge falls onto its side.
bool tips(double angle, double width, double height) {
  const Vector3 edges{width, 0.2, height};
  SingleBody b(bodyOf(makeBox(edges), boxMass(kMass, edges, {})), turf(1e6), 1e-3, "hunt_crossley_contact",
               "implicit_euler");
  const Rotation3 R = rotationY(angle);
  b.set({R, Vector3{} - R * Vector3{width / 2, 0, -height / 2}});  // the edge at the origin
  b.run(2);
  return b.pose().rotation.z.z < std::cos(1.2 * std::atan(width / height));
}

TEST(GroundContact, BoxTipsWhenItsCentreLeavesTheEdgeItStandsOn) {
  book::Page page({book::Chapter::kOnTheGround,
                   "A box tips as soon as its centre of mass is beyond the edge that it stands on",
                   R"(\tan \alpha = w / h)",
                   "Balance of moments about the edge; found by halving",
                   {{"\\alpha", "lean at which the box falls onto its side", "rad"},
                    {"w, h", "width and height of the box, h here 0.2", "m"}},
                   {"slenderness $w / h$", ""},
                   {"lean $\\alpha$", "rad"}});
  page.curve(0.15, 1.05, [](double slenderness) { return std::atan(slenderness); });
  for (const double slenderness : {0.2, 0.3, 0.45, 0.7, 1.0}) {
    const double height = 0.2, theory = std::atan(slenderness);
    double stands = theory - 0.1, falls = theory + 0.1;
    ASSERT_FALSE(tips(stands, slenderness * height, height));
    ASSERT_TRUE(tips(falls, slenderness * height, height));
    while (falls - stands > 1e-3) {
      const double middle = (stands + falls) / 2;
      (tips(middle, slenderness * height, height) ? falls : stands) = middle;
    }
    EXPECT_TRUE(page.near(slenderness, (stands + falls) / 2, theory, 2e-3));
  }
}

TEST(GroundContact, CylinderStandsOnItsEndAndLiesOnItsSide) {
  const double radius = 0.04, half_length = 0.06;
  const MassProperties mass{kMass, {}, {3e-3, 3e-3, 2e-3, 0, 0, 0}};
  SingleBody b(bodyOf(makeCylinder(radius, 2 * half_length), mass), turf(), 1e-3, "hunt_crossley_contact",
               "implicit_euler");
  b.set({Rotation3{}, {0, 0, half_length}});
  b.run(1);
  EXPECT_NEAR(b.pose().translation.z, half_length - kMass * kG / 1e4, 1e-5);
  EXPECT_GT(b.pose().rotation.z.z, 0.999999);
  b.set({rotationY(kPi / 2), {0, 0, radius}});
  b.run(1);
  EXPECT_NEAR(b.pose().translation.z, radius - 1.5 * kMass * kG / 1e4, 1e-5);  // on two of three points
  EXPECT_LT(std::fabs(b.pose().rotation.z.z), 1e-3);
}

TEST(GroundContact, EllipsoidRestsOnItsShortestRadius) {
  const Vector3 radii{0.08, 0.06, 0.03};
  const MassProperties mass{kMass, {}, {2e-3, 3e-3, 4e-3, 0, 0, 0}};
  SingleBody b(bodyOf(makeEllipsoid(radii), mass), turf(), 1e-3, "smooth_contact", "implicit_euler");
  b.set({rotationX(0.4) * rotationY(0.3), {0, 0, 0.07}});
  b.run(20);
  EXPECT_NEAR(b.pose().translation.z, radii.z - 2 / 1.3 * kMass * kG / 1e4, 1e-4);
}

TEST(GroundContact, SurfaceWithoutAPairWithTheGroundIsRefused) {
  DynamicWorld world(1e-3, SurfaceTable{});
  world.add("body", box(), {});
  try {
    world.link({{"tree_motion", "smooth_contact", "multibody_dynamics", "implicit_euler"}});
    FAIL() << "linked";
  } catch (const std::runtime_error& problem) {
    EXPECT_NE(std::string(problem.what())
                  .find("no surface pair of plastic and turf; expected [surfaces.plastic-turf] in the scenario"),
              std::string::npos)
        << problem.what();
  }
}

}  // namespace
}  // namespace murosimf::motion
