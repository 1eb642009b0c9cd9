// The pair phase joined to a world: a ball against ground, posts, other balls and a robot that moves as it is told.

#include "murosimf/modules/contact/pair_phase.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "book/page.h"
#include "modules/stilt_walker.h"

namespace murosimf::motion {
namespace {

constexpr double kRadius = 0.07, kMassOfBall = 0.205, kBeta = 2.0 / 3.0, kFrame = 0.001;
constexpr double kRestitution = 0.6;

SurfacePair surface(double restitution_factor, double friction) {
  SurfacePair pair;
  pair.normal_law = NormalLaw::kPaper;
  pair.friction_law = FrictionLaw::kCoulomb;
  pair.stiffness = 2e4;
  pair.restitution_factor = restitution_factor;
  pair.friction = friction;
  pair.rolling_resistance = 0;
  pair.turning_friction = 0;
  return pair;
}

/// A stilt walker whose raised right foot carries an upright box, balls, posts.
struct Pitch {
  MotionWorld motion;
  ObjectId robot;
  std::vector<ObjectId> balls, fixed;
  std::optional<PairPhase> pairs;
  SurfaceTable table;

  explicit Pitch(double turf_friction = 0, double period = kFrame) : motion(kFrame, period) {
    robot = motion.add("robot", stiltWalker(), {0, 0, 0.02, 0, 0, 0});
    motion.world().set(robot, kMass, 3.3);
    const Pose X_BS{{}, {0, 0, 0.08}};
    motion.world().set(robot, kShapes, {{3, X_BS, makeBox({0.1, 0.05, 0.16}), {}, "plastic", true, true}});
    table.set("ball", "turf", surface(0.3, turf_friction));
    table.set("ball", "plastic", surface(kRestitution * kRestitution, 0));
    table.set("ball", "post", surface(0.81, 0));
    table.set("ball", "ball", surface(1.0, 0));
  }
  ObjectId addBall(const std::string& name) {
    const ObjectId ball = motion.world().addPath(name);
    motion.world().set(ball, kMass, kMassOfBall);
    motion.world().set(ball, kInertiaFactor, kBeta);
    motion.world().set(ball, kBallRadius, kRadius);
    motion.world().set(ball, kShapes, {{0, Pose{}, makeSphere(kRadius), {}, "ball", true, true}});
    balls.push_back(ball);
    return ball;
  }
  void addPost(const Vector3& place) {
    const ObjectId post = motion.world().addPath("post");
    motion.world().set(post, kFixedPose, Pose{{}, place});
    motion.world().set(post, kShapes, {{0, Pose{}, makeCylinder(0.05, 1), {}, "post", true, true}});
    fixed.push_back(post);
  }
  void link() {
    motion.world().set(motion.world().root(), kSurfaceTable, table);
    motion.attach({"pairs", &PairPhase::robotAccess(), {robot}});
    motion.attach({"pairs", &PairPhase::freeBodyAccess(), balls});
    motion.link();
    pairs.emplace(motion.world(), motion.linked(), balls, std::vector{robot}, fixed);
    command(0);
    motion.place(robot, {});
  }
  void command(double forward) { motion.command(robot, std::vector<double>{0, forward, 0.02, 0, 0, 0}); }
  void frame() {
    const long number = motion.frame();
    motion.step();
    pairs->advance(number, kFrame);
  }
  /// The foot swings forward at a speed until it is at `end`, and stops there.
  void kick(double speed, double end, int frames) {
    for (int i = 1; i <= frames; ++i) {
      command(min(speed * kFrame * (i + 9), end));  // what a slower motion aims at ends up to ten frames later
      frame();
    }
  }
  void put(ObjectId ball, const Vector3& place, const Vector3& velocity = {}) {
    pairs->placeBody(ball, {{}, place}, velocity);
  }
  Vector3 velocity(ObjectId ball) const { return motion.get(ball, kBodyVelocity); }
  bool touches(ObjectId ball, ObjectId other) const {
    for (const PairPhase::Touch& touch : pairs->touches()) {
      if (touch.body == ball && touch.partner == other) return true;
    }
    return false;
  }
};

TEST(PairPhase, AMovingFootGivesTheBallOnePlusRestitutionTimesItsSpeed) {
  book::Page page({book::Chapter::kRobots,
                   "The foot of a kinematic robot gives the ball one plus restitution times its speed",
                   R"(v = (1 + e) u)",
                   "Impact on a body of infinite mass",
                   {{"e", "restitution of the pair", ""}, {"u", "speed of the foot, here 1", "m/s"}},
                   {"period of the walking motion", "s"},
                   {"speed of the ball $v$", "m/s"}});
  page.curve(0, 0.011, [](double) { return (1 + kRestitution) * 1.0; });
  for (const double period : {kFrame, 10 * kFrame}) {
    Pitch pitch(0, period);
    const ObjectId ball = pitch.addBall("ball");
    pitch.link();
    pitch.put(ball, {0.2, -kHalfStance, kRadius});
    pitch.kick(1.0, 0.15, 250);
    EXPECT_TRUE(page.near(period, pitch.velocity(ball).x, (1 + kRestitution) * 1.0, 0.03));
    EXPECT_NEAR(pitch.velocity(ball).y, 0, 1e-12);
  }
}

TEST(PairPhase, AKickedBallSlidesAndThenRolls) {
  Pitch pitch(0.5);
  const ObjectId ball = pitch.addBall("ball");
  pitch.link();
  pitch.put(ball, {0.5, 0, kRadius}, {1.5, 0, 0});
  for (int i = 0; i < 1000; ++i) pitch.frame();
  const double rolling = 1.5 / (1 + kBeta);  // sliding friction turns it until v = w r, whatever the coefficient
  EXPECT_NEAR(pitch.velocity(ball).x, rolling, 0.01);
  EXPECT_NEAR(pitch.motion.get(ball, kBodyRate).y, rolling / kRadius, 0.01 / kRadius);
}

TEST(PairPhase, TouchesAreReportedInTheFramesInWhichTheyHappen) {
  Pitch pitch;
  const ObjectId ball = pitch.addBall("ball");
  pitch.link();
  pitch.put(ball, {0.2, -kHalfStance, kRadius});
  int frames = 0, first = -1;
  for (int i = 0; i < 250; ++i) {
    pitch.command(min(0.001 * i, 0.15));
    pitch.frame();
    if (!pitch.touches(ball, pitch.robot)) continue;
    if (first < 0) first = i;
    ++frames;
    EXPECT_EQ(i, first + frames - 1) << "one contact without a pause";
  }
  EXPECT_NEAR(first, 80, 2);  // 0.2 m less half the box and the radius, at a millimetre a frame
  EXPECT_GT(frames, 2);
  EXPECT_LT(frames, 30);
}

TEST(PairPhase, APostReturnsTheBall) {
  Pitch pitch;
  const ObjectId ball = pitch.addBall("ball");
  pitch.addPost({2, 0, 0.5});
  pitch.link();
  pitch.put(ball, {1.7, 0, kRadius}, {2, 0, 0});
  for (int i = 0; i < 300; ++i) pitch.frame();
  EXPECT_NEAR(pitch.velocity(ball).x, -0.9 * 2, 0.04);
}

TEST(PairPhase, TwoEqualBallsExchangeTheirSpeeds) {
  Pitch pitch;
  const ObjectId a = pitch.addBall("ball_a"), b = pitch.addBall("ball_b");
  pitch.link();
  pitch.put(a, {2.0, 0, kRadius}, {1, 0, 0});
  pitch.put(b, {2.3, 0, kRadius});
  for (int i = 0; i < 400; ++i) pitch.frame();
  EXPECT_NEAR(pitch.velocity(a).x, 0, 0.02);
  EXPECT_NEAR(pitch.velocity(b).x, 1, 0.02);
}

TEST(PairPhase, ARobotThatDoesNotTouchTheBallChangesNoBitOfIt) {
  const auto run = [](double robot_x) {
    Pitch pitch(0.5);
    const ObjectId ball = pitch.addBall("ball");
    pitch.link();
    pitch.motion.place(pitch.robot, {robot_x, 0, 0.3});
    pitch.put(ball, {0.8, 0.3, 0.3}, {0.4, 0.1, 0});
    for (int i = 0; i < 500; ++i) pitch.frame();
    return pitch.motion.base(ball);
  };
  EXPECT_EQ(run(0.5), run(-5.0));
}

TEST(PairPhase, PuttingABallStopsItsSpin) {
  Pitch pitch(0.5);
  const ObjectId ball = pitch.addBall("ball");
  pitch.link();
  pitch.put(ball, {1, 0, kRadius}, {1, 0, 0});
  for (int i = 0; i < 300; ++i) pitch.frame();
  pitch.put(ball, {3, 1, 0.5}, {0, 2, 0});
  EXPECT_EQ(pitch.motion.get(ball, kBodyRate), (Vector3{0, 0, 0}));
  pitch.frame();
  EXPECT_NEAR(pitch.motion.base(ball).translation.y, 1.002, 1e-12);
}

TEST(PairPhase, AMissingPairOfSurfacesIsNamed) {
  Pitch pitch;
  pitch.addBall("ball");
  pitch.table = SurfaceTable{};
  pitch.table.set("ball", "turf", surface(0.3, 0));
  try {
    pitch.link();
    FAIL() << "linked without an entry for ball and plastic";
  } catch (const std::invalid_argument& problem) {
    EXPECT_NE(std::string(problem.what()).find("no surface pair of ball and plastic"), std::string::npos)
        << problem.what();
  }
}

}  // namespace
}  // namespace murosimf::motion
