// The two ways of full dynamics in one scenario: robots that have one each, and one that goes from one to the other.

#include <cmath>

#include "player/walking_engine.h"
#include "scene/built_world.h"

namespace murosimf::test {
namespace {

/// A scenario of robots with these motions, a metre apart, commanded by the test.
class Players {
 public:
  explicit Players(const std::vector<std::string>& motions)
      : built_(textFor(motions)), simulation_(built_.simulation()) {
    for (const ObjectId robot : simulation_->participants().robots)
      commands_.push_back(simulation_->linked().handle(robot, kJointCommand, subset::kJoints));
  }
  /// Walks on, all alike.
  void run(double seconds) {
    for (long i = std::lround(seconds * 1000); i > 0; --i) {
      const double t = simulation_->time(), share = std::min(1.0, t);
      const auto q = controllers::walkingPose({}, t / 0.52 - std::floor(t / 0.52), share, {0.1 * share, 0, 0});
      for (auto& joints : commands_) {
        for (int j = 0; j < joints.size(); ++j) joints.set({q[static_cast<std::size_t>(j)], 0, 0, 1, 0}, j);
      }
      simulation_->step();
    }
  }
  Simulation& simulation() { return *simulation_; }
  ObjectId robot(std::size_t i) const { return simulation_->participants().robots[i]; }
  /// Position of the base relative to the robot's place [m], then joints and their rates.
  std::vector<double> state(std::size_t i) {
    const Pose X_WB = simulation_->linked().handle(robot(i), kBasePose).get();
    const Vector3 &p = X_WB.translation, &z = X_WB.rotation.z;
    std::vector<double> all{p.x, p.y - static_cast<double>(i), p.z, z.x, z.y, z.z};
    for (const auto& property : {kJointPosition, kJointVelocity}) {
      const auto values = simulation_->linked().handle(robot(i), property, subset::kJoints);
      for (int j = 0; j < values.size(); ++j) all.push_back(values.get(j));
    }
    return all;
  }

 private:
  static std::string textFor(const std::vector<std::string>& motions) {
    std::string text =
        "[referee]\nenabled = false\n[ball]\npresent = false\n[robots.all]\nfile = \"robots/ks21.urdf\"\n";
    for (std::size_t i = 0; i < motions.size(); ++i)
      text += fmt::format("[robots.red.{}]\npose = [0, {}, 0]\nmotion = \"{}\"\n", i + 1, i, motions[i]);
    return text;
  }
  BuiltWorld built_;
  std::unique_ptr<Simulation> simulation_;
  std::vector<Handle<ServoCommand>> commands_;
};

double largestDifference(const std::vector<double>& a, const std::vector<double>& b) {
  double most = a.size() == b.size() ? 0 : 1e9;
  for (std::size_t k = 0; k < a.size() && k < b.size(); ++k) most = std::max(most, std::fabs(a[k] - b[k]));
  return most;
}

/// The modules of robot i at the level that it begins with.
std::vector<std::string> modulesOf(Players& players, std::size_t i) {
  std::vector<std::string> modules;
  for (const PassReport& report : players.simulation().linked().passes()) {
    const bool its = report.assembly == players.simulation().world().path(players.robot(i)) && report.level == 0;
    if (its) modules.push_back(report.module);
  }
  return modules;
}

TEST(FullDynamics, AMotionBringsTheModulesOfLevelFull) {
  Players players({"multibody_dynamics", "composite_body_dynamics"});
  std::vector<std::string> one = modulesOf(players, 0), other = modulesOf(players, 1);
  EXPECT_EQ(std::count(other.begin(), other.end(), "composite_body_dynamics"), 1);
  std::replace(one.begin(), one.end(), std::string("multibody_dynamics"), std::string("composite_body_dynamics"));
  std::sort(one.begin(), one.end()), std::sort(other.begin(), other.end());
  EXPECT_EQ(one, other);
}

TEST(FullDynamics, RobotsOfOneWorldCanHaveOneWayEachAndWalkAlike) {
  Players players({"multibody_dynamics", "composite_body_dynamics"});
  players.run(1.5);
  EXPECT_GT(players.state(1)[0], 0.02);
  EXPECT_LT(largestDifference(players.state(0), players.state(1)), 1e-6);
}

TEST(FullDynamics, ExchangedLiveKeepsPositionsAndVelocities) {
  Players players({"multibody_dynamics, composite_body_dynamics@1000"});
  players.run(0.8);
  const std::vector<double> before = players.state(0);
  for (const int level : {1, 0}) {
    players.simulation().linked().exchange(players.robot(0), level);
    EXPECT_LT(largestDifference(players.state(0), before), 1e-9) << level;
  }
}

TEST(FullDynamics, ExchangedByAScenarioARobotWalksOnAsIfNothingHadHappened) {
  Players players({"multibody_dynamics, composite_body_dynamics@0.8, multibody_dynamics@1.1", "multibody_dynamics"});
  for (const int level : {0, 1, 0}) {
    players.run(level == 1 ? 0.3 : 0.7);
    EXPECT_EQ(players.simulation().linked().levelOf(players.robot(0)), level);
    EXPECT_LT(largestDifference(players.state(0), players.state(1)), 1e-6) << players.simulation().time();
  }
}

}  // namespace
}  // namespace murosimf::test
