// Simplified dynamics on the ground against closed forms: rest, tipping, falling about an edge, limbs that react.

#include <gtest/gtest.h>

#include <cmath>

#include "book/page.h"
#include "modules/single_body.h"

namespace murosimf::motion {
namespace {

constexpr double kG = 9.81, kMass = 2;
constexpr double kRestitution = 0.3;

SurfacePair turf(double stiffness) {
  SurfacePair pair;
  pair.stiffness = stiffness, pair.restitution_factor = kRestitution, pair.dissipation = 5;
  pair.friction = 2, pair.stick_speed = 2e-3, pair.viscous_friction = 10;
  return pair;
}
/// Depth of a weight on ground of the law `smooth`, whose force at rest is (1 + s_b)/2 of the one while approaching.
double restingDepth(double force, double stiffness) { return force * 2 / ((1 + kRestitution) * stiffness); }

TEST(SimplifiedGround, BoxStandsAtTheDepthOfItsWeightLeaningTowardsItsCentreOfMass) {
  constexpr double kStiffness = 1e4, kHalfLength = 0.1, kOffset = 0.02;
  SingleBody b(bodyOf(makeBox({2 * kHalfLength, 0.1, 0.06}), boxMass(kMass, {0.2, 0.1, 0.06}, {kOffset, 0, 0})),
               turf(kStiffness), 1e-3, simplified("smooth_contact"));
  b.set({Rotation3{}, {0, 0, 0.03}});
  b.run(3);
  const double spring = kMass * kG / restingDepth(kMass * kG, kStiffness);  // of all four corners, at rest
  EXPECT_NEAR(0.03 - b.pose().translation.z, kMass * kG / spring, 2e-6);
  // Forces of the corners: spring/4 (d + tilt x); their moment about the middle of the lower face is the weight's,
  // whose centre leans over by 3 cm times the tilt.
  const double tilt = kMass * kG * kOffset / (spring * kHalfLength * kHalfLength - kMass * kG * 0.03);
  EXPECT_NEAR(-b.pose().rotation.x.z, tilt, 1e-3 * tilt);
  EXPECT_LT(norm(b.velocity().v), 1e-6);
}

/// A tall box that stands on its lower edge at the origin and leans by `angle`.
SingleBody leaningBox(double angle, double step) {
  const Vector3 edges{0.06, 0.2, 0.2};
  SingleBody b(bodyOf(makeBox(edges), boxMass(kMass, edges, {})), turf(1e6), step, simplified("hunt_crossley_contact"));
  const Rotation3 R = rotationY(angle);
  b.set({R, Vector3{} - R * Vector3{0.03, 0, -0.1}});
  return b;
}

TEST(SimplifiedGround, BoxTipsWhenItsCentreLeavesTheEdgeItStandsOn) {
  const double critical = std::atan2(0.03, 0.1), half_degree = kPi / 360;
  for (const double excess : {-half_degree, half_degree}) {
    SingleBody b = leaningBox(critical + excess, 1e-3);
    b.run(2);
    EXPECT_EQ(b.pose().rotation.z.z<0.5, excess> 0) << excess;
  }
}

TEST(SimplifiedGround, BoxFallsAboutItsEdgeAsAPendulumDoes) {
  book::Page page({book::Chapter::kOnTheGround,
                   "A box falls about its edge as a pendulum does",
                   R"(\dot\theta^2 = \frac{2 m g l (\cos\theta_0 - \cos\theta)}{I + m l^2})",
                   "Energy of a body that turns about an edge",
                   {{"l", "from the edge to the centre of mass", "m"},
                    {"I", "inertia about the centre of mass", "kg m^2"},
                    {"\\theta_0", "lean at first, beyond the edge, here 0.1", "rad"}},
                   {"lean beyond the edge $\\theta$", "rad"},
                   {"rate $\\dot\\theta$", "rad/s"}});
  const double critical = std::atan2(0.03, 0.1), l = std::hypot(0.03, 0.1);
  const double I = kMass / 12 * (0.06 * 0.06 + 0.2 * 0.2), start = 0.1;
  const auto rate = [&](double lean) {
    return std::sqrt(2 * kMass * kG * l * (std::cos(start) - std::cos(lean)) / (I + kMass * l * l));
  };
  page.curve(start, 0.6, rate);
  SingleBody b = leaningBox(critical + start, 2e-4);
  double theta = start;
  for (const double until : {0.2, 0.3, 0.4, 0.5, 0.6}) {
    while (theta < until) {
      b.step();
      theta = std::atan2(b.pose().rotation.z.x, b.pose().rotation.z.z) - critical;
    }
    EXPECT_TRUE(page.near(theta, b.velocity().w.y, rate(theta), 0.01 * rate(theta)));
  }
}

constexpr double kArm = 0.5;  // [kg]

/// A box on the ground with a weight that slides upwards.
const RobotBlueprint& lift() {
  static const RobotBlueprint print = [] {
    TreeBuilder builder;
    Body base{"body", boxMass(kMass, {0.2, 0.2, 0.06}, {})};
    BodyShape carried;
    carried.shape = makeBox({0.2, 0.2, 0.06});
    carried.surface = "plastic";
    base.shapes.push_back(carried);
    const Body weight{"weight", boxMass(kArm, {0.04, 0.04, 0.04}, {})};
    builder.base("base")
        .body(base)
        .prismatic("lift", kAxisZ, {-9, 9, 100, 100}, ServoParameters{"test", 10, 100, 1, 0, 0, 0})
        .body(weight);
    RobotModel model;
    model.name = "lift";
    model.tree = builder.build();
    RobotBlueprint made{std::move(model), {}};
    made.flat = flattenTree(made.model.tree);
    return made;
  }();
  return print;
}

class Lift {
 public:
  explicit Lift(const DynamicLevel& level, double step = 1e-3) : world_(step, onGround(turf(1e4))) {
    robot_ = world_.add("lift", lift(), {0});
    world_.link(level.with("tracking_servo.largest_acceleration", kAcceleration));
    world_.run(2);
    world_.linked().handle(robot_, kJointCommand, subset::kJoints).set({9, 0, 0, 1, 0});
    world_.run(1.5);
  }
  double depth() { return 0.03 - world_.base(robot_).translation.z; }
  DynamicWorld& world() { return world_; }
  ObjectId robot() const { return robot_; }

  static constexpr double kAcceleration = 4;

 private:
  DynamicWorld world_;
  ObjectId robot_;
};

TEST(SimplifiedGround, RaisedArmPressesOnTheGroundInVersionTwoAlone) {
  const double weight = (kMass + kArm) * kG, push = kArm * Lift::kAcceleration, share = restingDepth(push, 1e4);
  Lift ignores(simplified().with("simplified_dynamics.recompute", 0));
  EXPECT_NEAR(ignores.depth(), restingDepth(weight, 1e4), 1e-3 * share);
  // Rates that are held over a step press a little too much: by a share that goes with the step.
  const double coarse = Lift(simplified(), 1e-3).depth(), fine = Lift(simplified(), 5e-4).depth();
  EXPECT_NEAR(coarse, restingDepth(weight + push, 1e4), 0.2 * share);
  EXPECT_NEAR(2 * fine - coarse, restingDepth(weight + push, 1e4), 2e-3 * share);
}

TEST(TorqueEstimate, LiftNeedsTheForceThatCarriesAndAcceleratesItsWeight) {
  DynamicLevel level = simplified();
  level.modules.push_back("torque_estimate");
  Lift lift(level);
  const double force = kArm * (kG + Lift::kAcceleration);
  EXPECT_NEAR(lift.world().get(lift.robot(), kMeasuredTorque, subset::kJoints), force, 1e-4 * force);
  EXPECT_NEAR(lift.world().get(lift.robot(), kServoLoad, subset::kJoints), force / 10, 1e-5 * force);
}

}  // namespace
}  // namespace murosimf::motion
