#pragma once

/// @file Impulses of one contact over one step, everything else held fixed.
///
/// h step [s]; n from B to A; x depth [m]; u separating speed [m/s]; W change of u per impulse [1/kg], of both bodies.
/// Normal: the midpoint rule, which neither loses nor gains restitution (an implicit Euler step loses it, a force held
/// over the step gains):
///     u_m = (1 - theta) u_0 + theta (u + W p),   x_m = x - theta h u_m,   p = h f(x_m, u_m),   p >= 0
/// u_0 at the step's start, u at its end without p. theta = 1/2 while w h = h sqrt(s_c W) <= 1, then 1 - 1/(2 w h), so
/// that a step too long for the contact damps it. f falls with u and rises with x: there is one root.
/// Friction: the exact solution of the implicit step, so no step is too long for it.
/// An impulse found here never adds energy in its own direction, beyond the O((w h)^2) of the midpoint rule.

#include "murosimf/algorithms/surface_pair.h"
#include "murosimf/math/vec3.h"

namespace murosimf {

/// f / (s_c x) of the smooth laws at separating speed u.
double normalFactor(const SurfacePair& pair, double separating_speed);
/// e: separating speed over approach speed of an impact without gravity. Closed form for `smooth` and `paper`; root of
/// d v (1 + e) = ln((1 + d v)/(1 - d e v)) for `hunt_crossley`, which depends on the speed v.
double restitution(const SurfacePair& pair, double approach_speed);

struct NormalStep {
  double depth = 0;        ///< x at the start [m]
  double start_speed = 0;  ///< u_0 [m/s]
  double end_speed = 0;    ///< u [m/s]: with every other impulse, without this one
  double response = 0;     ///< W [1/kg], > 0
  double dt = 0;           ///< h [s]
  double stiffness = 0;    ///< s_c, or s_c/n for each of n points of a manifold [N/m]
  double guess = 0;        ///< of p, >= 0: where the search begins
};

double midpointWeight(double stiffness, double response, double dt);
/// Normal impulse p >= 0 [N s]. `paper` freezes its factor at the step's start, which makes the step linear.
double normalImpulse(const NormalStep& step, const SurfacePair& pair);

/// What a point should have got already that is found x deep when a frame begins and came there within the last one at
/// the speed u < 0: p = (|u| - sqrt(u^2 - W s_c g(u) x^2)) / W, so that its spring holds no energy that nobody gave.
/// x counts up to h |u|, and the impulse takes no more than the approach.
double lateImpulse(const NormalStep& step, const SurfacePair& pair);

/// Resistance to a motion of size s, along it: c min(1, s/s_0) + b s.
struct Resistance {
  double constant = 0;      ///< c: size of the impulse above s_0
  double threshold = 1e-3;  ///< s_0 > 0
  double viscous = 0;       ///< b: impulse per speed
};
/// The impulse against a motion u (velocity or angular velocity without this impulse), W = change of u per impulse.
Vector3 resistanceImpulse(const Vector3& u, double response, const Resistance& resistance);
/// Tangential impulse belonging to a normal impulse p_n.
Resistance tangentialResistance(const SurfacePair& pair, double normal_impulse);
/// Turning impulse [N m s] of a sphere of radius r.
Resistance turningResistance(const SurfacePair& pair, double normal_impulse, double radius);

/// Limits of what a body with prescribed motion gives. Its mass is infinite to the contact, its motors are not:
///     p <= min(h F_cap, (limit - u)/W),   F_cap = max(m g / 2, 2 m_b g, 1.2 m_b v_in^2 / r),   limit = e v_in
/// m mass of the pusher's robot, m_b and r of the ball, v_in the largest approach speed since the contact began. The
/// second term carries a robot that fell on the pusher; the third stops a ball within r/2.4 of a stiff surface (0.7 r
/// of one of 3 kN/m), whatever the kick; the limit lets no squeezed ball be shot out.
double pushingForceLimit(double pusher_mass, double ball_mass, double ball_radius, double approach_speed);
/// min(p, h f, max(0, (limit - u)/W)).
double limitedImpulse(double impulse, const NormalStep& step, double force_limit, double speed_limit);

}  // namespace murosimf
