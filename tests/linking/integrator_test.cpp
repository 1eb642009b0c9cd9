// Integrators call the modules that evaluate forces, as often as their method needs, on sums that start at zero.

#include "murosimf/linking/integrator.h"

#include <gtest/gtest.h>

#include <cmath>

#include "linking/toy_world.h"
#include "murosimf/linking/links.h"

namespace murosimf::toy {
namespace {

inline constexpr Variable<double> kPull{"pull", "1/s^2", "sum of all accelerations", Storage::kStep};
inline constexpr Variable<double> kSlope{"slope", "1/s^2", "rate of the rate", Storage::kStep};
inline constexpr Variable<double> kAngleBefore{"angle_before", "rad", "at the beginning of the step", Storage::kStep};
inline constexpr Variable<double> kRateBefore{"rate_before", "rad/s", "at the beginning of the step", Storage::kStep};
constexpr double kStiffness = 40, kDrag = 0.6;

/// Adds factor times one variable of an arm to the sum of its pulls.
template <const Variable<double>& kSource, int kTenths>
class Pulls final : public RobotModule {
 public:
  void declare(Declaration& d) const override {
    d.runsIn(Phase::kEvaluate);
    d.reads(kSource, kArms);
    d.accumulates(kPull, kArms);
  }

 private:
  void bind(Links& links) override { source_ = links.values(kSource, kArms), pull_ = links.values(kPull, kArms); }
  void stepRobot(const RobotLane& robot, const StepTime&) const override {
    for (int i = 0; i < pull_.objects; ++i) {
      robot.set(pull_, robot.get(pull_, i) - 0.1 * kTenths * robot.get(source_, i), i);
    }
  }
  RobotValues<double> source_, pull_;
};
using Spring = Pulls<kAngle, 400>;
using Damper = Pulls<kRate, 6>;

/// Reads the finished sum.
class Slopes final : public RobotModule {
 public:
  void declare(Declaration& d) const override {
    d.runsIn(Phase::kEvaluate);
    d.reads(kPull, kArms);
    d.adds(kSlope, kArms);
  }

 private:
  void bind(Links& links) override { pull_ = links.values(kPull, kArms), slope_ = links.values(kSlope, kArms); }
  void stepRobot(const RobotLane& robot, const StepTime&) const override {
    for (int i = 0; i < pull_.objects; ++i) robot.set(slope_, robot.get(pull_, i), i);
  }
  RobotValues<double> pull_, slope_;
};

/// The midpoint rule: two evaluations a step.
class Midpoint final : public Integrator {
 public:
  void declare(Declaration& d) const override {
    d.reads(kSlope, kArms);
    for (const auto* variable : {&kAngle, &kRate, &kAngleBefore, &kRateBefore}) d.adds(*variable, kArms);
  }
  void link(Links& links) override {
    width_ = links.width();
    slope_ = links.values(kSlope, kArms), angle_ = links.values(kAngle, kArms), rate_ = links.values(kRate, kArms);
    angle_before_ = links.values(kAngleBefore, kArms), rate_before_ = links.values(kRateBefore, kArms);
  }
  void initialise(const BlockMemory& block) const override {
    forEach(block, [&](const RobotLane& robot, int i) { robot.set(angle_, 0.1, i); });
  }
  void step(const BlockMemory& block, const StepTime& time) const override {
    forEach(block, [&](const RobotLane& robot, int i) {
      robot.set(angle_before_, robot.get(angle_, i), i), robot.set(rate_before_, robot.get(rate_, i), i);
    });
    for (const double h : {0.5 * time.dt, time.dt}) {
      evaluate()(block, time);
      forEach(block, [&](const RobotLane& robot, int i) {
        robot.set(angle_, robot.get(angle_before_, i) + h * robot.get(rate_, i), i);
        robot.set(rate_, robot.get(rate_before_, i) + h * robot.get(slope_, i), i);
      });
    }
  }

 private:
  template <class Visit>
  void forEach(const BlockMemory& block, Visit visit) const {
    for (int lane = 0; lane < width_; ++lane) {
      for (int i = 0; i < angle_.objects; ++i) visit(RobotLane(block, width_, lane), i);
    }
  }
  int width_ = 1;
  RobotValues<double> slope_, angle_, rate_, angle_before_, rate_before_;
};

void writesPull(Declaration& d) {
  d.runsIn(Phase::kEvaluate);
  d.adds(kPull, kArms);
}

struct SpringWorld : ToyWorld {
  ObjectId robot = addRobot("a");
  SpringWorld() {
    modules.add<Spring>("spring", "test", "");
    modules.add<Damper>("damper", "test", "");
    modules.add<Slopes>("slopes", "test", "");
    modules.add<Midpoint>("midpoint", "test", "");
  }
};

TEST(Integrator, EvaluatesTheSumOfAllForcesAsOftenAsItsMethodNeeds) {
  for (const int lanes : {1, 4}) {
    SpringWorld toy;
    toy.options.lanes = lanes;
    for (const char* module : {"midpoint", "slopes", "damper", "spring"}) toy.assign(toy.robot, module);
    const auto linked = toy.link();
    ASSERT_NE(linked, nullptr) << toy.diagnostics.text();
    for (long frame = 0; frame < 1000; ++frame) linked->runFrame(frame);
    // a'' = -k a - c a', a(0) = 0.1, a'(0) = 0, after 1 s
    const double delta = 0.5 * kDrag, omega = std::sqrt(kStiffness - delta * delta);
    const double expected = 0.1 * std::exp(-delta) * (std::cos(omega) + delta / omega * std::sin(omega));
    EXPECT_NEAR(linked->handle(toy.robot, kAngle, kArms).get(1), expected, 2e-5) << lanes;
  }
}

TEST(Integrator, ForcesThatNobodyAsksForAreAnErrorThatNamesIntegrators) {
  SpringWorld toy;
  toy.addPendulums("b");
  toy.assign(toy.robot, "pendulums");
  toy.attachments.push_back({"driver", &kDriver, {toy.robot}});
  toy.assign(toy.robot, "spring", 9);
  EXPECT_TRUE(contains(toy.errors(),
                       "game.toml:9:3: error: a: module spring runs when an integrator asks for it, and there is none; "
                       "expected midpoint"));
}

TEST(Integrator, ASumAndASingleWriterOfOneVariableAreAnError) {
  SpringWorld toy;
  toy.modules.add<Says<&writesPull>>("writer", "test", "");
  for (const char* module : {"midpoint", "slopes", "damper", "writer"}) toy.assign(toy.robot, module);
  EXPECT_TRUE(
      contains(toy.errors(), "variable pull [1/s^2] of arms is written by 2 modules: damper, writer; expected one"));
}

TEST(Integrator, SumsLiveForAStepOnly) {
  Declaration declaration;
  EXPECT_THROW(declaration.accumulates(kAngle), std::logic_error);
}

}  // namespace
}  // namespace murosimf::toy
