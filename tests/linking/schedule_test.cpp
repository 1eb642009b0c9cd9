// In which order modules run, how often, and which do not run at all.

#include <gtest/gtest.h>

#include <cmath>

#include "linking/toy_world.h"
#include "murosimf/linking/schedule.h"

namespace murosimf::toy {
namespace {

inline constexpr Variable<double> kFrameSeen{"frame_seen", "1", "number of the last frame stepped in"};
inline constexpr Variable<double> kCopy{"copy", "1", "the tally as read"};

/// Counts its steps.
template <Phase kPhase>
class Counter final : public RobotModule {
 public:
  void declare(Declaration& d) const override {
    d.runsIn(kPhase);
    d.adds(kTally);
    d.adds(kFrameSeen);
    d.adds(kScratch);
  }

 private:
  void bind(Links& links) override {
    tally_ = links.values(kTally), frame_ = links.values(kFrameSeen), scratch_ = links.values(kScratch);
  }
  void stepRobot(const RobotLane& robot, const StepTime& time) const override {
    robot.set(tally_, robot.get(tally_) + 1);
    robot.set(frame_, static_cast<double>(time.frame));
    robot.set(scratch_, 100 * robot.get(tally_));
  }
  RobotValues<double> tally_, frame_, scratch_;
};
/// Copies the tally, of this frame or of the one before.
template <bool kLast>
class Copier final : public RobotModule {
 public:
  void declare(Declaration& d) const override {
    if (kLast) d.readsLast(kTally);
    if (!kLast) d.reads(kTally), d.reads(kScratch);
    d.adds(kCopy);
  }

 private:
  void bind(Links& links) override {
    tally_ = links.values(kTally), copy_ = links.values(kCopy);
    if (!kLast) scratch_ = links.values(kScratch);
  }
  void stepRobot(const RobotLane& robot, const StepTime&) const override {
    robot.set(copy_, robot.get(tally_) + (kLast ? 0.0 : robot.get(scratch_)));
  }
  RobotValues<double> tally_, copy_, scratch_;
};

struct CounterWorld : ToyWorld {
  ObjectId robot = addRobot("a");
  CounterWorld() {
    modules.add<Counter<Phase::kPrescribe>>("early", "test", "");
    modules.add<Counter<Phase::kAdvance>>("counter", "test", "");
    modules.add<Counter<Phase::kSense>>("late", "test", "");
    modules.add<Copier<false>>("copier", "test", "");
    modules.add<Copier<true>>("last_copier", "test", "");
  }
  void assignEvery(const std::string& module, double period) {
    assign(robot, module).parameters.emplace("period", WrittenParameter{{{period}, ""}, {}});
  }
};

TEST(Schedule, WritersRunBeforeReadersWhateverTheOrderOfAssignment) {
  CounterWorld toy;
  toy.assign(toy.robot, "copier");
  toy.assign(toy.robot, "counter");
  const auto linked = toy.link();
  ASSERT_NE(linked, nullptr) << toy.diagnostics.text();
  for (long frame = 0; frame < 3; ++frame) linked->runFrame(frame);
  EXPECT_EQ(linked->handle(toy.robot, kCopy).get(), 303);
}

TEST(Schedule, ReadsLastSeesTheFrameBefore) {
  CounterWorld toy;
  toy.assign(toy.robot, "last_copier");
  toy.assign(toy.robot, "counter");
  const auto linked = toy.link();
  for (long frame = 0; frame < 3; ++frame) linked->runFrame(frame);
  const double seen = linked->handle(toy.robot, kCopy).get();
  EXPECT_EQ(linked->handle(toy.robot, kTally).get(), 3);
  EXPECT_EQ(seen, 2);
}

TEST(Schedule, StepsAreMadeAtTheBeginningOfAPeriodAndSensorsReadAtItsEnd) {
  for (const std::string module : {"early", "counter", "late"}) {
    CounterWorld toy;
    toy.assignEvery(module, 0.005);
    const auto linked = toy.link();
    EXPECT_EQ(linked->handle(toy.robot, kTally).period(), 5);
    for (long frame = 0; frame < 12; ++frame) linked->runFrame(frame);
    const bool sensor = module == "late";
    EXPECT_EQ(linked->handle(toy.robot, kTally).get(), sensor ? 2 : 3) << module;
    EXPECT_EQ(linked->handle(toy.robot, kFrameSeen).get(), sensor ? 9 : 10) << module;
  }
}

TEST(Schedule, WhatNobodyReadsIsNotComputed) {
  ToyWorld toy;
  const ObjectId robot = toy.addPendulums("a");
  toy.assign(robot, "energy_watch");
  const auto unread = toy.link();
  ASSERT_EQ(unread->batches()[0].passes.size(), 1U);
  EXPECT_EQ(unread->batches()[0].column("energy", subset::kSelf), nullptr);
  EXPECT_EQ(passTable(*unread),
            "assembly             phase      module               period    \n"
            "a                    advance    pendulums            0.001 s   \n"
            "a                    sense      energy_watch         0.001 s   not scheduled: nobody reads energy\n");

  toy.attachments.push_back({"screen", &kEnergyReader, {robot}});
  const auto read = toy.link();
  EXPECT_EQ(read->batches()[0].passes.size(), 2U);
  EXPECT_FALSE(contains(passTable(*read), "not scheduled"));
  read->runFrame(0);
  const double rate = read->handle(robot, kRate, kArms).get(0), other = read->handle(robot, kRate, kArms).get(1);
  EXPECT_EQ(read->handle(robot, kEnergy).get(), 0.5 * rate * rate + 0.5 * other * other);
}

TEST(Schedule, OneRobotsReaderDoesNotMakeAnotherRobotCompute) {
  ToyWorld toy;
  const ObjectId a = toy.addPendulums("a"), b = toy.addPendulums("b");
  toy.assign(a, "energy_watch"), toy.assign(b, "energy_watch");
  toy.attachments.push_back({"screen", &kEnergyReader, {b}});
  const auto linked = toy.link();
  EXPECT_FALSE(linked->handle(a, kEnergy).valid());
  EXPECT_TRUE(linked->handle(b, kEnergy).valid());
}

TEST(Schedule, TheTableOfModulesSaysWhatEachTakesAndGives) {
  const std::string table = moduleTable(registry());
  EXPECT_TRUE(contains(table, "pendulums (motion): a row of pendulums\n"));
  EXPECT_TRUE(contains(table, "needs       length                 arms     m       l > 0, from the joint to the bob"));
  EXPECT_TRUE(contains(table, "uses        damping                arms     1/s     rate lost per rate"));
  EXPECT_TRUE(contains(table, "reads       torque                 self     1/s^2"));
  EXPECT_TRUE(contains(table, "adds        angle                  arms     rad     from hanging down"));
  EXPECT_TRUE(contains(table, "parameter   period                          s       time between two steps"));
}

#ifdef MUROSIMF_DEBUG
TEST(Schedule, FreshStepMemoryIsNotANumberInDebugBuilds) {
  CounterWorld toy;
  toy.assign(toy.robot, "counter");
  toy.assign(toy.robot, "copier");
  const auto linked = toy.link();
  std::vector<double> memory(linked->stepMemorySize(), 1.0);
  linked->runBlock(Phase::kSense, linked->batches()[0], 0, 0, memory.data());  // nobody writes in this phase
  EXPECT_TRUE(std::isnan(memory[0]));
}
#endif

}  // namespace
}  // namespace murosimf::toy
