// The heap that is compared with MuJoCo: its model must be the one that we simulate.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "modules/motion_world.h"
#include "murosimf/world/vocabulary.h"
#include "peers/mujoco_heap.h"

namespace murosimf::peers {
namespace {

SurfaceTable table(double plastic_sole = 0.4) {
  SurfaceTable surfaces;
  const auto set = [&](std::string_view a, std::string_view b, double friction) {
    SurfacePair pair;
    pair.friction = friction;
    surfaces.set(a, b, pair);
  };
  set("plastic", "plastic", 0.4), set("plastic", "sole", plastic_sole), set("sole", "sole", 0.4);
  set("plastic", kGroundSurface, 0.7), set("sole", kGroundSurface, 0.8);
  return surfaces;
}

PeerState lying(std::mt19937& random, double height) {
  std::uniform_real_distribution<double> number(-1, 1);
  const auto vector = [&](double size) {
    return Vector3{size * number(random), size * number(random), size * number(random)};
  };
  PeerState state{{rotationExp(vector(2)), vector(0.1) + Vector3{0, 0, height}}, {vector(5), vector(2)}, {}, {}};
  for (std::size_t j = 0; j < motion::ks21().model.tree.joints.size(); ++j)
    state.q.push_back(number(random)), state.dq.push_back(7 * number(random));
  return state;
}

class Heap : public testing::Test {
 protected:
  SurfaceTable surfaces_ = table();
  MujocoHeap heap_{{.robot = motion::ks21(), .surfaces = surfaces_, .robots = 3}};
  std::mt19937 random_{1};
};

TEST_F(Heap, HandsBackTheStateThatItWasGiven) {
  for (std::size_t robot = 0; robot < 3; ++robot) {
    const PeerState given = lying(random_, 1);
    heap_.set(robot, given);
    const PeerState found = heap_.state(robot);
    EXPECT_LT(norm(found.X_WB.translation - given.X_WB.translation), 1e-15);
    EXPECT_LT(norm(found.X_WB.rotation.x - given.X_WB.rotation.x), 1e-14);
    EXPECT_LT(norm(found.V_B.v - given.V_B.v), 1e-13);
    EXPECT_LT(norm(found.V_B.w - given.V_B.w), 1e-13);
    EXPECT_EQ(found.q, given.q);
    EXPECT_EQ(found.dq, given.dq);
  }
}

TEST_F(Heap, MovesWithTheEnergyThatMuJoCoFinds) {
  double ours = 0;
  for (std::size_t robot = 0; robot < 3; ++robot) {
    const PeerState state = lying(random_, 1);
    heap_.set(robot, state);
    ours += kineticEnergy(motion::ks21(), state);
  }
  EXPECT_NEAR(heap_.kineticEnergy(), ours, 1e-11 * ours);
}

TEST_F(Heap, TouchesTheGroundWhereWeDo) {
  HeapRest ours, theirs;
  for (std::size_t robot = 0; robot < 3; ++robot) {
    PeerState state = lying(random_, 0.05);
    state.X_WB.translation.x = 3 * static_cast<double>(robot);  // far from the others
    heap_.set(robot, state);
    addGroundContacts(motion::ks21(), static_cast<int>(robot), state, ours);
  }
  heap_.collide();
  heap_.addContacts(theirs);
  EXPECT_GT(ours.pairs.size(), 10U);
  EXPECT_EQ(ours.pairs, theirs.pairs);
  EXPECT_NEAR(ours.deepest, theirs.deepest, 1e-12);
}

TEST_F(Heap, TouchesItselfNowhereAndOthersEverywhere) {
  const PeerState state = lying(random_, 1);
  heap_.set(0, state), heap_.set(1, lying(random_, 5)), heap_.set(2, state);
  HeapRest rest;
  heap_.collide();
  heap_.addContacts(rest);
  EXPECT_NO_THROW(heap_.requireNoWarning());
  for (const auto& [a, b] : rest.pairs) EXPECT_NE(a.robot, b.robot);
  const auto collides = [](const BodyShape& shape) { return shape.collides; };
  for (std::size_t i = 0; i < motion::ks21().model.tree.bodies.size(); ++i) {
    const Body& body = motion::ks21().model.tree.bodies[i];
    const int row = motion::ks21().flat.bodies[i].row;
    EXPECT_EQ(rest.pairs.contains({PeerBody{0, row}, PeerBody{2, row}}),
              std::any_of(body.shapes.begin(), body.shapes.end(), collides))
        << body.name;
  }
}

TEST(HeapModel, RefusesFrictionThatMuJoCoWouldNotMake) {
  const SurfaceTable surfaces = table(0.3);
  const PeerHeap heap{.robot = motion::ks21(), .surfaces = surfaces, .robots = 2};
  EXPECT_THROW(MujocoHeap{heap}, std::invalid_argument);
  const SurfaceTable right = table();
  const PeerHeap crowd{.robot = motion::ks21(), .surfaces = right, .robots = 30};
  EXPECT_THROW(MujocoHeap{crowd}, std::invalid_argument);
}

}  // namespace
}  // namespace murosimf::peers
