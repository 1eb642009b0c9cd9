#include "murosimf/modules/integration/step_control.h"

#include "murosimf/math/elementary.h"

namespace murosimf {

namespace {

constexpr double kSafety = 0.9, kMostShrinking = 0.2, kMostGrowth = 5, kShrinkingOfNoNumber = 0.1;
constexpr double kLanding = 0.95;      ///< share of the way to an event at which a step ends before it
constexpr double kFarthest = 1.2;      ///< share of a step to which its path is followed
constexpr double kEventWidth = 1e-12;  ///< how exactly events are found [s]
constexpr double kMostTries = 60;      ///< places at which an event is looked for
constexpr double kNever = 2;

bool isFinite(double x) { return x - x == 0; }

/// 0.9 err^(-1/5) within its limits.
double stepFactor(double error, double most) {
  constexpr double kSmallest = 1e-10;  // below it every factor is the largest
  return clamp(kSafety * exp(-0.2 * log(max(error, kSmallest))), kMostShrinking, most);
}

void reject(StepControl<>& c, const StepLimits& limits, double factor) {
  if (!isFinite(c.error) && c.h <= limits.least_step) c.fault = 1;
  c.step = max(c.h * factor, limits.least_step);
  c.rejected = 1;
  c.approach = 0;
}

/// The length that follows a step that counted. One that was shortened by the frame's end or an event says nothing of
/// how much longer it could have been.
void learnLength(StepControl<>& c, const StepLimits& limits, double dt) {
  const double most = c.rejected > 0 ? 1 : kMostGrowth, factor = stepFactor(c.error, most);
  const double length = c.h * factor;
  c.step = max(factor < most ? length : max(c.step, length), limits.least_step);
  c.step = min(c.step, dt);
  c.rejected = 0;
}

void arrive(StepControl<>& c, double share, bool at_end, double dt) { c.time = at_end ? dt : fma(share, c.h, c.time); }

/// How far beyond the step's end its path may be followed: not beyond the frame's.
double farthest(const StepControl<>& c, double dt) { return min(kFarthest, (dt - c.time) / c.h); }

bool isWorthLocating(const StepControl<>& c, const StepLimits& limits) {
  const double way = c.crossing * c.h;
  return limits.locates_events && c.crossing <= 1 && way > kEventWidth &&
         c.time + way - c.last_event >= limits.event_distance;
}

void startSearch(StepControl<>& c, double most) {
  c.searching = c.open = 1;
  c.low = 1, c.watch_low = c.watch;
  c.high = c.theta = most;
  c.side = c.tries = 0;
}

/// The event is farther away, or not in this frame.
bool endAtStep(StepControl<>& c) {
  c.open = 0;
  c.theta = 1;
  return false;
}

/// An end that stays a second time counts half, so that both ends come to the root.
void narrow(StepControl<>& c, bool changed) {
  if (changed) {
    c.high = c.theta, c.watch_high = c.watch;
    if (c.side > 0) c.watch_low *= 0.5;
  } else {
    c.low = c.theta, c.watch_low = c.watch;
    if (c.side < 0) c.watch_high *= 0.5;
  }
  c.side = changed ? 1 : -1;
}

}  // namespace

void beginFrame(StepControl<>& c, double step, double last_event, double dt) {
  c = {};
  c.moved = 1;
  c.evaluations = 1;
  c.step = step > 0 ? min(step, dt) : dt;
  c.crossing = kNever;
  c.last_event = last_event;
}

bool planStep(StepControl<>& c, const StepLimits& limits, double dt) {
  c.moved = c.searching = 0;
  if (c.time < dt && c.rounds >= limits.most_rounds) c.fault = 1;
  c.active = c.time < dt && !(c.fault > 0) ? 1 : 0;
  if (!(c.active > 0)) return false;
  ++c.rounds;
  const double left = dt - c.time, steps = __builtin_ceil(left / c.step);
  c.h = c.approach > 0 ? c.approach : left / steps;
  c.ends_frame = !(c.approach > 0) && steps <= 1 ? 1 : 0;
  c.crossing = kNever;
  c.watch = c.watch_first;
  return true;
}

bool judgeStep(StepControl<>& c, const StepLimits& limits, double dt) {
  if (!(c.active > 0)) return false;
  c.evaluations += 6;
  if (isWorthLocating(c, limits)) {
    c.approach = kLanding * c.crossing * c.h;
    return false;
  }
  const bool shortest = c.h <= limits.least_step;
  if (!isFinite(c.error) || (c.error > 1 && !shortest)) {
    reject(c, limits, isFinite(c.error) ? stepFactor(c.error, 1) : kShrinkingOfNoNumber);
    return false;
  }
  learnLength(c, limits, dt);
  c.moved = 1;
  ++c.substeps;
  c.error_sum += c.error;
  const bool near_event = c.approach > 0;
  c.approach = 0;
  const double most = farthest(c, dt);
  if (near_event && most > 1) {
    startSearch(c, most);
  } else {
    arrive(c, 1, c.ends_frame > 0, dt);
  }
  return c.searching > 0;
}

bool searchEvent(StepControl<>& c) {
  if (!(c.open > 0)) return false;
  ++c.evaluations;
  const bool changed = c.watch < 0;
  if (c.tries == 0) {
    c.watch_high = c.watch;
    if (!changed) return endAtStep(c);
  } else {
    narrow(c, changed);
  }
  ++c.tries;
  const double width = kEventWidth / c.h;
  if (!(c.high - c.low > width) || c.tries >= kMostTries) {
    c.open = 0;
    c.theta = c.high;
    return false;
  }
  const double root = fma(c.high - c.low, c.watch_low / (c.watch_low - c.watch_high), c.low);
  c.theta = clamp(root, c.low + 0.5 * width, c.high - 0.5 * width);
  return true;
}

void endSearch(StepControl<>& c, double dt) {
  if (!(c.searching > 0)) return;
  ++c.evaluations;
  const double most = farthest(c, dt);
  arrive(c, c.theta, c.theta == most && most < kFarthest, dt);
  if (!(c.theta > 1)) return;
  ++c.events;
  c.last_event = c.time;
}

}  // namespace murosimf
