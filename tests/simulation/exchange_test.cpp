// Levels of detail exchanged while robots walk.

#include "murosimf/simulation/state_hash.h"
#include "player/walking_engine.h"
#include "scene/built_world.h"

namespace murosimf::test {
namespace {

const std::string kBoth = "\"kinematic_walking, multibody_dynamics@1000\"";  // linked with both, exchanged by the test

/// Robots that walk by the reference gait, commanded by the test.
class Walkers {
 public:
  explicit Walkers(const std::string& text) : built_(text), simulation_(built_.simulation()) {
    for (const ObjectId robot : simulation_->participants().robots) {
      commands_.push_back(simulation_->linked().handle(robot, kJointCommand, subset::kJoints));
    }
  }
  void frame() {
    if (simulation_->frame() % 10 == 0) {
      const double t = simulation_->time(), amplitude = std::min(1.0, t), share = std::clamp(t - 1, 0.0, 1.0);
      double phase = t / 0.52;
      phase -= static_cast<long>(phase);
      const auto q = controllers::walkingPose(controllers::WalkParameters{}, phase, amplitude, {0.12 * share, 0, 0});
      for (auto& joints : commands_) {
        for (int j = 0; j < joints.size(); ++j) joints.set({q[static_cast<std::size_t>(j)], 0, 0, 1, 0}, j);
      }
    }
    simulation_->step();
  }
  Simulation& simulation() { return *simulation_; }
  ObjectId robot(std::size_t i) const { return simulation_->participants().robots[i]; }
  Pose base(std::size_t i) { return simulation_->linked().handle(robot(i), kBasePose).get(); }
  std::vector<double> joints(std::size_t i) {
    const auto q = simulation_->linked().handle(robot(i), kJointPosition, subset::kJoints);
    std::vector<double> all;
    for (int j = 0; j < q.size(); ++j) all.push_back(q.get(j));
    return all;
  }

 private:
  BuiltWorld built_;
  std::unique_ptr<Simulation> simulation_;
  std::vector<Handle<ServoCommand>> commands_;
};

std::string walkers(int count) {
  std::string text =
      "[referee]\nenabled = false\n[ball]\npresent = false\n[robots.all]\nfile = \"robots/ks21.urdf\"\nmotion = " +
      kBoth + "\n";
  for (int i = 0; i < count; ++i) text += fmt::format("[robots.red.{}]\npose = [0, {}, 0]\n", i + 1, i - 1);
  return text;
}

double headingOf(const Pose& X) { return atan2(X.rotation.x.y, X.rotation.x.x); }

TEST(Exchange, KeepsPositionsAndTheBaseVelocityOfTheWalk) {
  Walkers w(walkers(1));
  for (int i = 0; i < 3000; ++i) w.frame();
  for (const int level : {1, 0}) {
    const Pose before = w.base(0);
    const std::vector<double> q = w.joints(0);
    w.simulation().linked().exchange(w.robot(0), level);
    const Pose after = w.base(0);
    EXPECT_LT(norm(after.translation - before.translation), 1e-9) << level;
    EXPECT_NEAR(headingOf(after), headingOf(before), 1e-9) << level;
    EXPECT_EQ(w.joints(0), q) << level;
    for (int i = 0; i < 3000; ++i) w.frame();
  }
}

TEST(Exchange, GivesAWalkingRobotTheMomentumOfItsKinematicWalk) {
  Walkers w(walkers(1));
  for (int i = 0; i < 3000; ++i) w.frame();
  const Pose last = w.base(0);
  for (int i = 0; i < 10; ++i) w.frame();
  const Vector3 mean = (w.base(0).translation - last.translation) * 100;
  w.simulation().interventions().exchangeLevel(w.simulation().frame(), w.robot(0), 1);
  w.frame();
  const auto V = w.simulation().linked().handle(w.robot(0), kBaseVelocity).get();
  EXPECT_LT(norm(w.base(0).rotation * V.v - mean), 0.05);
  EXPECT_GT(norm(mean), 0.1);
}

TEST(Exchange, TenTimesInAWalkDoesNotMakeARobotFall) {
  Walkers w(walkers(1));
  for (int i = 0; i < 2500; ++i) w.frame();
  const double start = w.base(0).translation.x;
  for (int k = 0; k < 10; ++k) {
    w.simulation().interventions().exchangeLevel(w.simulation().frame() + 3 * k, w.robot(0), 1 - k % 2);
    for (int i = 0; i < 800; ++i) w.frame();
    EXPECT_GT(w.base(0).rotation.z.z, 0.97) << k;
  }
  EXPECT_NEAR(w.base(0).translation.x - start, 8 * 0.12, 0.1);
  EXPECT_EQ(w.simulation().interventions().log().size(), 11U);
}

TEST(Exchange, LeavesTheBitsOfThoseWhoAreNotExchanged) {
  Walkers with(walkers(3)), without(walkers(3));
  for (int i = 0; i < 2000; ++i) {
    if (i % 37 == 0) with.simulation().interventions().exchangeLevel(i, with.robot(1), (i / 37) % 2);
    with.frame(), without.frame();
  }
  for (const std::size_t i : {std::size_t{0}, std::size_t{2}}) {
    EXPECT_EQ(with.base(i), without.base(i));
    EXPECT_EQ(with.joints(i), without.joints(i));
  }
  EXPECT_NE(with.base(1), without.base(1));
}

TEST(Exchange, AScenarioSaysFromWhenOnARobotHasWhichMotion) {
  BuiltWorld built("[referee]\nenabled = false\n[ball]\npresent = false\n" + kTwoRobots,
                   {"robots.red.1.motion=multibody_dynamics@0.05, kinematic_walking@0.1"});
  const auto simulation = built.simulation();
  const ObjectId robot = simulation->world().find("robots.red.1");
  std::vector<int> levels;
  for (int i = 0; i < 150; ++i) {
    simulation->step();
    if (i % 50 == 25) levels.push_back(simulation->linked().levelOf(robot));
  }
  EXPECT_EQ(levels, (std::vector<int>{0, 1, 0}));
}

TEST(Exchange, APlanThatNobodyUnderstandsIsRefused) {
  for (const char* plan : {"multibody_dynamics@soon", "kinematic_walking, multibody_dynamics",
                           "multibody_dynamics@2, "
                           "kinematic_walking@1",
                           "@3", "kinematic_walking,,multibody_dynamics@3"}) {
    BuiltWorld built("[robots.red.1]\nfile = \"robots/ks21.urdf\"\npose = [0, 0, 0]\nmotion = \"" + std::string(plan) +
                     "\"\n");
    const auto said = built.complaints();
    ASSERT_FALSE(said.empty()) << plan;
    EXPECT_NE(said[0].find("expected a motion, then others with rising times in seconds"), std::string::npos)
        << said[0];
  }
}

}  // namespace
}  // namespace murosimf::test
