// How robots are put together into blocks of lanes, and that nobody sees it in the numbers.

#include <gtest/gtest.h>

#include <cmath>

#include "linking/toy_world.h"

namespace murosimf::toy {
namespace {

bool machineIsWide() { return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq"); }

std::vector<std::size_t> batchSizes(const LinkedWorld& linked) {
  std::vector<std::size_t> sizes;
  for (const Batch& batch : linked.batches()) sizes.push_back(batch.members.size());
  return sizes;
}

using Sizes = std::vector<std::size_t>;

TEST(Batches, EqualRobotsStandTogetherInTheOrderOfTheirPaths) {
  ToyWorld toy;
  for (const char* name : {"c", "a", "b"}) toy.addPendulums(name);
  const auto linked = toy.link();
  ASSERT_NE(linked, nullptr) << toy.diagnostics.text();
  ASSERT_EQ(batchSizes(*linked), Sizes{3});
  EXPECT_EQ(toy.world.path(linked->batches()[0].members[0]), "a");
  EXPECT_EQ(toy.world.path(linked->batches()[0].members[2]), "c");
}

TEST(Batches, NumbersMayDifferWithinABatch) {
  ToyWorld toy;
  toy.addPendulums("a", 0.3), toy.addPendulums("b", 0.4);
  const auto linked = toy.link();
  ASSERT_EQ(batchSizes(*linked), Sizes{2});
  EXPECT_EQ(linked->batches()[0].column("length", kArms)->ref.memory, MemoryKind::kOwnConstant);
  EXPECT_EQ(linked->batches()[0].column("damping", kArms)->ref.memory, MemoryKind::kSharedConstant);
}

TEST(Batches, ModulesParametersTextsAndCountsOfObjectsMakeBatchesOfTheirOwn) {
  ToyWorld toy;
  toy.addPendulums("a");
  toy.assign(toy.addPendulums("more_modules"), "energy_watch");
  toy.addPendulums("other_parameter");
  toy.assignments.back().parameters.emplace("period", WrittenParameter{{{0.002}, ""}, {}});
  toy.world.set(toy.addPendulums("other_text"), kKind, std::string("heavy"));
  toy.addPendulums("other_count", 0.3, 3);
  toy.addPendulums("z");
  const auto linked = toy.link();
  ASSERT_NE(linked, nullptr) << toy.diagnostics.text();
  EXPECT_EQ(batchSizes(*linked), (Sizes{2, 1, 1, 1, 1}));
}

TEST(Batches, AttachmentsOfOneNameAndDifferentDeclarationsMakeBatchesOfTheirOwn) {
  ToyWorld toy;
  const ObjectId a = toy.addPendulums("a"), b = toy.addPendulums("b");
  const OutsideAccess one([](Declaration&d) { d.adds(kTally); }), other([](Declaration&d) { d.adds(kOtherTally); });
  toy.attachments.push_back({"port", &one, {a}});
  toy.attachments.push_back({"port", &other, {b}});
  const auto linked = toy.link();
  EXPECT_EQ(batchSizes(*linked), (Sizes{1, 1}));
  EXPECT_TRUE(linked->handle(a, kTally).valid());
  EXPECT_FALSE(linked->handle(b, kTally).valid());
  EXPECT_TRUE(linked->handle(b, kOtherTally).valid());
}

TEST(Batches, TheWidthIsChosenByTheNumberOfRobotsAndTheMachine) {
  const auto widthOf = [](int robots, int lanes) {
    ToyWorld toy;
    toy.options.lanes = lanes;
    for (int i = 0; i < robots; ++i) toy.addPendulums("r" + std::to_string(i));
    return toy.link()->batches()[0].width;
  };
  const int widest = machineIsWide() ? 8 : 4;
  EXPECT_EQ(widthOf(1, 0), 1);
  EXPECT_EQ(widthOf(2, 0), 4);
  EXPECT_EQ(widthOf(4, 0), 4);
  EXPECT_EQ(widthOf(5, 0), widest);
  EXPECT_EQ(widthOf(9, 1), 1);
  EXPECT_EQ(widthOf(1, 4), 4);
  EXPECT_EQ(widthOf(9, 8), widest);
}

/// Angles and rates of nine different, driven rows of pendulums after some frames.
std::vector<double> swing(int lanes, int robots = 9) {
  ToyWorld toy;
  toy.options.lanes = lanes;
  std::vector<ObjectId> all;
  for (int i = 0; i < robots; ++i) all.push_back(toy.addPendulums("r" + std::to_string(i), 0.2 + 0.03 * i));
  const auto linked = toy.link();
  std::vector<double> result;
  for (long frame = 0; frame < 500; ++frame) {
    for (std::size_t i = 0; i < all.size(); ++i) {
      linked->handle(all[i], kTorque).set(sin(0.01 * static_cast<double>(frame) + static_cast<double>(i)));
    }
    linked->runFrame(frame);
  }
  for (const ObjectId robot : all) {
    for (int arm = 0; arm < 2; ++arm) result.push_back(linked->handle(robot, kAngle, kArms).get(arm));
    for (int arm = 0; arm < 2; ++arm) result.push_back(linked->handle(robot, kRate, kArms).get(arm));
  }
  return result;
}

TEST(Batches, AnyWidthGivesTheSameBits) {
  const std::vector<double> scalar = swing(1);
  EXPECT_EQ(scalar, swing(4));
  EXPECT_EQ(scalar, swing(8));
}

TEST(Batches, ARobotsBitsDoNotDependOnTheOthersOfItsBatch) {
  const std::vector<double> nine = swing(8, 9), three = swing(8, 3);
  EXPECT_TRUE(std::equal(three.begin(), three.end(), nine.begin()));
}

TEST(Batches, TheLanesBehindTheLastRobotHoldNumbers) {
  ToyWorld toy;
  toy.options.lanes = 4;
  for (int i = 0; i < 5; ++i) toy.addPendulums("r" + std::to_string(i), 0.2 + 0.1 * i);
  const auto linked = toy.link();
  for (long frame = 0; frame < 10; ++frame) linked->runFrame(frame);
  const Batch& batch = linked->batches()[0];
  ASSERT_EQ(batch.blockCount(), 2);
  for (const auto& pieces : {&batch.state, &batch.own}) {
    for (std::size_t b = 0; b < pieces->size(); ++b) {
      for (const double number : (*pieces)[b]) EXPECT_TRUE(std::isfinite(number));
    }
  }
}

TEST(Batches, ThePendulumOfAllWidthsSwingsLikeAPendulum) {
  ToyWorld toy;
  toy.options.frame_length = 1e-4;
  const ObjectId robot = toy.addPendulums("a", 0.3, 1);
  toy.world.set(toy.world.find("a.arm1"), kDamping, 0.0);
  const auto linked = toy.link();
  const double period = 2 * kPi * std::sqrt(0.3 / 9.81) * (1 + 0.1 * 0.1 / 16);  // [Huygens; first amplitude term]
  for (long frame = 0; frame < std::lround(period / 1e-4); ++frame) linked->runFrame(frame);
  EXPECT_NEAR(linked->handle(robot, kAngle, kArms).get(0), 0.1, 1e-5);
}

TEST(Handles, ReachOneRobotsObjectsThroughAnyWidth) {
  ToyWorld toy;
  toy.options.lanes = 4;
  std::vector<ObjectId> all;
  for (int i = 0; i < 6; ++i) all.push_back(toy.addPendulums("r" + std::to_string(i)));
  const auto linked = toy.link();
  for (std::size_t i = 0; i < 6; ++i) {
    Handle<double> angle = linked->handle(all[i], kAngle, kArms);
    ASSERT_EQ(angle.size(), 2);
    angle.set(static_cast<double>(10 * i), 0);
    angle.set(static_cast<double>(10 * i + 1), 1);
  }
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(linked->handle(all[i], kAngle, kArms).get(0), static_cast<double>(10 * i));
    EXPECT_EQ(linked->handle(all[i], kAngle, kArms).get(1), static_cast<double>(10 * i + 1));
  }
}

TEST(Handles, AreInvalidForWhatLinkingDidNotMake) {
  ToyWorld toy;
  const ObjectId robot = toy.addPendulums("a");
  toy.assign(robot, "energy_watch");
  const auto linked = toy.link();
  EXPECT_FALSE(linked->handle(robot, kEnergy).valid());  // nobody reads it
  EXPECT_FALSE(linked->handle(robot, kTally).valid());
  EXPECT_FALSE(linked->handle(robot, kAngle).valid());  // of the arms, not of the robot itself
  EXPECT_FALSE(linked->handle(toy.world.root(), kAngle, kArms).valid());
}

TEST(Constants, AreReadAsSetAsWrittenOrAsDefault) {
  ToyWorld toy;
  const ObjectId a = toy.addPendulums("a"), b = toy.addPendulums("b");
  toy.world.setWritten(toy.world.find("b.arm1"), "damping", {{0.0}, ""}, {"b.urdf", 1, 0});
  toy.world.setWritten(toy.world.find("b"), "kind", {{}, "heavy"}, {"b.urdf", 2, 0});
  const auto linked = toy.link();
  ASSERT_NE(linked, nullptr) << toy.diagnostics.text();
  linked->runFrame(0);
  const double pull = 9.81 / 0.3 * sin(0.1);
  EXPECT_EQ(linked->handle(a, kRate, kArms).get(0), 0.001 * (0.0 - pull - 0.0));
  EXPECT_EQ(linked->handle(b, kRate, kArms).get(0), 0.001 * (0.0 - 2 * 9.81 / 0.3 * sin(0.1) - 0.0));
  linked->runFrame(1);
  const double rate = -0.001 * pull, angle = 0.1 + 0.001 * rate;
  EXPECT_EQ(linked->handle(a, kRate, kArms).get(0), rate + 0.001 * (0.0 - 9.81 / 0.3 * sin(angle) - 0.5 * rate));
}

}  // namespace
}  // namespace murosimf::toy
