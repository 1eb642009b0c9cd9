#pragma once

/// @file Kernels of dormand_prince.h: what is done to the states of all robots of a block between two evaluations.

#include "murosimf/linking/kernel.h"
#include "murosimf/modules/integration/base_chart.h"
#include "murosimf/modules/integration/stage_rates.h"
#include "murosimf/modules/integration/step_control.h"

namespace murosimf {

/// Event functions of one subset, and the sign that each had at the beginning of the step.
struct WatchedEvents {
  int count = 0;
  ColumnRef value, sign;
};

struct DormandPrinceArguments {
  int joints = 0;
  double tolerance = 0;
  ColumnRef q, dq, base_pose, base_velocity;          // the state of the moment
  ColumnRef joint_acceleration, acceleration, up;     // evaluated in it
  ColumnRef q_0, dq_0, base_pose_0, base_velocity_0;  // at the beginning of the step
  ColumnRef change;                                   // of the pose since the beginning
  ColumnRef joint_rates, base_rates;                  // k_1 ... k_7
  ColumnRef control;
  WatchedEvents events[2];
};

enum class DormandPrincePart {
  kBegin,        ///< a step: from the state of the moment where `moved`, else again from where the last one began
  kPlace,        ///< at a stage
  kKeep,         ///< the rates that have been evaluated at a stage
  kMeasure,      ///< the estimated error
  kPlaceOnPath,  ///< at theta, where `searching`
  kWatch,        ///< event functions there
};

struct DormandPrinceTask {
  DormandPrincePart part = DormandPrincePart::kBegin;
  int stage = 0;
  const DormandPrinceArguments* arguments = nullptr;
};

void addBaselineKernels(KernelSet<DormandPrinceTask>& kernels);
void addWideKernels(KernelSet<DormandPrinceTask>& kernels);

inline namespace MUROSIMF_ISA {

/// The columns of one block.
template <class S>
struct DormandPrinceBlock {
  S *q, *dq, *q_0, *dq_0;
  const S* ddq;
  Transform<S>*X, *X_0;
  SpatialMotion<S>*V, *V_0;
  BaseChange<S>* change;
  JointRates<S>* joint_rates;
  BaseRates<S>* base_rates;
  StepControl<S>* control;
  SpatialMotion<S> base_acceleration;  ///< rate of V

  DormandPrinceBlock(const DormandPrinceArguments& a, const BlockMemory& block)
      : q(columnAt<S, S>(block, a.q)),
        dq(columnAt<S, S>(block, a.dq)),
        q_0(columnAt<S, S>(block, a.q_0)),
        dq_0(columnAt<S, S>(block, a.dq_0)),
        ddq(columnAt<S, S>(block, a.joint_acceleration)),
        X(columnAt<Transform<S>, S>(block, a.base_pose)),
        X_0(columnAt<Transform<S>, S>(block, a.base_pose_0)),
        V(columnAt<SpatialMotion<S>, S>(block, a.base_velocity)),
        V_0(columnAt<SpatialMotion<S>, S>(block, a.base_velocity_0)),
        change(columnAt<BaseChange<S>, S>(block, a.change)),
        joint_rates(columnAt<JointRates<S>, S>(block, a.joint_rates)),
        base_rates(columnAt<BaseRates<S>, S>(block, a.base_rates)),
        control(columnAt<StepControl<S>, S>(block, a.control)),
        base_acceleration(trueAcceleration(*columnAt<SpatialMotion<S>, S>(block, a.acceleration),
                                           *columnAt<Vec3<S>, S>(block, a.up))) {}
};

/// The smallest event function, each with the sign that makes it positive at the beginning of the step.
template <class S>
inline S watchedEvent(const DormandPrinceArguments& a, const BlockMemory& block) {
  S smallest(1e300);
  for (const WatchedEvents& events : a.events) {
    if (events.count == 0) continue;
    const S *value = columnAt<S, S>(block, events.value), *sign = columnAt<S, S>(block, events.sign);
    for (int i = 0; i < events.count; ++i) smallest = min(sign[i] * value[i], smallest);
  }
  return smallest;
}

template <class S, class Truth>
inline void beginWatching(const DormandPrinceArguments& a, const BlockMemory& block, Truth moved) {
  for (const WatchedEvents& events : a.events) {
    if (events.count == 0) continue;
    const S* value = columnAt<S, S>(block, events.value);
    S* sign = columnAt<S, S>(block, events.sign);
    for (int i = 0; i < events.count; ++i) {
      sign[i] = select(moved, select(value[i] > S(0), S(1), S(-1)), sign[i]);
    }
  }
  auto& c = *columnAt<StepControl<S>, S>(block, a.control);
  c.watch_first = select(moved, watchedEvent<S>(a, block), c.watch_first);
}

/// Where between the last stage and this one an event function has changed its sign, if it is the first time.
template <class S>
inline void watchStage(const DormandPrinceArguments& a, const BlockMemory& block, int stage) {
  auto& c = *columnAt<StepControl<S>, S>(block, a.control);
  const S before = c.watch, now = watchedEvent<S>(a, block);
  const S first(kStageShare[stage - 1]), length(kStageShare[stage] - kStageShare[stage - 1]);
  const auto changed = (before >= S(0)) & (now < S(0)) & (c.crossing > S(1));
  const S share = fma(length, before / select(changed, before - now, S(1)), first);
  c.crossing = select(changed, share, c.crossing);
  c.watch = now;
}

template <class S>
inline void beginStep(const DormandPrinceArguments& a, const BlockMemory& block) {
  const DormandPrinceBlock<S> b(a, block);
  const auto moved = b.control->moved > S(0);
  for (int j = 0; j < a.joints; ++j) {
    JointRates<S>& rates = b.joint_rates[j];
    rates.q.k[0] = select(moved, b.dq[j], rates.q.k[0]);
    rates.dq.k[0] = select(moved, b.ddq[j], rates.dq.k[0]);
    b.q_0[j] = b.q[j] = select(moved, b.q[j], b.q_0[j]);
    b.dq_0[j] = b.dq[j] = select(moved, b.dq[j], b.dq_0[j]);
  }
  const Vec3<S> zero{S(0), S(0), S(0)};
  const BaseChange<S> rate = rateOf(BaseChange<S>{zero, zero}, b.X->rotation, *b.V);
  keepWhere(moved, b.base_rates->phi, rate.phi);
  keepWhere(moved, b.base_rates->p, rate.p);
  keepWhere(moved, b.base_rates->w, b.base_acceleration.w);
  keepWhere(moved, b.base_rates->v, b.base_acceleration.v);
  *b.X_0 = *b.X = select(moved, *b.X, *b.X_0);
  b.V_0->w = b.V->w = select(moved, b.V->w, b.V_0->w);
  b.V_0->v = b.V->v = select(moved, b.V->v, b.V_0->v);
  beginWatching<S>(a, block, moved);
}

template <class S>
inline void keepStage(const DormandPrinceArguments& a, const BlockMemory& block, int stage) {
  const DormandPrinceBlock<S> b(a, block);
  for (int j = 0; j < a.joints; ++j) {
    b.joint_rates[j].q.k[stage] = b.dq[j];
    b.joint_rates[j].dq.k[stage] = b.ddq[j];
  }
  const BaseChange<S> rate = rateOf(*b.change, b.X->rotation, *b.V);
  keep(b.base_rates->phi, stage, rate.phi);
  keep(b.base_rates->p, stage, rate.p);
  keep(b.base_rates->w, stage, b.base_acceleration.w);
  keep(b.base_rates->v, stage, b.base_acceleration.v);
  watchStage<S>(a, block, stage);
}

/// y_0 + h sum w_i k_i where `mask`. At the end of a step, and on its path, the rotation is made orthonormal again, so
/// that what is evaluated there is the state that stays.
template <class S, class Truth>
inline void place(const DormandPrinceArguments& a, const BlockMemory& block, Truth mask, const StageWeights<S>& w,
                  int stages, bool stays) {
  const DormandPrinceBlock<S> b(a, block);
  const S h = b.control->h;
  for (int j = 0; j < a.joints; ++j) {
    const JointRates<S>& rates = b.joint_rates[j];
    b.q[j] = select(mask, fma(h, weighted(rates.q, w, stages), b.q_0[j]), b.q[j]);
    b.dq[j] = select(mask, fma(h, weighted(rates.dq, w, stages), b.dq_0[j]), b.dq[j]);
  }
  const BaseRates<S>& rates = *b.base_rates;
  *b.change = {weighted(rates.phi, w, stages) * h, weighted(rates.p, w, stages) * h};
  Transform<S> X = changed(*b.X_0, *b.change);
  if (stays) X.rotation = orthonormalized(X.rotation);
  *b.X = select(mask, X, *b.X);
  b.V->w = select(mask, b.V_0->w + weighted(rates.w, w, stages) * h, b.V->w);
  b.V->v = select(mask, b.V_0->v + weighted(rates.v, w, stages) * h, b.V->v);
}

/// The largest error so far and one more coordinate's, which moved from y_0 to y; no number where one is none.
template <class S>
struct LargestError {
  S h, tolerance, largest{0}, poison{0};

  void add(const StageRates<S>& rates, S y_0, S y) {
    const S size = max(abs(y_0), abs(y));
    const S error = abs(h * weighted(rates, errorWeights<S>(), kDormandPrinceStages)) / fma(tolerance, size, tolerance);
    largest = max(error, largest);
    poison = fma(error, S(0), poison);
  }
  void add(const StageRates<S> (&rates)[3], const Vec3<S>& y_0, const Vec3<S>& y) {
    for (int i = 0; i < 3; ++i) add(rates[i], y_0[i], y[i]);
  }
};

template <class S>
inline void measure(const DormandPrinceArguments& a, const BlockMemory& block) {
  const DormandPrinceBlock<S> b(a, block);
  LargestError<S> error{b.control->h, S(a.tolerance)};
  for (int j = 0; j < a.joints; ++j) {
    error.add(b.joint_rates[j].q, b.q_0[j], b.q[j]);
    error.add(b.joint_rates[j].dq, b.dq_0[j], b.dq[j]);
  }
  const Vec3<S> zero{S(0), S(0), S(0)};
  error.add(b.base_rates->phi, zero, b.change->phi);
  error.add(b.base_rates->p, zero, b.change->p);
  error.add(b.base_rates->w, b.V_0->w, b.V->w);
  error.add(b.base_rates->v, b.V_0->v, b.V->v);
  b.control->error = error.largest + error.poison;
}

template <class S>
void dormandPrince(const DormandPrinceTask& task, const BlockMemory& block, const StepTime&) {
  const DormandPrinceArguments& a = *task.arguments;
  auto& c = *columnAt<StepControl<S>, S>(block, a.control);
  constexpr int kLast = kDormandPrinceStages - 1;
  switch (task.part) {
    case DormandPrincePart::kBegin:
      return beginStep<S>(a, block);
    case DormandPrincePart::kPlace:
      return place(a, block, c.active > S(0), stageWeights<S>(task.stage), task.stage, task.stage == kLast);
    case DormandPrincePart::kKeep:
      return keepStage<S>(a, block, task.stage);
    case DormandPrincePart::kMeasure:
      return measure<S>(a, block);
    case DormandPrincePart::kPlaceOnPath:
      return place(a, block, c.searching > S(0), pathWeights(c.theta), kDormandPrinceStages, true);
    case DormandPrincePart::kWatch:
      c.watch = watchedEvent<S>(a, block);
  }
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
