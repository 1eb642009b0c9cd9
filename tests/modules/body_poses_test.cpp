// World poses of bodies against the slow and obvious way through the kinematic tree.

#include <gtest/gtest.h>

#include "modules/stilt_walker.h"
#include "murosimf/math/random.h"

namespace murosimf::motion {
namespace {

double largestDifference(const Pose& a, const Pose& b) {
  return max(norm(a.translation - b.translation),
             max(norm(a.rotation.x - b.rotation.x),
                 max(norm(a.rotation.y - b.rotation.y), norm(a.rotation.z - b.rotation.z))));
}

TEST(BodyPoses, AreThoseOfTheKinematicTree) {
  const KinematicTree& tree = ks21().model.tree;
  const RandomStream random(1, "body poses", 0);
  for (std::uint64_t trial = 0; trial < 20; ++trial) {
    std::vector<double> q;
    for (std::size_t j = 0; j < tree.joints.size(); ++j) {
      q.push_back(random.uniform(100 * trial + j, tree.joints[j].limits.lower, tree.joints[j].limits.upper));
    }
    MotionWorld motion(0.01);
    const ObjectId robot = motion.add("robot", ks21(), q);
    motion.link();
    motion.place(robot, {0.3, -0.2, 1.1});
    motion.step();
    const std::vector<Pose> expected = elementPoses(tree, q);
    for (std::size_t i = 0; i < tree.bodies.size(); ++i) {
      const RowPlace& place = ks21().flat.bodies[i];
      const Pose X_WB = motion.get(robot, kBodyPose, subset::kBodies, place.row) * place.X_RB;
      const Pose X_WB_tree = motion.base(robot) * expected[static_cast<std::size_t>(tree.bodies[i].element)];
      EXPECT_LT(largestDifference(X_WB, X_WB_tree), 1e-14) << tree.bodies[i].name;
    }
  }
}

TEST(BodyPoses, TheLastOnesAreThoseOfTheStepBefore) {
  MotionWorld motion(0.01);
  const ObjectId robot = motion.add("robot", ks21(), gait(0, {0.2, 0, 0.3}));
  motion.link();
  motion.walk({0.2, 0, 0.3}, 1);
  const int bodies = motion.linked().handle(robot, kBodyPose, subset::kBodies).size();
  ASSERT_EQ(bodies, 22);
  for (int k = 0; k < 60; ++k) {
    std::vector<Pose> before;
    for (int i = 0; i < bodies; ++i) before.push_back(motion.get(robot, kBodyPose, subset::kBodies, i));
    motion.walk({0.2, 0, 0.3}, 1);
    for (int i = 0; i < bodies; ++i) {
      ASSERT_EQ(motion.get(robot, kBodyPoseLast, subset::kBodies, i), before[static_cast<std::size_t>(i)]);
    }
  }
}

TEST(BodyPoses, WhoWasPutSomewhereHasNoPathThere) {
  MotionWorld motion(0.01);
  const ObjectId robot = motion.add("robot", stiltWalker(), std::vector<double>(6, 0.0));
  motion.link();
  motion.step();
  for (const PlanarPose& place : {PlanarPose{1, 2, 0}, {1, 2, 1.5}, {0, 0, 0}}) {  // the second one only turns it
    motion.place(robot, place);
    motion.step();
    for (int i = 0; i < 3; ++i) {
      EXPECT_EQ(motion.get(robot, kBodyPoseLast, subset::kBodies, i), motion.get(robot, kBodyPose, subset::kBodies, i));
    }
  }
}

}  // namespace
}  // namespace murosimf::motion
