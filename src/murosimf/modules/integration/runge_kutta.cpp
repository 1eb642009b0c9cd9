#include "murosimf/modules/integration/runge_kutta.h"

#include "murosimf/linking/links.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

namespace {

constexpr RungeKuttaCoefficients kEuler[] = {{1, 0}};
constexpr RungeKuttaCoefficients kMidpoint[] = {{0, 0.5}, {1, 0}};
constexpr RungeKuttaCoefficients kClassical[] = {{1.0 / 6, 0.5}, {1.0 / 3, 0.5}, {1.0 / 3, 1}, {1.0 / 6, 0}};

constexpr Variable<double> kQ0{"q_0", "rad", "at the beginning of the step", Storage::kStep};
constexpr Variable<double> kDq0{"dq_0", "rad/s", "at the beginning of the step", Storage::kStep};
constexpr Variable<Pose> kPose0{"base_pose_0", "m", "at the beginning of the step", Storage::kStep};
constexpr Variable<SpatialMotion<double>> kVelocity0{"base_velocity_0", "SI", "at the beginning of the step",
                                                     Storage::kStep};
constexpr Variable<double> kQSum{"q_sum", "rad/s", "weighted rates", Storage::kStep};
constexpr Variable<double> kDqSum{"dq_sum", "rad/s^2", "weighted rates", Storage::kStep};
constexpr Variable<BaseChange<double>> kChangeSum{"base_change_sum", "SI", "weighted rates", Storage::kStep};
constexpr Variable<SpatialMotion<double>> kVelocitySum{"base_velocity_sum", "SI", "weighted rates", Storage::kStep};
constexpr Variable<BaseChange<double>> kChange{"base_change", "SI", "since the beginning of the step", Storage::kStep};

}  // namespace

RungeKutta::RungeKutta(std::span<const RungeKuttaCoefficients> stages, const StepManner& manner)
    : manner_(kStepManner, manner) {
  for (const RungeKuttaCoefficients& c : stages) {
    RungeKuttaStage& stage = stages_.emplace_back();
    stage.weight = c.weight, stage.next = c.next;
  }
  stages_.front().first = stages_.back().last = true;
}

ExplicitEuler::ExplicitEuler() : RungeKutta(kEuler, {0, 0}) {}
Midpoint::Midpoint() : RungeKutta(kMidpoint, {0.5, 0.5}) {}
RungeKutta4::RungeKutta4() : RungeKutta(kClassical, {0.5, 0.5}) {}

void RungeKutta::declare(Declaration& d) const {
  manner_.declare(d);
  d.uses(kInitialPosition, 0.0, subset::kJoints);
  d.reads(kJointAcceleration, subset::kJoints);
  d.reads(kBodyAcceleration, subset::kBodies);
  d.reads(kBodyUp, subset::kBodies);
  for (const auto* variable : {&kJointPosition, &kJointVelocity, &kQ0, &kDq0, &kQSum, &kDqSum}) {
    d.adds(*variable, subset::kJoints);
  }
  for (const auto* variable : {&kBaseVelocity, &kVelocity0, &kVelocitySum}) d.adds(*variable);
  for (const auto* variable : {&kChangeSum, &kChange}) d.adds(*variable);
  for (const auto* variable : {&kBasePose, &kPose0}) d.adds(*variable);
}

void RungeKutta::link(Links& links) {
  manner_.link(links);
  for (RungeKuttaStage& stage : stages_) {
    stage.joints = links.count(subset::kJoints);
    stage.q = links.column(kJointPosition, subset::kJoints), stage.dq = links.column(kJointVelocity, subset::kJoints);
    stage.base_pose = links.column(kBasePose), stage.base_velocity = links.column(kBaseVelocity);
    stage.joint_acceleration = links.column(kJointAcceleration, subset::kJoints);
    stage.acceleration = links.column(kBodyAcceleration, subset::kBodies);
    stage.up = links.column(kBodyUp, subset::kBodies);
    stage.q_0 = links.column(kQ0, subset::kJoints), stage.dq_0 = links.column(kDq0, subset::kJoints);
    stage.base_pose_0 = links.column(kPose0), stage.base_velocity_0 = links.column(kVelocity0);
    stage.q_sum = links.column(kQSum, subset::kJoints), stage.dq_sum = links.column(kDqSum, subset::kJoints);
    stage.change_sum = links.column(kChangeSum), stage.velocity_sum = links.column(kVelocitySum);
    stage.change = links.column(kChange);
  }
  initial_ = links.column(kInitialPosition, subset::kJoints);
  width_ = links.width();
  advance_ = kernelOfWidth<RungeKuttaStage>(width_);
}

void RungeKutta::initialise(const BlockMemory& block) const {
  manner_.initialise(block);
  copyColumn(block, initial_, stages_.front().q, stages_.front().joints, width_);
}

void RungeKutta::step(const BlockMemory& block, const StepTime& time) const {
  for (const RungeKuttaStage& stage : stages_) {
    evaluate()(block, time);
    advance_(stage, block, time);
  }
}

}  // namespace murosimf
