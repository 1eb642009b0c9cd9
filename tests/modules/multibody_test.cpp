// Multibody dynamics without ground: what free flight conserves.

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>

#include "modules/motion_world.h"
#include "murosimf/algorithms/tree_motion.h"

namespace murosimf::motion {
namespace {

/// Robots of ks21.urdf without weight on anything: they fall.
class FlyingRobots {
 public:
  FlyingRobots(int robots, const std::string& integrator, double step, int lanes = 1) : step_(step) {
    for (int i = 0; i < robots; ++i) robots_.push_back(addRobot(world_, "r" + std::to_string(i), ks21(), Colour{}));
    Linker linker(world_, registry_, LinkOptions{step, lanes});
    for (const ObjectId robot : robots_) {
      for (const std::string& module : {std::string("tree_motion"), std::string("multibody_dynamics"), integrator}) {
        linker.assign({robot, module, {}, {}});
      }
    }
    linked_ = linker.link(diagnostics_);
    if (linked_ == nullptr) throw std::runtime_error(diagnostics_.text());
  }
  /// Gives robot i a spin, and its joints positions and rates, all from `seed`.
  void toss(std::size_t i, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> number(-1, 1);
    const auto vector = [&] { return Vector3{number(random), number(random), number(random)}; };
    auto q = linked_->handle(robots_[i], kJointPosition, subset::kJoints);
    auto dq = linked_->handle(robots_[i], kJointVelocity, subset::kJoints);
    for (int j = 0; j < q.size(); ++j) q.set(0.5 * number(random), j), dq.set(3 * number(random), j);
    linked_->handle(robots_[i], kBasePose).set({rotationExp(vector()), {0, 0, 1}});
    linked_->handle(robots_[i], kBaseVelocity).set({vector() * 3, vector()});
  }
  void run(double seconds) {
    for (const long end = frame_ + std::lround(seconds / step_); frame_ < end; ++frame_) linked_->runFrame(frame_);
  }
  /// Centre of mass, linear momentum, and angular momentum about it, in the world.
  struct Momentum {
    double mass = 0;
    Vector3 centre, linear, angular;
  };
  Momentum momentum(std::size_t i) {
    const std::vector<KernelRow> rows = kernelRows(ks21().flat.table);
    const auto q = linked_->handle(robots_[i], kJointPosition, subset::kJoints);
    const auto dq = linked_->handle(robots_[i], kJointVelocity, subset::kJoints);
    std::vector<Pose> X{linked_->handle(robots_[i], kBasePose).get()};
    std::vector<SinCos<double>> turn;
    std::vector<double> rate, height(rows.size());
    std::vector<SpatialMotion<double>> V(rows.size());
    std::vector<Vector3> up(rows.size());
    for (std::size_t r = 1; r < rows.size(); ++r) {
      const int j = static_cast<int>(r) - 1;
      X.push_back(childPose(X[static_cast<std::size_t>(rows[r].parent)], rows[r], q.get(j)));
      turn.push_back(sincos(q.get(j))), rate.push_back(dq.get(j));
    }
    V[0] = linked_->handle(robots_[i], kBaseVelocity).get();
    treeMotion(rows.data(), static_cast<int>(rows.size()),
               TreeMotion<double>{turn.data(), rate.data(), V.data(), up.data(), height.data()});
    Momentum m;
    const auto bodies = world_.members(robots_[i], subset::kBodies);
    Vector3 about_origin, first;
    for (std::size_t r = 0; r < rows.size(); ++r) {
      const RigidInertia<double> inertia = *world_.find(bodies[r], kBodyInertia);
      const SpatialForce<double> body = inertia * V[r];
      const Vector3 f = X[r].rotation * body.f;
      m.mass += inertia.m, m.linear += f;
      first += X[r].rotation * inertia.mc + X[r].translation * inertia.m;
      about_origin += X[r].rotation * body.n + cross(X[r].translation, f);
    }
    m.centre = first * (1 / m.mass);
    m.angular = about_origin - cross(m.centre, m.linear);
    return m;
  }
  /// Of the base's origin [m] and the joints [rad].
  std::vector<double> positions(std::size_t i) {
    const Vector3 p = linked_->handle(robots_[i], kBasePose).get().translation;
    std::vector<double> all{p.x, p.y, p.z};
    const auto q = linked_->handle(robots_[i], kJointPosition, subset::kJoints);
    for (int j = 0; j < q.size(); ++j) all.push_back(q.get(j));
    return all;
  }
  LinkedWorld& linked() { return *linked_; }
  const std::vector<ObjectId>& robots() const { return robots_; }

 private:
  double step_;
  World world_;
  ModuleRegistry registry_ = allModules();
  Diagnostics diagnostics_;
  std::vector<ObjectId> robots_;
  std::unique_ptr<LinkedWorld> linked_;
  long frame_ = 0;
};

TEST(MultibodyDynamics, CentreOfMassFliesAParabolaAndMomentumStaysWhileLimbsSwing) {
  constexpr double kTime = 0.2;
  FlyingRobots flight(1, "runge_kutta_4", 1e-4);
  flight.toss(0, 3);
  const auto before = flight.momentum(0);
  flight.run(kTime);
  const auto after = flight.momentum(0);
  const Vector3 expected =
      before.centre + before.linear * (kTime / before.mass) + Vector3{0, 0, -0.5 * 9.81 * kTime * kTime};
  EXPECT_LT(norm(after.centre - expected), 1e-10);
  const Vector3 fall{0, 0, -before.mass * 9.81 * kTime};
  EXPECT_LT(norm(after.linear - before.linear - fall), 1e-10 * norm(before.linear));
  EXPECT_LT(norm(after.angular - before.angular), 1e-10 * norm(before.angular));
}

/// Distance of base position and all joint positions from those of a much finer run.
double errorOf(const std::string& integrator, double step) {
  constexpr double kTime = 0.096;
  static const std::vector<double> reference = [] {
    FlyingRobots fine(1, "runge_kutta_4", 1e-4);
    fine.toss(0, 3);
    fine.run(kTime);
    return fine.positions(0);
  }();
  FlyingRobots flight(1, integrator, step);
  flight.toss(0, 3);
  flight.run(kTime);
  const std::vector<double> found = flight.positions(0);
  double sum = 0;
  for (std::size_t i = 0; i < found.size(); ++i) sum += (found[i] - reference[i]) * (found[i] - reference[i]);
  return std::sqrt(sum);
}

struct OrderOf {
  const char* integrator;
  int order;
  double step;  ///< larger one of two [s]
};
class Integrators : public testing::TestWithParam<OrderOf> {};

TEST_P(Integrators, ConvergeWithTheirOrder) {
  const OrderOf& p = GetParam();
  const double ratio = errorOf(p.integrator, p.step) / errorOf(p.integrator, p.step / 2);
  EXPECT_NEAR(std::log2(ratio), p.order, 0.15);
}

INSTANTIATE_TEST_SUITE_P(Orders, Integrators,
                         testing::Values(OrderOf{"explicit_euler", 1, 5e-4}, OrderOf{"semi_implicit_euler", 1, 5e-4},
                                         OrderOf{"implicit_euler", 1, 5e-4}, OrderOf{"midpoint", 2, 1e-3},
                                         OrderOf{"runge_kutta_4", 4, 2e-3}),
                         [](const auto& test) { return std::string(test.param.integrator); });

class InLanes : public testing::TestWithParam<const char*> {};

TEST_P(InLanes, EqualScalarBitForBit) {
  const std::string integrator = GetParam();
  FlyingRobots together(4, integrator, 1e-3, 4);
  for (unsigned i = 0; i < 4; ++i) together.toss(i, i);
  together.run(0.2);
  for (unsigned i = 0; i < 4; ++i) {
    FlyingRobots alone(1, integrator, 1e-3);
    alone.toss(0, i);
    alone.run(0.2);
    const Pose a = together.linked().handle(together.robots()[i], kBasePose).get();
    const Pose b = alone.linked().handle(alone.robots()[0], kBasePose).get();
    EXPECT_EQ(std::memcmp(&a, &b, sizeof(Pose)), 0) << i;
    const auto q = together.linked().handle(together.robots()[i], kJointPosition, subset::kJoints);
    const auto p = alone.linked().handle(alone.robots()[0], kJointPosition, subset::kJoints);
    for (int j = 0; j < q.size(); ++j) EXPECT_EQ(q.get(j), p.get(j)) << i << " " << j;
  }
}

INSTANTIATE_TEST_SUITE_P(MultibodyDynamics, InLanes, testing::Values("implicit_euler", "runge_kutta_4"),
                         [](const auto& test) { return std::string(test.param); });

}  // namespace
}  // namespace murosimf::motion
