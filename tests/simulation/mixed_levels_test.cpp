// Every level of detail against every other: one robot walks into another, falls onto it, and kicks the ball to it.

#include <tuple>

#include "murosimf/math/random.h"
#include "player/kick_motion.h"
#include "player/walking_engine.h"
#include "scene/touching_robots.h"

namespace murosimf::test {
namespace {

enum class Meeting { kWalksInto, kFallsOnto, kKicksTheBallTo };
/// The motion of the first robot and of the second one, and what the first one does.
using TwoLevels = std::tuple<const char*, const char*, Meeting>;
std::string nameOf(const testing::TestParamInfo<TwoLevels>& test) {
  const auto& [first, second, meeting] = test.param;
  const char* const does[] = {"walks_into", "falls_onto", "kicks_the_ball_to"};
  return fmt::format("{}_{}_{}", first, does[static_cast<int>(meeting)], second);
}

/// Largest difference of what a robot was handed over in the last frame and what the contacts say, over the latter.
double handedOverWrongly(Robots& robots, std::size_t i) {
  Simulation& simulation = robots.simulation();
  const Handle<SpatialForce<double>> force = simulation.linked().handle(robots.robot(i), kPairForce, subset::kBodies);
  const Handle<Pose> began = simulation.linked().handle(robots.robot(i), kBodyPoseLast, subset::kBodies);
  SpatialForce<double> handed, said;  // moments about each body's origin
  for (int row = 0; row < force.size(); ++row) {
    const Pose X_WB = began.get(row);
    handed += {X_WB.rotation * force.get(row).n, X_WB.rotation * force.get(row).f};
  }
  const std::uint64_t name = hashName(simulation.world().path(robots.robot(i)));
  const FrameContacts& contacts = simulation.pairs().contacts();
  double size = 0;
  const auto add = [&](const ContactSide& side, std::uint64_t whose, const Vector3& impulse, const Vector3& moment) {
    if (whose != name || side.partner < 0) return;
    said += {moment, impulse};
    size += norm(impulse) + norm(moment);
  };
  for (const ContactPair& pair : contacts.pairs) {
    add(pair.a, pair.key.name_a, pair.impulse, pair.moment_A);
    add(pair.b, pair.key.name_b, -pair.impulse, pair.moment_B);
  }
  if (size == 0) return 0;
  const double dt = simulation.frameLength();
  return (norm(handed.f * dt - said.f) + norm(handed.n * dt - said.n)) / size;
}

/// Momentum that contacts of the last frame made out of nothing, over what they passed on.
double madeOfNothing(Robots& robots) {
  double worst = 0;
  for (std::size_t i = 0; i < robots.count(); ++i) {
    if (robots.falls(i)) worst = std::max(worst, handedOverWrongly(robots, i));
  }
  return worst;
}

/// From joints at zero to the posture in which KS21 waits, in a second.
controllers::JointAngles standUp(double t) {
  controllers::JointAngles angles = controllers::walkingPose({}, 0, 0, {});
  for (double& angle : angles) angle *= std::min(1.0, t);
  return angles;
}

// Each of these says what is to be seen, and returns the largest momentum that contacts made out of nothing.

double walksInto(const char* walker, const char* other) {
  Robots two({walker, other}, {"robots.red.1.pose=[-0.35, 0, 0]", "robots.red.2.pose=[0, 0.03, {deg=180}]"});
  double wrong = 0, deepest = 0, fastest = 0, nearest = 1;
  for (int i = 0; i < 6000; ++i) {
    const double t = two.simulation().time(), share = std::clamp(t - 1, 0.0, 1.0);
    const double steps = t / 0.52;
    if (i % 10 == 0) {
      two.commandAll(0,
                     controllers::walkingPose({}, steps - std::floor(steps), std::min(1.0, t), {0.12 * share, 0, 0}));
      two.commandAll(1, standUp(t));
    }
    two.simulation().step();
    wrong = std::max(wrong, madeOfNothing(two));
    deepest = std::max(deepest, two.deepest());
    fastest = std::max(fastest, two.fastest());
    nearest = std::min(nearest, norm(two.base(0).get().translation - two.base(1).get().translation));
  }
  const bool blocked = !two.falls(0) || !two.falls(1);  // a kinematic robot stops or gives way before it touches
  EXPECT_LT(nearest, 0.33) << "they were to meet";
  EXPECT_GT(nearest, blocked ? 0.2 : 0.05) << "two discs of 0.14 m, or trunks 0.1 m deep";
  if (!blocked) {
    EXPECT_GT(deepest, 1e-6);
  }
  EXPECT_LT(deepest, 0.025);
  EXPECT_LT(fastest, 5);
  EXPECT_TRUE(two.simulation().guard().faults().empty());
  return wrong;
}

double fallsOnto(const char* upper, const char* lower) {
  Robots two({upper, lower});
  double wrong = 0, deepest = 0, fastest = 0, energy = 0;
  for (int i = 0; i < 5500; ++i) {
    if (i % 10 == 0) {
      for (std::size_t k = 0; k < 2; ++k) two.commandAll(k, standUp(two.simulation().time()));
    }
    if (i == 1500) two.put(0, {rotationY(kPi / 2), two.base(1).get().translation + Vector3{0.02, 0.01, 0.5}});
    two.simulation().step();
    if (i < 1502) continue;
    wrong = std::max(wrong, madeOfNothing(two));
    deepest = std::max(deepest, two.deepest());
    fastest = std::max(fastest, two.fastest());
    if (i >= 5300) energy = std::max({energy, two.kineticEnergy(0), two.kineticEnergy(1)});
  }
  EXPECT_GT(deepest, 1e-4) << "they were to touch";
  EXPECT_LT(deepest, 0.02);
  EXPECT_LT(fastest, 8) << "nobody falls from higher than a metre";
  EXPECT_LT(energy, 1e-2) << "they lie or stand";
  EXPECT_LT(two.deepest(), 5e-3);
  EXPECT_TRUE(two.simulation().guard().faults().empty());
  return wrong;
}

double kicksTheBallTo(const char* kicker, const char* other) {
  Robots two({kicker, other}, {"robots.red.1.pose=[0, 0, 0]", "robots.red.2.pose=[1, -0.03, {deg=180}]",
                               "ball.present=true", "ball.position=[0.17, -0.053]"});
  double wrong = 0, fastest = 0, foot = 0, farthest = 0;
  const BodyPath path(two.simulation().linked(), two.robot(0));
  const int row = two.rowOf(0, "foot_right");
  const controllers::JointAngles ready = controllers::walkingPose({}, 0, 0, {});
  controllers::KeyFramePlayer kick({controllers::kickFrames(controllers::kRight, ready)});
  kick.start(0, ready);
  for (int i = 0; i < 5500; ++i) {
    if (i % 10 == 0) {
      controllers::JointAngles angles = i < 1500 ? standUp(two.simulation().time()) : kick.step(0.01);
      two.commandAll(1, standUp(two.simulation().time()));
      const Handle<SpatialMotion<double>> motion = two.motion(0);
      if (motion.valid() && i >= 1500) controllers::addKickFeedback(controllers::kRight, motion.get().w, angles);
      two.commandAll(0, angles);
    }
    two.simulation().step();
    wrong = std::max(wrong, madeOfNothing(two));
    fastest = std::max(fastest, norm(two.ballVelocity()));
    foot = std::max(foot, norm(path.end(row).translation - path.last(row).translation) / 1e-3);
    farthest = std::max(farthest, two.ballPosition().x);
  }
  EXPECT_GT(fastest, 0.4) << "it was to be kicked";
  EXPECT_LT(fastest, 1.2 * (1 + std::sqrt(0.5)) * foot) << "a toe is a little faster than its ankle";
  EXPECT_GT(farthest, 0.7) << "it was to come there";
  EXPECT_LT(farthest, 1.0) << "and not to pass through";
  return wrong;
}

class MixedLevels : public testing::TestWithParam<TwoLevels> {};

TEST_P(MixedLevels, MeetWithImpulsesThatAreEqualAndOpposite) {
  const auto [first, second, meeting] = GetParam();
  const auto meet = meeting == Meeting::kWalksInto   ? walksInto
                    : meeting == Meeting::kFallsOnto ? fallsOnto
                                                     : kicksTheBallTo;
  EXPECT_LT(meet(first, second), 1e-12);
}

constexpr const char* kDynamic[] = {"simplified_dynamics", "multibody_dynamics"};
constexpr const char* kAll[] = {"kinematic_walking", "simplified_dynamics", "multibody_dynamics"};
INSTANTIATE_TEST_SUITE_P(OnFeet, MixedLevels,
                         testing::Combine(testing::ValuesIn(kAll), testing::ValuesIn(kAll),
                                          testing::Values(Meeting::kWalksInto, Meeting::kKicksTheBallTo)),
                         nameOf);
// Kinematic robots do not fall, but others fall onto them.
INSTANTIATE_TEST_SUITE_P(OverOthers, MixedLevels,
                         testing::Combine(testing::ValuesIn(kDynamic), testing::ValuesIn(kAll),
                                          testing::Values(Meeting::kFallsOnto)),
                         nameOf);

// ------------------------------------------------------------------------------------------------------- bounces

/// e of a ball that flies at the toe of a robot in flight.
double restitutionOnFoot(const std::string& motion, const std::string& integration, double stiffness,
                         double frame = 1e-3) {
  std::vector<std::string> overrides = {"ball.present=true", "ball.position=[3, 3]",
                                        fmt::format("surfaces.ball-sole.stiffness={}", stiffness),
                                        fmt::format("simulation.frame={}", frame)};
  if (!integration.empty()) overrides.push_back("robots.all.integration=" + integration);
  Robots one({motion}, overrides);
  const BodyPath path(one.simulation().linked(), one.robot(0));
  const int row = one.rowOf(0, "foot_right");
  one.put(0, {{}, {0, 0, 3}});
  one.simulation().step();
  const Pose X_WF = path.end(row);
  constexpr double kSpeed = 2, kRadius = 0.07;
  one.putBall(X_WF * Vector3{0.075 + kRadius + 0.004, 0, -0.029}, {-kSpeed, 0, one.motion(0).get().v.z});
  double separating = 0;
  for (double t = 0; t < 0.06; t += frame) {
    one.simulation().step();
    const Vector3 toe_S{0.075, 0, -0.029};
    const Vector3 toe = (path.end(row) * toe_S - path.last(row) * toe_S) * (1 / one.simulation().frameLength());
    const double gap = one.ballPosition().x - kRadius - (path.end(row) * toe_S).x;
    separating = one.ballVelocity().x - toe.x;
    if (separating > 0 && gap > 0) return separating / kSpeed;
  }
  return 0;
}

constexpr const char* kIntegrators[] = {"implicit_euler", "semi_implicit_euler", "midpoint", "runge_kutta_4",
                                        "dormand_prince"};
const double kRootOfFactor = std::sqrt(0.5);

TEST(BallOnAFoot, BouncesWithTheRootOfItsFactorWhateverTheRobotsIntegrator) {
  // 1e5 N/m: the ball is gone before the joints give way.
  for (const char* integrator : kIntegrators)
    EXPECT_NEAR(restitutionOnFoot("multibody_dynamics", integrator, 1e5), kRootOfFactor, 0.02 * kRootOfFactor)
        << integrator;
  EXPECT_NEAR(restitutionOnFoot("composite_body_dynamics", "", 1e5), kRootOfFactor, 0.02 * kRootOfFactor);
  // As one body; w h of ball and foot is 0.19 at 3e3 N/m, and 0.34 at 1e4.
  for (const double stiffness : {1e3, 3e3, 1e4, 1e5})
    EXPECT_NEAR(restitutionOnFoot("simplified_dynamics", "", stiffness), kRootOfFactor, 0.02 * kRootOfFactor);
}

// The damping of a leg's joints holds the foot back while a soft contact lasts, so that the ball leaves 3 % faster from
// it at 3e3 N/m than the formula of two bodies says. Steps of a tenth tell how much.
TEST(BallOnAFoot, OfLimbsThatGiveWayBouncesAsInStepsOfATenth) {
  for (const double stiffness : {3e3, 1e4}) {
    const double exact = restitutionOnFoot("multibody_dynamics", "midpoint", stiffness, 1e-4);
    EXPECT_NEAR(exact, kRootOfFactor, 0.04 * kRootOfFactor) << stiffness;
    for (const char* integrator : kIntegrators)
      EXPECT_NEAR(restitutionOnFoot("multibody_dynamics", integrator, stiffness), exact, 0.01 * exact)
          << integrator << " " << stiffness;
  }
}

}  // namespace
}  // namespace murosimf::test
