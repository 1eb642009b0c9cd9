// Exchange of levels of detail: what is carried over, what begins anew, and that nobody else notices.

#include <gtest/gtest.h>

#include "linking/toy_world.h"

namespace murosimf::toy {
namespace {

constexpr Variable<double> kMemory{"memory", "1", "of the coarse level alone"};

/// Another motion of the same pendulums: they go on at the rate they have.
class Coasting final : public RobotModule {
 public:
  void declare(Declaration& d) const override {
    d.needs(kLength, kArms);
    d.reads(kTorque);
    d.adds(kAngle, kArms);
    d.adds(kRate, kArms);
    d.adds(kMemory);
  }
  void adopt(const BlockMemory& one) const override {
    const RobotLane robot(one, 1, 0);
    robot.set(memory_, 10 * robot.get(angle_, 0) + robot.get(length_, 0));
  }

 private:
  void bind(Links& links) override {
    angle_ = links.values(kAngle, kArms), rate_ = links.values(kRate, kArms);
    memory_ = links.values(kMemory), length_ = links.values(kLength, kArms);
  }
  void initialiseRobot(const RobotLane& robot) const override { robot.set(memory_, 7.0); }
  void stepRobot(const RobotLane& robot, const StepTime& time) const override {
    for (int i = 0; i < angle_.objects; ++i) {
      robot.set(angle_, robot.get(angle_, i) + time.dt * robot.get(rate_, i), i);
    }
  }
  RobotValues<double> angle_, rate_, memory_;
  RobotValues<const double> length_;
};

/// Pendulums of different lengths, each with both motions; the ones in `coarse` begin with the coarse one.
struct Exchangeable {
  explicit Exchangeable(int count, int lanes = 4, const std::vector<int>& coarse = {}) {
    toy.modules.add<Coasting>("coasting", "motion", "");
    for (int i = 0; i < count; ++i) {
      const bool begins_coarse = std::find(coarse.begin(), coarse.end(), i) != coarse.end();
      const ObjectId robot = toy.addPendulums("p" + std::to_string(i), 0.3 + 0.05 * i);
      robots.push_back(robot);
      toy.assignments.back().level = begins_coarse ? 1 : 0;
      toy.assign(robot, "coasting");
      toy.assignments.back().level = begins_coarse ? 0 : 1;
    }
    toy.options.lanes = lanes;
    linked = toy.link();
    if (linked == nullptr) throw std::runtime_error(toy.diagnostics.text());
  }
  void run(int frames) {
    for (int i = 0; i < frames; ++i) linked->runFrame(frame++);
  }
  std::vector<double> state(int robot) {
    auto angle = linked->handle(robots[static_cast<std::size_t>(robot)], kAngle, kArms);
    auto rate = linked->handle(robots[static_cast<std::size_t>(robot)], kRate, kArms);
    std::vector<double> all;
    for (int i = 0; i < angle.size(); ++i) all.push_back(angle.get(i)), all.push_back(rate.get(i));
    return all;
  }
  ToyWorld toy;
  std::vector<ObjectId> robots;
  std::unique_ptr<LinkedWorld> linked;
  long frame = 0;
};

TEST(Exchange, CarriesOverWhatBothLevelsHaveAndLetsTheNewOneAdoptIt) {
  Exchangeable e(3);
  e.run(20);
  const std::vector<double> before = e.state(1);
  const auto memory = e.linked->handle(e.robots[1], kMemory);
  EXPECT_FALSE(memory.valid()) << "the level that it begins with has none";
  e.linked->exchange(e.robots[1], 1);
  EXPECT_EQ(e.state(1), before);
  ASSERT_TRUE(memory.valid());
  EXPECT_EQ(memory.get(), 10 * before[0] + 0.35) << "own constants come along";
  e.run(1);
  EXPECT_DOUBLE_EQ(e.state(1)[0], before[0] + 1e-3 * before[1]);
  e.linked->exchange(e.robots[1], 0);
  EXPECT_FALSE(memory.valid());
}

TEST(Exchange, NobodyElseNotices) {
  Exchangeable with(9), without(9);
  for (int k = 0; k < 200; ++k) {
    for (const int i : {0, 3, 7})
      with.linked->exchange(with.robots[static_cast<std::size_t>(i)], (k + i) % 3 == 0 ? 1 : 0);
    with.run(1), without.run(1);
  }
  for (const int i : {1, 2, 4, 5, 6, 8}) EXPECT_EQ(with.state(i), without.state(i)) << i;
  EXPECT_NE(with.state(3), without.state(3));
}

TEST(Exchange, WhoComesBackGoesOnAsIfItHadAlwaysBeenThere) {
  Exchangeable e(4), alone(1);
  e.linked->exchange(e.robots[0], 1), e.linked->exchange(e.robots[2], 1);
  e.linked->exchange(e.robots[0], 0);
  e.run(100), alone.run(100);
  EXPECT_EQ(e.state(0), alone.state(0));
}

TEST(Exchange, BlocksInWhichNobodyIsSeatedDoNotRun) {
  Exchangeable e(9, 4);
  int blocks = 0;
  const auto count = [&] {
    blocks = 0;
    for (const Batch& batch : e.linked->batches()) blocks += batch.blockCount();
    return blocks;
  };
  EXPECT_EQ(count(), 3);  // nine in fours; nobody is coarse
  for (int i = 0; i < 5; ++i) e.linked->exchange(e.robots[static_cast<std::size_t>(i)], 1);
  EXPECT_EQ(count(), 1 + 2);
}

TEST(Exchange, MembersMayBeginAtDifferentLevels) {
  Exchangeable e(5, 4, {1, 3});
  EXPECT_EQ(e.linked->batches().size(), 2U);
  EXPECT_TRUE(e.linked->handle(e.robots[3], kMemory).valid());
  EXPECT_EQ(e.linked->handle(e.robots[3], kMemory).get(), 7);
  EXPECT_EQ(e.linked->levelCount(e.robots[3]), 2);
  const std::vector<double> before = e.state(3);
  e.linked->exchange(e.robots[3], 1);
  EXPECT_EQ(e.linked->levelOf(e.robots[3]), 1);
  EXPECT_EQ(e.state(3), before);
}

TEST(Exchange, ToALevelThatWasNotLinkedIsRefused) {
  Exchangeable e(1);
  EXPECT_THROW(e.linked->exchange(e.robots[0], 2), std::invalid_argument);
  EXPECT_THROW(e.linked->exchange(e.robots[0], -1), std::invalid_argument);
}

}  // namespace
}  // namespace murosimf::toy
