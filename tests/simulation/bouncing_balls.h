#pragma once

/// @file Two balls on a field with a block on it: the smallest world in which something goes on.

#include <gtest/gtest.h>

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "murosimf/modules/all_modules.h"
#include "murosimf/simulation/simulation.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf::test {

/// Every test writes into a folder of its own, which is gone afterwards.
class Folder {
 public:
  Folder() {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    path_ = std::filesystem::temp_directory_path() /
            ("murosimf_" + std::to_string(::getpid()) + "_" + test->test_suite_name() + "_" + test->name());
    std::filesystem::create_directories(path_);
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

inline std::string readBytes(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}
inline void writeBytes(const std::filesystem::path& file, const std::string& bytes) {
  std::filesystem::remove(file);  // a new file is quicker than an overwritten one, which some file systems flush
  std::ofstream(file, std::ios::binary) << bytes;
}

inline void addBall(World& world, const std::string& path, const Colour& colour) {
  const ObjectId ball = world.addPath(path);
  world.set(ball, kMass, 0.205);
  world.set(ball, kInertiaFactor, 2.0 / 3);
  world.set(ball, kBallRadius, 0.07);
  world.set(ball, kShapes, {{0, Pose{}, makeSphere(0.07), colour, "ball", true, true}});
}

/// `balls` of them, at most two: "balls.orange" bounces at (0.5, 0.3), "balls.blue" rolls against the block at x = 1.
struct BouncingBalls {
  std::shared_ptr<World> world = std::make_shared<World>();
  std::unique_ptr<Simulation> simulation;
  ObjectId orange, blue;

  explicit BouncingBalls(int balls = 2) {
    SurfacePair turf;
    turf.restitution_factor = 0.5, turf.rolling_resistance = 0.05;
    SurfaceTable table;
    table.set("ball", "turf", turf);
    table.set("ball", "post", SurfacePair{});
    table.set("ball", "ball", SurfacePair{});
    world->set(world->root(), kSurfaceTable, std::move(table));
    world->set(world->root(), kGround, PaintedGround{});
    addBall(*world, "balls.orange", {1.0F, 0.4F, 0.05F});
    if (balls > 1) addBall(*world, "balls.blue", {0.1F, 0.2F, 0.9F});
    const ObjectId block = world->addPath("block");
    world->set(block, kFixedPose, Pose{{}, {1.0, -0.5, 0.1}});
    world->set(block, kShapes, {{0, Pose{}, makeBox({0.2, 0.6, 0.2}), {}, "post", true, true}});
    orange = world->find("balls.orange"), blue = world->find("balls.blue");
    link(balls > 1 ? std::vector<ObjectId>{orange, blue} : std::vector<ObjectId>{orange}, block);
    simulation->interventions().placeBody(0, orange, {0.5, 0.3, 0.8}, {-0.2, 0.1, 0});
    if (balls > 1) simulation->interventions().placeBody(0, blue, {0, -0.5, 0.07}, {1.5, 0, 0});
  }

  void link(const std::vector<ObjectId>& balls, ObjectId block) {
    const Participants who{{}, balls, {block}};
    const ModuleRegistry registry = allModules();
    Linker linker(*world, registry, {});
    attachFrame(linker, who);
    Diagnostics diagnostics;
    std::unique_ptr<LinkedWorld> linked = linker.link(diagnostics);
    EXPECT_EQ(diagnostics.text(), "");
    simulation = std::make_unique<Simulation>(world, std::move(linked), who);
  }

  void run(long frames) {
    for (long i = 0; i < frames; ++i) simulation->step();
  }
  Vector3 place(ObjectId ball) { return simulation->linked().handle(ball, kBasePose).get().translation; }
};

/// The words of the error that this throws; empty when it throws none.
template <class Act>
std::string errorOf(Act act) {
  try {
    act();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

}  // namespace murosimf::test
