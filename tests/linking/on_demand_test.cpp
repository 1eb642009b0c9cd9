// Variables that are computed when somebody outside of the modules asks for them.

#include <gtest/gtest.h>

#include "linking/toy_world.h"

namespace murosimf::toy {
namespace {

constexpr Variable<double> kSquare{"square", "rad^2", "of the first arm's angle", Storage::kOnDemand};
constexpr Variable<double> kAnswers{"answers", "1", "how often the square was computed"};

class Squares final : public RobotModule {
 public:
  void declare(Declaration& d) const override {
    d.runsIn(Phase::kSense);
    d.reads(kAngle, kArms);
    d.adds(kAnswers);
    d.adds(kSquare);
  }

 private:
  void bind(Links& links) override {
    angle_ = links.values(kAngle, kArms);
    answers_ = links.values(kAnswers);
    square_ = links.values(kSquare);
  }
  void stepRobot(const RobotLane&, const StepTime&) const override {}
  void answerRobot(const RobotLane& robot) const override {
    robot.set(answers_, robot.get(answers_) + 1);
    robot.set(square_, robot.get(angle_) * robot.get(angle_));
  }
  RobotValues<double> angle_, answers_, square_;
};

/// Robots "a" and "b", in lanes of one block, or each in a block of its own.
struct TwoRobots : ToyWorld {
  ObjectId a = addPendulums("a"), b = addPendulums("b", 0.4);
  std::unique_ptr<LinkedWorld> linked;
  explicit TwoRobots(int lanes) {
    modules.add<Squares>("squares", "test", "");
    options.lanes = lanes;
    assign(a, "squares"), assign(b, "squares");
    linked = link();
  }
  double square(ObjectId robot) { return linked->handle(robot, kSquare).get(); }
  double answers(ObjectId robot) { return linked->handle(robot, kAnswers).get(); }
  double angle(ObjectId robot) { return linked->handle(robot, kAngle, kArms).get(); }
};

class OnDemandIn : public testing::TestWithParam<int> {};

TEST_P(OnDemandIn, WhoAsksGetsTheValueOfTheMomentWhenItWasNotAskedForEveryFrame) {
  TwoRobots robots(GetParam());
  ASSERT_NE(robots.linked, nullptr) << robots.diagnostics.text();
  for (long frame = 0; frame < 12; ++frame) {
    robots.linked->runFrame(frame);
    if (frame % 4 != 3) continue;
    EXPECT_EQ(robots.square(robots.a), robots.angle(robots.a) * robots.angle(robots.a)) << "frame " << frame;
    EXPECT_EQ(robots.square(robots.b), robots.angle(robots.b) * robots.angle(robots.b)) << "frame " << frame;
  }
}

TEST_P(OnDemandIn, OfAllFramesAndQuestionsOnlyTheFirstOneOfAFrameIsWorkAndOfWhoIsNotAskedNone) {
  TwoRobots robots(GetParam());
  ASSERT_NE(robots.linked, nullptr) << robots.diagnostics.text();
  for (long frame = 0; frame < 12; ++frame) {
    robots.linked->runFrame(frame);
    for (int question = 0; frame % 4 == 3 && question < 5; ++question) robots.square(robots.a);
  }
  EXPECT_EQ(robots.answers(robots.a), 3);
  EXPECT_EQ(robots.answers(robots.b), GetParam() == 1 ? 0 : 3) << "a block is computed as a whole";
}

INSTANTIATE_TEST_SUITE_P(Lanes, OnDemandIn, testing::Values(1, 4));

TEST(OnDemand, WhatIsComputedOnDemandIsNoMemoryAndIsComputedAnewBehindAVisitThatMayHaveChangedWhatItFollowsFrom) {
  TwoRobots robots(1);
  ASSERT_NE(robots.linked, nullptr) << robots.diagnostics.text();
  robots.linked->runFrame(0);
  robots.square(robots.a);
  const Place& place = robots.linked->placeOf(robots.linked->residentOf(robots.a));
  const double angle = robots.angle(robots.a), square = robots.square(robots.a);
  int seen = 0;
  robots.linked->visitMemory(place, [&](double& value) {
    EXPECT_NE(value, square);
    if (value != angle) return;
    value = 2, ++seen;
  });
  EXPECT_EQ(seen, 1);
  EXPECT_EQ(robots.square(robots.a), 4);
  for (const ColumnLayout& layout : robots.linked->columnsOf(place)) {
    if (layout.property != kSquare.name) continue;
    EXPECT_EQ(robots.linked->numberAt(place, layout, 0, 0), 4);
  }
}

void readsSquare(Declaration& d) { d.runsIn(Phase::kSense), d.reads(kSquare), d.adds(kTally); }

TEST(OnDemand, AModuleThatReadsInItsStepWhatIsComputedOnDemandIsRefused) {
  TwoRobots robots(1);
  robots.modules.add<Says<readsSquare>>("late", "test", "");
  robots.assign(robots.a, "late");
  EXPECT_EQ(robots.link(), nullptr);
  EXPECT_TRUE(contains(robots.diagnostics.text(),
                       "module late reads variable square [rad^2] of self, which is computed only when somebody "
                       "outside of the modules asks; expected a variable that is kept"));
}

}  // namespace
}  // namespace murosimf::toy
