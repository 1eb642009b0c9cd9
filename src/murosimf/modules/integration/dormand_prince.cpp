#include "murosimf/modules/integration/dormand_prince.h"

#include "murosimf/linking/links.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

namespace {

constexpr Variable<double> kQ0{"q_0", "rad", "at the beginning of the step", Storage::kStep};
constexpr Variable<double> kDq0{"dq_0", "rad/s", "at the beginning of the step", Storage::kStep};
constexpr Variable<Pose> kPose0{"base_pose_0", "m", "at the beginning of the step", Storage::kStep};
constexpr Variable<SpatialMotion<double>> kVelocity0{"base_velocity_0", "SI", "at the beginning of the step",
                                                     Storage::kStep};
constexpr Variable<BaseChange<double>> kChange{"base_change", "SI", "since the beginning of the step", Storage::kStep};
constexpr Variable<JointRates<double>> kJointRates{"joint_rates", "SI", "at the stages of a step", Storage::kStep};
constexpr Variable<BaseRates<double>> kBaseRates{"base_rates", "SI", "at the stages of a step", Storage::kStep};
constexpr Variable<StepControl<double>> kStepControl{"step_control", "SI", "length and fate of the step",
                                                     Storage::kStep};
constexpr Variable<double> kEventSign{"event_sign", "1", "of the event function at the beginning of the step",
                                      Storage::kStep};

WatchedEvents watched(const Links& links, std::string_view of) {
  if (!links.has(kEventFunction, of)) return {};
  return {links.count(of), links.column(kEventFunction, of), links.column(kEventSign, of)};
}

}  // namespace

std::vector<ParameterInfo> DormandPrince::parameters() {
  return {{"tolerance", "1", "largest error of a step: m, rad and their rates, relative beyond 1", 1e-6, 1e-14, 1},
          {"least_step", "s", "a step of this length counts whatever its error", 1e-12, 1e-15, 1e-3},
          {"most_rounds", "1", "steps tried in a frame, before the robot stops as faulty", 1000, 1, 1e6},
          {"locate_events", "1", "1: steps end where forces jump; 0: the error alone sees that they do", 1, 0, 1},
          {"event_distance", "s", "what jumps sooner again is left to the error", 1e-5, 0, 1}};
}

DormandPrince::DormandPrince(const ParameterValues& values)
    : limits_{values["tolerance"], values["least_step"], values["most_rounds"], values["event_distance"],
              values["locate_events"] != 0} {
  arguments_.tolerance = limits_.tolerance;
}

void DormandPrince::declare(Declaration& d) const {
  manner_.declare(d);
  d.uses(kInitialPosition, 0.0, subset::kJoints);
  d.reads(kJointAcceleration, subset::kJoints);
  d.reads(kBodyAcceleration, subset::kBodies);
  d.reads(kBodyUp, subset::kBodies);
  for (const std::string_view of : {subset::kJoints, subset::kBodies}) {
    d.readsIfAdded(kEventFunction, of);
    d.adds(kEventSign, of);
  }
  for (const auto* variable : {&kJointPosition, &kJointVelocity, &kQ0, &kDq0}) d.adds(*variable, subset::kJoints);
  d.adds(kJointRates, subset::kJoints);
  for (const auto* variable : {&kBaseVelocity, &kVelocity0}) d.adds(*variable);
  for (const auto* variable : {&kBasePose, &kPose0}) d.adds(*variable);
  d.adds(kChange);
  d.adds(kBaseRates);
  d.adds(kStepControl);
  for (const auto* variable : {&kIntegrationStep, &kIntegrationError, &kSubsteps, &kForceEvaluations, &kEventCount,
                               &kEventTime, &kIntegrationFault}) {
    d.adds(*variable);
  }
}

void DormandPrince::link(Links& links) {
  manner_.link(links);
  DormandPrinceArguments& a = arguments_;
  a.joints = links.count(subset::kJoints);
  a.q = links.column(kJointPosition, subset::kJoints), a.dq = links.column(kJointVelocity, subset::kJoints);
  a.base_pose = links.column(kBasePose), a.base_velocity = links.column(kBaseVelocity);
  a.joint_acceleration = links.column(kJointAcceleration, subset::kJoints);
  a.acceleration = links.column(kBodyAcceleration, subset::kBodies);
  a.up = links.column(kBodyUp, subset::kBodies);
  a.q_0 = links.column(kQ0, subset::kJoints), a.dq_0 = links.column(kDq0, subset::kJoints);
  a.base_pose_0 = links.column(kPose0), a.base_velocity_0 = links.column(kVelocity0);
  a.change = links.column(kChange);
  a.joint_rates = links.column(kJointRates, subset::kJoints), a.base_rates = links.column(kBaseRates);
  a.control = links.column(kStepControl);
  a.events[0] = watched(links, subset::kJoints), a.events[1] = watched(links, subset::kBodies);
  initial_ = links.column(kInitialPosition, subset::kJoints);
  control_ = links.values(kStepControl);
  step_ = links.values(kIntegrationStep), fault_ = links.values(kIntegrationFault);
  error_ = links.values(kIntegrationError), substeps_ = links.values(kSubsteps);
  evaluations_ = links.values(kForceEvaluations);
  events_ = links.values(kEventCount), event_time_ = links.values(kEventTime);
  width_ = links.width();
  kernel_ = kernelOfWidth<DormandPrinceTask>(width_);
}

void DormandPrince::initialise(const BlockMemory& block) const {
  manner_.initialise(block);
  copyColumn(block, initial_, arguments_.q, arguments_.joints, width_);
  for (int lane = 0; lane < width_; ++lane) RobotLane(block, width_, lane).set(event_time_, -1.0);
}

void DormandPrince::run(const BlockMemory& block, DormandPrincePart part, int stage) const {
  kernel_({part, stage, &arguments_}, block, {});
}

template <class Decide>
bool DormandPrince::decide(const BlockMemory& block, Decide&& decision) const {
  bool any_of_them = false;
  for (int lane = 0; lane < width_; ++lane) {
    const RobotLane robot(block, width_, lane);
    Control control = robot.get(control_);
    if (decision(control)) any_of_them = true;
    robot.set(control_, control);
  }
  return any_of_them;
}

void DormandPrince::step(const BlockMemory& block, const StepTime& time) const {
  for (int lane = 0; lane < width_; ++lane) {
    const RobotLane robot(block, width_, lane);
    Control control;
    beginFrame(control, robot.get(step_), robot.get(event_time_) - time.t, time.dt);
    robot.set(control_, control);
  }
  evaluate()(block, time);
  run(block, DormandPrincePart::kBegin);
  while (decide(block, [&](Control& c) { return planStep(c, limits_, time.dt); })) {
    tryStep(block, time);
    if (decide(block, [&](Control& c) { return judgeStep(c, limits_, time.dt); })) locateEvents(block, time);
    run(block, DormandPrincePart::kBegin);
  }
  report(block, time);
}

void DormandPrince::tryStep(const BlockMemory& block, const StepTime& time) const {
  for (int stage = 1; stage < kDormandPrinceStages; ++stage) {
    run(block, DormandPrincePart::kPlace, stage);
    evaluate()(block, time);
    run(block, DormandPrincePart::kKeep, stage);
  }
  run(block, DormandPrincePart::kMeasure);
}

void DormandPrince::locateEvents(const BlockMemory& block, const StepTime& time) const {
  do {
    run(block, DormandPrincePart::kPlaceOnPath);
    evaluate()(block, time);
    run(block, DormandPrincePart::kWatch);
  } while (decide(block, searchEvent));
  run(block, DormandPrincePart::kPlaceOnPath);
  evaluate()(block, time);
  decide(block, [&](Control& c) { return endSearch(c, time.dt), false; });
}

void DormandPrince::report(const BlockMemory& block, const StepTime& time) const {
  for (int lane = 0; lane < width_; ++lane) {
    const RobotLane robot(block, width_, lane);
    const Control c = robot.get(control_);
    robot.set(step_, c.step);
    robot.set(error_, c.error_sum * limits_.tolerance);
    robot.set(substeps_, c.substeps);
    robot.set(evaluations_, c.evaluations);
    robot.set(events_, c.events);
    if (c.events > 0) robot.set(event_time_, time.t + c.last_event);
    robot.set(fault_, c.fault);
  }
}

}  // namespace murosimf
