// KS21 standing: three simulators with three kinds of contact must agree on what its joints carry.

#include <gtest/gtest.h>

#include <cmath>

#include "modules/dynamic_world.h"
#include "peers/mujoco_robot.h"
#include "peers/ode_robot.h"

namespace murosimf::peers {
namespace {

constexpr int kFrames = 3000;                            // of 1 ms
constexpr double kFriction = 0.8, kSoleStiffness = 2e4;  // motion::groundTable()
constexpr double kWeight = 3.3 * 9.81;                   // [N]

/// What a robot that has come to rest looks like.
struct Posture {
  double height = 0;
  std::vector<double> q;
};

class Standing : public testing::Test {
 protected:
  Standing() : world_(1e-3), wanted_(motion::gait(0, {}, 0)) {
    robot_ = world_.add("robot", motion::ks21(), wanted_);
    world_.link(motion::multibody());
    start_ = world_.base(robot_);
    world_.run(1e-3 * kFrames);
  }
  Posture ours() {
    Posture p{world_.base(robot_).translation.z, {}};
    for (int j = 0; j < 21; ++j) p.q.push_back(world_.get(robot_, kJointPosition, subset::kJoints, j));
    return p;
  }
  /// Runs a peer that has been placed and commanded.
  template <class Robot>
  Posture settled(Robot& robot) {
    PeerSensors sensors(motion::ks21());
    for (int i = 0; i < kFrames; ++i) robot.step();
    robot.read(sensors);
    EXPECT_NEAR(norm(sensors.gyroscope), 0, 0.3);
    EXPECT_NEAR(norm(sensors.accelerometer), 9.81, 2);
    return {robot.height(), sensors.q};
  }
  /// Joints give way by the torques that they carry, `most` [rad] alike. Soles sink in by what their ground is soft:
  /// ours by weight over stiffness, the peers' hardly.
  void expectAlike(const Posture& peer, double most) {
    const Posture found = ours();
    EXPECT_NEAR(found.height + kWeight / (2 * kSoleStiffness), peer.height, 3e-4);
    for (std::size_t j = 0; j < found.q.size(); ++j) EXPECT_NEAR(found.q[j], peer.q[j], most) << j;
    EXPECT_GT(std::fabs(found.q[12] - wanted_[12]), 0.01);  // the knee carries something
  }

  motion::DynamicWorld world_;
  std::vector<double> wanted_;
  ObjectId robot_;
  Pose start_;
};

TEST_F(Standing, AsInMuJoCo) {
  const MujocoModel model({.robot = motion::ks21(), .friction = kFriction});
  MujocoRobot peer(model);
  peer.set({start_, {}, wanted_, std::vector<double>(wanted_.size(), 0.0)});
  peer.command(wanted_);
  expectAlike(settled(peer), 1e-3);
  EXPECT_EQ(peer.contacts(), 8);
}

TEST_F(Standing, AsInOde) {
  OdeRobot peer({.robot = motion::ks21(), .friction = kFriction});
  peer.place(start_, wanted_);
  peer.command(wanted_);
  expectAlike(settled(peer), 2e-3);
}

}  // namespace
}  // namespace murosimf::peers
