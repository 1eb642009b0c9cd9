// A response that is kept while the robot hardly moves.

#include "murosimf/algorithms/kept_response.h"

#include <gtest/gtest.h>

#include "algorithms/rigid_response.h"

namespace murosimf::test {
namespace {

/// Two boxes on a hinge about y, 0.2 m from one to the other.
struct Hinge {
  TreeResponse::Constants constants;
  std::vector<Pose> X_WB{2};
  int asked = 0;

  Hinge() {
    TreeRow base, child;
    child.parent = 0;
    child.kind = JointKind::kRevolute;
    child.axis = 1;
    child.X_PF.translation = {0.2, 0, 0};
    constants.tree.rows = {base, child};
    const RigidInertia<double> box{1, {}, {0.01, 0.01, 0.01, 0, 0, 0}};
    constants.inertia = {box, box};
    constants.armature = {0.001};
  }
  void bend(double angle) {
    X_WB[0] = {{}, {0, 0, 1}};
    X_WB[1] = X_WB[0] * Pose{rotationY(angle), {0.2, 0, 0}};
  }
  void begin(KeptResponse& response, double angle, bool joints_yield = true) {
    bend(angle);
    const double posture[] = {angle};
    response.begin(X_WB[0].translation, posture, joints_yield, [this]() -> std::span<const Pose> {
      ++asked;
      return X_WB;
    });
  }
  std::vector<ResponseBlock> exact(std::span<const int> bodies, bool joints_yield = true) const {
    TreeResponse response(constants);
    response.place(X_WB, joints_yield);
    std::vector<ResponseBlock> blocks(bodies.size() * bodies.size());
    response.respond(bodies, blocks);
    return blocks;
  }
};

void expectEqual(const std::vector<ResponseBlock>& a, const std::vector<ResponseBlock>& b, double tolerance) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t r = 0; r < 6; ++r) {
      for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(a[i].row[r][k], b[i].row[r][k], tolerance);
    }
  }
}

TEST(KeptResponse, IsComputedOnceForARobotThatStaysAndInAnyOrderOfItsBodies) {
  Hinge hinge;
  KeptResponse kept(hinge.constants);
  const int both[] = {0, 1}, turned[] = {1, 0}, one[] = {1};
  for (const double angle : {0.3, 0.3005, 0.2995}) {
    hinge.begin(kept, angle);
    expectEqual(blocksOf(kept, both), hinge.exact(both), 0.05);
  }
  hinge.begin(kept, 0.3);
  expectEqual(blocksOf(kept, turned), hinge.exact(turned), 1e-12);
  expectEqual(blocksOf(kept, one), hinge.exact(one), 1e-12);
  EXPECT_EQ(hinge.asked, 1);
}

TEST(KeptResponse, IsComputedAnewForAnotherPostureAnotherBodyAndJointsThatAreHeld) {
  Hinge hinge;
  KeptResponse kept(hinge.constants);
  const int one[] = {1}, both[] = {0, 1};
  hinge.begin(kept, 0.3);
  blocksOf(kept, one);
  hinge.begin(kept, 0.31);
  expectEqual(blocksOf(kept, one), hinge.exact(one), 1e-12);
  EXPECT_EQ(hinge.asked, 2);
  expectEqual(blocksOf(kept, both), hinge.exact(both), 1e-12);
  EXPECT_EQ(hinge.asked, 3);
  hinge.begin(kept, 0.31, false);
  expectEqual(blocksOf(kept, both), hinge.exact(both, false), 1e-12);
  EXPECT_EQ(hinge.asked, 4);
}

TEST(KeptResponse, GoesOnFromACheckpointWithTheSameBits) {
  Hinge hinge;
  KeptResponse kept(hinge.constants), copy(hinge.constants);
  const int one[] = {1};
  hinge.begin(kept, 0.3);
  blocksOf(kept, one);
  StateArchive out;
  out(kept);
  StateArchive in(out.bytes());
  in(copy);
  hinge.begin(kept, 0.3015);
  const std::vector<ResponseBlock> a = blocksOf(kept, one);
  hinge.begin(copy, 0.3015);
  expectEqual(a, blocksOf(copy, one), 0);
  EXPECT_EQ(hinge.asked, 1) << "the copy kept what was computed before";
}

}  // namespace
}  // namespace murosimf::test
