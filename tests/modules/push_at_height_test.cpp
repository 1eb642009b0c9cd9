// A block on the ground, pushed sideways at a height z: below a/mu it slides, above it tips, at the forces that
// Coulomb's friction and the edge it would turn about say. (a: half its length, mu: friction.)

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "book/page.h"
#include "modules/single_body.h"
#include "murosimf/algorithms/gravity.h"
#include "murosimf/linking/robot_module.h"

namespace murosimf::motion {
namespace {

constexpr double kMass = 2, kHalfLength = 0.05, kFriction = 0.4, kWeight = kMass * kGravity;
constexpr double kCentre = 0.1;                           // height of the centre of mass, the body's origin [m]
constexpr double kSlidesBelow = kHalfLength / kFriction;  // [m]

/// Pushes along the body's x axis at a height over its lower face, in full after a second: who is pushed at once rocks.
class Pusher final : public RobotModule {
 public:
  static std::vector<ParameterInfo> parameters() {
    return {{"force", "N", "", 0, 0, 1e3}, {"height", "m", "", 0, 0, 1}};
  }
  explicit Pusher(const ParameterValues& values) : force_size_(values["force"]), height_(values["height"]) {}
  void declare(Declaration& d) const override {
    d.runsIn(Phase::kEvaluate);
    d.accumulates(kBodyForce, subset::kBodies);
  }

 private:
  void bind(Links& links) override { force_ = links.values(kBodyForce, subset::kBodies); }
  void stepRobot(const RobotLane& robot, const StepTime& time) const override {
    const Vector3 arm{0, 0, height_ - kCentre}, push{force_size_ * std::min(1.0, time.t), 0, 0};
    SpatialForce<double> force = robot.get(force_);
    force += SpatialForce<double>{cross(arm, push), push};
    robot.set(force_, force);
  }
  double force_size_, height_;
  RobotValues<SpatialForce<double>> force_;
};

struct Pushed {
  double acceleration = 0;  ///< in the last half second
  double way = 0, upright = 1;
};

Pushed push(DynamicLevel level, double force, double height, double seconds) {
  SurfacePair pair;
  pair.stiffness = 1e5, pair.dissipation = 5, pair.friction = kFriction, pair.stick_speed = 1e-3;
  DynamicWorld world(1e-3, onGround(pair));
  world.registry().add<Pusher>("pusher", "push", "for tests", Pusher::parameters());
  const Vector3 edges{2 * kHalfLength, 0.2, 2 * kCentre};
  const ObjectId block = world.add("block", bodyOf(makeBox(edges), boxMass(kMass, edges, {})), {});
  level.modules.emplace_back("pusher");
  world.link(level.with("pusher.force", force).with("pusher.height", height));
  world.linked().handle(block, kBasePose).set({Rotation3{}, {0, 0, kCentre - kWeight / 4e5}});
  const auto speed = [&] { return (world.base(block).rotation * world.get(block, kBaseVelocity).v).x; };
  world.run(seconds - 0.5);
  const double before = speed();
  world.run(0.5);
  return {(speed() - before) / 0.5, world.base(block).translation.x, world.base(block).rotation.z.z};
}

class PushAtAHeight : public testing::TestWithParam<bool> {
 protected:
  static DynamicLevel level() {
    return GetParam() ? multibody("hunt_crossley_contact") : simplified("hunt_crossley_contact");
  }
};
INSTANTIATE_TEST_SUITE_P(Levels, PushAtAHeight, testing::Bool(),
                         [](const auto& test) { return test.param ? "multibody" : "simplified"; });

TEST_P(PushAtAHeight, BelowHalfLengthOverFrictionABlockSlidesAsSoonAsFrictionGivesWay) {
  const double most = kFriction * kWeight;
  const Pushed holds = push(level(), 0.95 * most, 0.5 * kSlidesBelow, 2);
  EXPECT_LT(holds.way, 3e-3) << "it was to stay";
  book::Page page({book::Chapter::kOnTheGround,
                   "A block that is pushed low slides as soon as friction gives way",
                   R"(a = \frac{F - \mu m g}{m} \quad \mathrm{for} \; F > \mu m g, \; z < \frac{l}{2 \mu})",
                   "Coulomb's law and balance of moments",
                   {{"z", "height of the push, half of the largest at which it slides", "m"},
                    {"l", "length of the block, here 0.1", "m"},
                    {"\\mu", "friction, here 0.4", ""}},
                   {"push over friction $F / (\\mu m g)$", ""},
                   {"acceleration $a$", "m/s^2"}});
  const auto acceleration = [&](double share) { return (share - 1) * most / kMass; };
  page.curve(1, 1.5, acceleration);
  for (const double share : {1.2, 1.35, 1.5}) {
    const Pushed slides = push(level(), share * most, 0.5 * kSlidesBelow, 2);
    // The block leans a little on its springs, and the push with it.
    EXPECT_TRUE(page.near(share, slides.acceleration, acceleration(share), 0.02 * acceleration(share)));
    EXPECT_GT(slides.upright, 0.9999);
  }
}

TEST_P(PushAtAHeight, AboveItABlockTipsAsSoonAsTheForceLiftsItsWeightAboutTheEdge) {
  const double height = 1.4 * kSlidesBelow, most = kWeight * kHalfLength / height;
  const Pushed stands = push(level(), 0.97 * most, height, 2);
  EXPECT_GT(stands.upright, 0.9995);
  const Pushed tips = push(level(), 1.03 * most, height, 2);
  EXPECT_LT(tips.upright, 0.7);
}

}  // namespace
}  // namespace murosimf::motion
