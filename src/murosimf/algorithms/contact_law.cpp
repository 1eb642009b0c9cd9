#include "murosimf/algorithms/contact_law.h"

namespace murosimf {
namespace {

/// Value and slope of a law's factor.
struct Factor {
  double value, slope;
};

Factor factorWithSlope(const SurfacePair& pair, double u) {
  if (pair.normal_law == NormalLaw::kHuntCrossley) {
    const double value = 1 - pair.dissipation * u;
    return value > 0 ? Factor{value, -pair.dissipation} : Factor{0, 0};
  }
  if (pair.normal_law == NormalLaw::kPaper) return {u < 0 ? 1.0 : pair.restitution_factor, 0};
  const double mean = 0.5 * (1 + pair.restitution_factor), half = 0.5 * (1 - pair.restitution_factor);
  if (abs(u) > 20 * pair.blend_speed) return {u < 0 ? 1.0 : pair.restitution_factor, 0};  // tanh is 1 to the last bit
  const double t = tanh(u / pair.blend_speed);
  return {mean - half * t, -half * (1 - t * t) / pair.blend_speed};
}

/// Root e of ln((1 + a)/(1 - a e)) - a (1 + e), which is negative at 0 and rises in [0, 1/a).
double huntCrossleyRestitution(double a) {
  double low = 0, high = 1;
  for (int i = 0; i < 60; ++i) {
    const double e = 0.5 * (low + high);
    const bool too_large = a * e >= 1 || log((1 + a) / (1 - a * e)) > a * (1 + e);
    (too_large ? high : low) = e;
  }
  return 0.5 * (low + high);
}

/// The midpoint rule of one contact as a function of its impulse: zero of p - h f(x_m(p), u_m(p)).
struct MidpointStep {
  const NormalStep& step;
  const SurfacePair& pair;
  double theta;
  double speed(double p) const {
    return (1 - theta) * step.start_speed + theta * fma(step.response, p, step.end_speed);
  }
  double depth(double mean_speed) const { return fnma(theta * step.dt, mean_speed, step.depth); }
  double impulse(double p) const {
    const double u = speed(p), x = depth(u);
    return x > 0 ? step.dt * step.stiffness * x * factorWithSlope(pair, u).value : 0.0;
  }
  /// p - impulse(p) and its slope, which is at least 1.
  Factor residual(double p) const {
    const double u = speed(p), x = depth(u);
    if (x <= 0) return {p, 1};
    const Factor factor = factorWithSlope(pair, u);
    const double stiffness = step.dt * step.stiffness;
    const double by_speed = stiffness * (x * factor.slope - theta * step.dt * factor.value);
    return {p - stiffness * x * factor.value, fnma(by_speed, theta * step.response, 1.0)};
  }
};

/// Newton's method between two bounds; halves them where a step leaves them or does not halve the step before last.
double solveByNewton(const MidpointStep& law) {
  double low = 0, high = law.impulse(0);
  if (high <= 0) return 0;
  const double tolerance = 1e-13 * high;
  double p = law.step.guess <= high ? law.step.guess : 0.0, last_step = high, step_before = high;
  for (int i = 0; i < 100; ++i) {
    const Factor residual = law.residual(p);
    if (abs(residual.value) <= tolerance) break;  // its slope is at least 1
    (residual.value > 0 ? high : low) = p;
    double next = p - residual.value / residual.slope;
    const bool converges = next >= low && next <= high && abs(next - p) <= 0.5 * step_before;
    if (!converges) next = 0.5 * (low + high);
    step_before = last_step;
    last_step = abs(next - p);
    p = next;
    if (last_step <= 1e-15 * p) break;
  }
  return p;
}

/// `paper` with its factor frozen: linear in p.
double solveFrozen(const MidpointStep& law, const NormalStep& step, const SurfacePair& pair) {
  const double stiffness = step.dt * step.stiffness * (step.start_speed < 0 ? 1.0 : pair.restitution_factor);
  const double x = law.depth(law.speed(0));
  return max(0.0, stiffness * x / fma(stiffness * law.theta * law.theta, step.dt * step.response, 1.0));
}

/// `hunt_crossley`: p = h k x (1 - d u) with x and u linear in p, hence a quadratic; the root from which p rises as the
/// force does.
double solveQuadratic(const MidpointStep& law, const NormalStep& step, const SurfacePair& pair) {
  const double u = law.speed(0), x = law.depth(u);  // without p
  if (x <= 0) return 0;
  const double by_u = law.theta * step.response, by_x = -law.theta * step.dt * by_u;  // per p
  const double spring = step.dt * step.stiffness, factor = fnma(pair.dissipation, u, 1.0);
  if (factor <= 0) return 0;
  // a p^2 - b p + c = 0 with a >= 0, b >= 1, c > 0: the smaller root, without cancellation.
  const double a = -spring * by_x * pair.dissipation * by_u;
  const double b = 1 - spring * (by_x * factor - x * pair.dissipation * by_u);
  const double c = spring * x * factor;
  return 2 * c / (b + sqrt(max(0.0, fnma(4 * a, c, b * b))));
}

}  // namespace

double normalFactor(const SurfacePair& pair, double separating_speed) {
  return factorWithSlope(pair, separating_speed).value;
}

double restitution(const SurfacePair& pair, double approach_speed) {
  if (pair.normal_law != NormalLaw::kHuntCrossley) return sqrt(pair.restitution_factor);
  const double a = pair.dissipation * approach_speed;
  return a < 1e-4 ? 1 - 2.0 / 3.0 * a : huntCrossleyRestitution(a);
}

double midpointWeight(double stiffness, double response, double dt) {
  const double phase = dt * sqrt(stiffness * response);
  return phase <= 1 ? 0.5 : 1 - 0.5 / phase;
}

double normalImpulse(const NormalStep& step, const SurfacePair& pair) {
  const MidpointStep law{step, pair, midpointWeight(step.stiffness, step.response, step.dt)};
  if (pair.normal_law == NormalLaw::kPaper) return solveFrozen(law, step, pair);
  return pair.normal_law == NormalLaw::kHuntCrossley ? solveQuadratic(law, step, pair) : solveByNewton(law);
}

double lateImpulse(const NormalStep& step, const SurfacePair& pair) {
  const double speed = -step.start_speed, x = min(step.depth, step.dt * speed);
  if (x <= 0) return 0;
  const double spring = step.stiffness * factorWithSlope(pair, step.start_speed).value;
  return (speed - sqrt(max(0.0, fnma(step.response * spring * x, x, speed * speed)))) / step.response;
}

Vector3 resistanceImpulse(const Vector3& u, double response, const Resistance& resistance) {
  const double square = squaredNorm(u);
  if (square <= 0 || (resistance.constant <= 0 && resistance.viscous <= 0)) return {};
  const double slope = resistance.constant / resistance.threshold + resistance.viscous;
  const double slowed = fma(response, slope, 1.0), fastest = resistance.threshold * slowed;
  if (square <= fastest * fastest) return u * (-slope / slowed);
  const double speed = sqrt(square);
  const double impulse = fma(resistance.viscous, speed, resistance.constant) / fma(response, resistance.viscous, 1.0);
  return u * (-impulse / speed);
}

Resistance tangentialResistance(const SurfacePair& pair, double normal_impulse) {
  if (pair.friction_law == FrictionLaw::kViscous) return {0, pair.stick_speed, pair.viscous_friction * normal_impulse};
  return {pair.friction * normal_impulse, pair.stick_speed, 0};
}

Resistance turningResistance(const SurfacePair& pair, double normal_impulse, double radius) {
  return {pair.rolling_resistance * radius * normal_impulse, pair.stick_speed / radius,
          pair.turning_friction * normal_impulse};
}

double pushingForceLimit(double pusher_mass, double ball_mass, double ball_radius, double approach_speed) {
  constexpr double kStandardGravity = 9.80665;
  const double weight = max(0.5 * pusher_mass, 2 * ball_mass) * kStandardGravity;
  return max(weight, 1.2 * ball_mass * approach_speed * approach_speed / ball_radius);
}

double limitedImpulse(double impulse, const NormalStep& step, double force_limit, double speed_limit) {
  const double by_speed = max(0.0, (speed_limit - step.end_speed) / step.response);
  return min(impulse, min(step.dt * force_limit, by_speed));
}

}  // namespace murosimf
