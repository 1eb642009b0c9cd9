// Forces that jump: where they do, steps end. A ball on a floor of springs and dampers has a closed form.

#include <gtest/gtest.h>

#include <cmath>

#include "book/page.h"
#include "modules/test_rig.h"
#include "murosimf/modules/integration/dormand_prince.h"

namespace murosimf::motion {
namespace {

constexpr double kBallMass = 0.5, kSpring = 5000, kDamper = 10;  // SI

/// Pushes the base's origin out of the ground, z < 0, with -k z - c z'.
class SpringFloor final : public RobotModule {
 public:
  void declare(Declaration& d) const override {
    d.runsIn(Phase::kEvaluate);
    d.reads(kBodyHeight, subset::kBodies);
    d.reads(kBodyUp, subset::kBodies);
    d.reads(kBodyTwist, subset::kBodies);
    d.accumulates(kBodyForce, subset::kBodies);
    d.adds(kEventFunction, subset::kBodies);
  }

 private:
  void bind(Links& links) override {
    height_ = links.values(kBodyHeight, subset::kBodies), up_ = links.values(kBodyUp, subset::kBodies);
    twist_ = links.values(kBodyTwist, subset::kBodies), force_ = links.values(kBodyForce, subset::kBodies);
    event_ = links.values(kEventFunction, subset::kBodies);
  }
  void stepRobot(const RobotLane& robot, const StepTime&) const override {
    const double z = robot.get(height_);
    robot.set(event_, z);
    if (!(z < 0)) return;
    const Vector3 up = robot.get(up_);
    SpatialForce<double> force = robot.get(force_);
    force.f += up * (-kSpring * z - kDamper * dot(robot.get(twist_).v, up));
    robot.set(force_, force);
  }
  RobotValues<double> height_, event_;
  RobotValues<Vector3> up_;
  RobotValues<SpatialMotion<double>> twist_;
  RobotValues<SpatialForce<double>> force_;
};

/// Height and its rate of a ball dropped from z = h, phase after phase in closed form.
struct BouncingBall {
  std::vector<double> event_times;
  double z = 0, v = 0;

  BouncingBall(double height, double end) {
    double t = 0;
    for (bool flies = true;; flies = !flies) {
      const double z_0 = t == 0 ? height : 0, v_0 = t == 0 ? 0 : v;
      const double length = flies ? (v_0 + std::sqrt(v_0 * v_0 + 2 * kGravity * z_0)) / kGravity : contactTime(v_0);
      const double here = std::min(length, end - t);
      if (flies) z = z_0 + v_0 * here - 0.5 * kGravity * here * here, v = v_0 - kGravity * here;
      if (!flies) inContact(v_0, here);
      t += here;
      if (here < length) return;
      event_times.push_back(t);
    }
  }

 private:
  /// m z'' = -k z - c z' - m g from z = 0, z' = v_0.
  void inContact(double v_0, double t) {
    const double delta = kDamper / (2 * kBallMass), omega = std::sqrt(kSpring / kBallMass - delta * delta);
    const double A = kBallMass * kGravity / kSpring, B = (v_0 + delta * A) / omega;
    const double c = std::exp(-delta * t) * std::cos(omega * t), s = std::exp(-delta * t) * std::sin(omega * t);
    z = A * c + B * s - A;
    v = (omega * B - delta * A) * c - (omega * A + delta * B) * s;
  }
  /// Until z = 0 again, by bisection: the ball is below the ground in the first third of the period.
  double contactTime(double v_0) {
    const double omega = std::sqrt(kSpring / kBallMass);
    double low = kPi / 2 / omega, high = 1.5 * kPi / omega;
    for (int i = 0; i < 100; ++i) {
      const double middle = 0.5 * (low + high);
      inContact(v_0, middle);
      (z < 0 ? low : high) = middle;
    }
    inContact(v_0, high);
    return high;
  }
};

constexpr double kDrop = 0.1, kTime = 0.5;  // [m], [s]: two impacts and two releases

const BouncingBall& truth() {
  static const BouncingBall ball(kDrop, kTime);
  return ball;
}

Method dormandPrince(double tolerance, bool locates = true, double distance = 1e-5) {
  return {"dormand_prince",
          {{"tolerance", tolerance}, {"locate_events", locates ? 1.0 : 0.0}, {"event_distance", distance}}};
}

struct Ball {
  TestRig rig{rigidBody(kBallMass, {1e-3, 2e-3, 3e-3})};
  double evaluations = 0, events = 0;

  explicit Ball(const Method& method, int lanes = 1) {
    rig.use<SpringFloor>("spring_floor");
    rig.link(method, kFrame, lanes);
    rig.set({rotationExp(Vector3{0.3, 0.2, 0.1}), {0, 0, kDrop}}, {{0, 0, 0}, {0, 0, 0}});
  }
  void frame() {
    rig.run(kFrame);
    evaluations += rig.get(kForceEvaluations), events += rig.get(kEventCount);
    EXPECT_EQ(rig.get(kIntegrationFault), 0);
  }
  void run(double seconds) {
    for (long i = std::lround(seconds / kFrame); i > 0; --i) frame();
  }
  double z() { return rig.get(kBasePose).translation.z; }
  double v() { return (rig.get(kBasePose).rotation * rig.get(kBaseVelocity).v).z; }

 private:
  static constexpr double kFrame = 0.01;
};

TEST(ContactEvents, ImpactAndReleaseAreFoundToATenthOfANanosecond) {
  book::Page page(
      {book::Chapter::kIntegrators,
       "A ball on springs bounces as its closed form says, event by event",
       "m \\ddot z = -m g \\quad \\mathrm{for} \\; z \\geq 0\n"
       R"(m \ddot z = -m g - k z - c \dot z \quad \mathrm{for} \; z < 0)",
       "Parabolas and damped oscillations, joined where z = 0",
       {{"k", "stiffness, here 5000", "N/m"}, {"c", "damping, here 10", "N s/m"}, {"m", "mass, here 0.5", "kg"}},
       {"time $t$", "s"},
       {"height $z$", "m"}});
  page.curve(0, kTime, [](double t) { return BouncingBall(kDrop, t).z; });
  Ball ball(dormandPrince(1e-11));
  std::vector<double> found;
  for (int i = 0; i < 50; ++i) {
    ball.frame();
    EXPECT_TRUE(page.near(0.01 * (i + 1), ball.z(), BouncingBall(kDrop, 0.01 * (i + 1)).z, 1e-10));
    ASSERT_LE(ball.rig.get(kEventCount), 1);
    if (ball.rig.get(kEventCount) == 1) found.push_back(ball.rig.get(kEventTime));
  }
  ASSERT_EQ(truth().event_times.size(), 4U);
  ASSERT_EQ(found.size(), 4U);
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], truth().event_times[i], 1e-10) << i;
  EXPECT_NEAR(ball.z(), truth().z, 1e-10);
  EXPECT_NEAR(ball.v(), truth().v, 1e-9);
}

TEST(ContactEvents, StepsThatEndAtJumpsAreFewerAndMoreExactThanThoseThatTheErrorMakes) {
  for (const double tolerance : {1e-6, 1e-8, 1e-10}) {
    Ball located(dormandPrince(tolerance)), left(dormandPrince(tolerance, false));
    located.run(kTime), left.run(kTime);
    EXPECT_LT(located.evaluations, 0.7 * left.evaluations) << tolerance;
    EXPECT_LT(std::fabs(located.z() - truth().z), 0.3 * std::fabs(left.z() - truth().z)) << tolerance;
    EXPECT_LT(std::fabs(located.z() - truth().z), tolerance) << tolerance;
  }
}

TEST(ContactEvents, InLanesARobotKeepsItsBitsWhileNeighboursBounceAtOtherTimes) {
  Ball scalar(dormandPrince(1e-9));
  scalar.run(kTime);
  for (const int lanes : {4, 8}) {
    Ball ball(dormandPrince(1e-9), lanes);  // the other lanes begin on the floor
    ball.run(kTime);
    EXPECT_EQ(ball.rig.memory(), scalar.rig.memory()) << lanes;
    EXPECT_EQ(ball.evaluations, scalar.evaluations) << lanes;
  }
}

TEST(ContactEvents, ABouncingBallComesToRestInFinitelyManyEvents) {
  Ball ball(dormandPrince(1e-8));
  ball.run(4);
  EXPECT_NEAR(ball.z(), -kBallMass * kGravity / kSpring, 1e-8);
  EXPECT_NEAR(ball.v(), 0, 1e-7);
  EXPECT_GE(ball.events, 6);
  EXPECT_LT(ball.events, 40);
  const double before = ball.evaluations;
  ball.run(1);
  EXPECT_LT(ball.evaluations - before, 1 * 100 * 30);  // 100 frames of at most five steps
}

TEST(ContactEvents, EventsThatFollowTooSoonAreLeftToTheError) {
  Ball ball(dormandPrince(1e-8, true, 0.1));  // longer than a contact: releases are not located
  ball.run(kTime);
  EXPECT_EQ(ball.events, 2);
  EXPECT_NEAR(ball.z(), truth().z, 1e-6);
}

/// Holds joint positions below 0.5 rad with a spring and a damper.
class SpringStop final : public RobotModule {
 public:
  static constexpr double kAt = 0.5, kStiffness = 40, kDamping = 0.3;
  void declare(Declaration& d) const override {
    d.runsIn(Phase::kEvaluate);
    d.reads(kJointPosition, subset::kJoints);
    d.reads(kJointVelocity, subset::kJoints);
    d.accumulates(kJointTorque, subset::kJoints);
    d.adds(kEventFunction, subset::kJoints);
  }

 private:
  void bind(Links& links) override {
    q_ = links.values(kJointPosition, subset::kJoints), dq_ = links.values(kJointVelocity, subset::kJoints);
    torque_ = links.values(kJointTorque, subset::kJoints), event_ = links.values(kEventFunction, subset::kJoints);
  }
  void stepRobot(const RobotLane& robot, const StepTime&) const override {
    for (int j = 0; j < q_.objects; ++j) {
      const double over = robot.get(q_, j) - kAt;
      robot.set(event_, over, j);
      const double torque = over > 0 ? -kStiffness * over - kDamping * robot.get(dq_, j) : 0;
      robot.set(torque_, robot.get(torque_, j) + torque, j);
    }
  }
  RobotValues<double> q_, dq_, torque_, event_;
};

TEST(ContactEvents, TwoJointsOfOneRobotReachTheirStopsEachAtItsTime) {
  constexpr double kInertia = 0.02, kRates[] = {4.0, 7.0};
  TestRig rig(stand());
  for (int j = 0; j < 2; ++j) rig.joint(0, JointKind::kRevolute, 2, {0, 0, 0}, rigidBody(1, {1, 1, kInertia}));
  rig.use<Support>("support").use<SpringStop>("spring_stop");
  rig.link(dormandPrince(1e-11), 0.01);
  for (int j = 0; j < 2; ++j) rig.set(j, 0, kRates[j]);
  std::vector<double> found;
  for (int i = 0; i < 15; ++i) {
    rig.run(0.01);
    if (rig.get(kEventCount) > 0) found.push_back(rig.get(kEventTime));
  }
  ASSERT_EQ(found.size(), 3U);  // the fast one's impact and release, the slow one's impact
  EXPECT_NEAR(found[0], SpringStop::kAt / kRates[1], 1e-10);
  EXPECT_NEAR(found[1], SpringStop::kAt / kRates[0], 1e-10);
  // The slow one has been in contact since: x'' = -(k x + c x') / J.
  const double t = 0.15 - found[1], delta = SpringStop::kDamping / (2 * kInertia);
  const double omega = std::sqrt(SpringStop::kStiffness / kInertia - delta * delta);
  EXPECT_NEAR(rig.q(0), SpringStop::kAt + kRates[0] / omega * std::exp(-delta * t) * std::sin(omega * t), 1e-10);
}

}  // namespace
}  // namespace murosimf::motion
