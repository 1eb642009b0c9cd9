// Accelerations of our multibody dynamics, and what an inertial sensor makes of them, against MuJoCo's: another
// algorithm by other people.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "modules/motion_world.h"
#include "murosimf/linking/robot_module.h"
#include "peers/mujoco_robot.h"

namespace murosimf::peers {
namespace {

constexpr Variable<double> kTestTorque{"test_torque", "N m", "put on a joint by the test"};
constexpr Variable<double> kSeenJointAcceleration{"seen_joint_acceleration", "rad/s^2", "joint_acceleration, kept"};
constexpr Variable<SpatialMotion<double>> kSeenAcceleration{"seen_acceleration", "SI", "that of the base, kept"};
constexpr Variable<Vector3> kSeenUp{"seen_up", "1", "body_up of the base, kept"};

/// Puts torques on joints.
class TestTorque final : public RobotModule {
  void declare(Declaration& d) const override {
    d.runsIn(Phase::kEvaluate);
    d.adds(kTestTorque, subset::kJoints);
    d.accumulates(kJointTorque, subset::kJoints);
  }
  void bind(Links& links) override {
    given_ = links.values(kTestTorque, subset::kJoints), torque_ = links.values(kJointTorque, subset::kJoints);
  }
  void stepRobot(const RobotLane& robot, const StepTime&) const override {
    for (int j = 0; j < given_.objects; ++j) robot.set(torque_, robot.get(torque_, j) + robot.get(given_, j), j);
  }
  RobotValues<double> given_, torque_;
};

/// Keeps the accelerations that the dynamics found.
class AccelerationWitness final : public RobotModule {
  void declare(Declaration& d) const override {
    d.runsIn(Phase::kEvaluate);
    d.reads(kJointAcceleration, subset::kJoints), d.reads(kBodyAcceleration, subset::kBodies);
    d.reads(kBodyUp, subset::kBodies);
    d.adds(kSeenJointAcceleration, subset::kJoints), d.adds(kSeenAcceleration), d.adds(kSeenUp);
  }
  void bind(Links& links) override {
    joints_ = links.values(kJointAcceleration, subset::kJoints);
    bodies_ = links.values(kBodyAcceleration, subset::kBodies), ups_ = links.values(kBodyUp, subset::kBodies);
    seen_joints_ = links.values(kSeenJointAcceleration, subset::kJoints);
    seen_base_ = links.values(kSeenAcceleration), seen_up_ = links.values(kSeenUp);
  }
  void stepRobot(const RobotLane& robot, const StepTime&) const override {
    for (int j = 0; j < joints_.objects; ++j) robot.set(seen_joints_, robot.get(joints_, j), j);
    robot.set(seen_base_, robot.get(bodies_)), robot.set(seen_up_, robot.get(ups_));
  }
  RobotValues<double> joints_, seen_joints_;
  RobotValues<SpatialMotion<double>> bodies_, seen_base_;
  RobotValues<Vector3> ups_, seen_up_;
};

/// KS21 in free flight by the modules of the product.
class OurRobot {
 public:
  OurRobot() {
    registry_.add<TestTorque>("test_torque", "test", "puts torques on joints");
    registry_.add<AccelerationWitness>("acceleration_witness", "test", "keeps accelerations");
    robot_ = addRobot(world_, "robot", motion::ks21(), Colour{});
    Linker linker(world_, registry_, LinkOptions{1e-3, 1});
    for (const char* module : {"test_torque", "tree_motion", "multibody_dynamics", "acceleration_witness",
                               "dynamic_inertial_sensor", "explicit_euler"}) {
      linker.assign({robot_, module, {}, {}});
    }
    static const OutsideAccess reader(
        [](Declaration& d) { d.reads(kGyroscope, subset::kImus), d.reads(kAccelerometer, subset::kImus); });
    linker.attach({"reader", &reader, {robot_}});
    Diagnostics diagnostics;
    linked_ = linker.link(diagnostics);
    if (linked_ == nullptr) throw std::runtime_error(diagnostics.text());
  }
  PeerAcceleration accelerate(const PeerState& state, const std::vector<double>& torques) {
    auto q = linked_->handle(robot_, kJointPosition, subset::kJoints);
    auto dq = linked_->handle(robot_, kJointVelocity, subset::kJoints);
    auto torque = linked_->handle(robot_, kTestTorque, subset::kJoints);
    for (int j = 0; j < q.size(); ++j) {
      const auto i = static_cast<std::size_t>(j);
      q.set(state.q[i], j), dq.set(state.dq[i], j), torque.set(torques[i], j);
    }
    linked_->handle(robot_, kBasePose).set(state.X_WB);
    linked_->handle(robot_, kBaseVelocity).set(state.V_B);
    linked_->runFrame(0);
    const auto proper = linked_->handle(robot_, kSeenAcceleration).get();
    const Vector3 up = linked_->handle(robot_, kSeenUp).get();
    PeerAcceleration result{{proper.w, proper.v - up * 9.81}, {}};
    const auto seen = linked_->handle(robot_, kSeenJointAcceleration, subset::kJoints);
    for (int j = 0; j < seen.size(); ++j) result.joints.push_back(seen.get(j));
    return result;
  }

  Vector3 gyroscope() { return linked_->handle(robot_, kGyroscope, subset::kImus).get(); }
  Vector3 accelerometer() { return linked_->handle(robot_, kAccelerometer, subset::kImus).get(); }

 private:
  World world_;
  ModuleRegistry registry_ = allModules();
  ObjectId robot_;
  std::unique_ptr<LinkedWorld> linked_;
};

struct Tossed {
  PeerState state;
  std::vector<double> torques;
};

/// Far above the ground, joints anywhere, everything turning.
Tossed tossed(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-1, 1);
  const auto vector = [&](double size) {
    return Vector3{size * number(random), size * number(random), size * number(random)};
  };
  Tossed t;
  t.state.X_WB = {rotationExp(vector(2)), {number(random), number(random), 5}};
  t.state.V_B = {vector(5), vector(2)};
  for (std::size_t j = 0; j < motion::ks21().model.tree.joints.size(); ++j) {
    t.state.q.push_back(2 * number(random)), t.state.dq.push_back(7 * number(random));
    t.torques.push_back(3 * number(random));
  }
  return t;
}

std::vector<double> numbersOf(const PeerAcceleration& a) {
  std::vector<double> numbers = a.joints;
  for (const Vector3& v : {a.base.w, a.base.v}) numbers.insert(numbers.end(), {v.x, v.y, v.z});
  return numbers;
}

TEST(MultibodyDynamics, AcceleratesAndFeelsLikeMuJoCoInAHundredRandomStates) {
  const MujocoModel model({.robot = motion::ks21(), .servos = false});
  MujocoRobot peer(model);
  PeerSensors sensors(motion::ks21());
  OurRobot ours;
  for (unsigned seed = 0; seed < 100; ++seed) {
    const Tossed t = tossed(seed);
    peer.set(t.state);
    const std::vector<double> expected = numbersOf(peer.accelerate(t.torques));
    peer.read(sensors);
    const std::vector<double> found = numbersOf(ours.accelerate(t.state, t.torques));
    double largest = 0;
    for (const double a : expected) largest = std::max(largest, std::fabs(a));
    EXPECT_GT(largest, 10) << seed;
    for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-9 * largest) << seed;
    EXPECT_LT(norm(ours.gyroscope() - sensors.gyroscope), 1e-12) << seed;
    EXPECT_LT(norm(ours.accelerometer() - sensors.accelerometer), 1e-9 * largest) << seed;
  }
}

}  // namespace
}  // namespace murosimf::peers
