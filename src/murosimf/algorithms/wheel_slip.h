#pragma once

/// @file Friction of wheels in the ground plane: how a body on wheels moves when they turn at given rates.
///
/// A wheel of radius r that turns at w drives its contact point, at p from the centre of mass, with the slip
///     s = v + omega x p - r w d
/// over the ground, d the way that it drives. A tyre resists all of it, rollers what lies along their axle g:
///     f = -mu N s / max(|s|, s_0)          s_0 = stick speed + creepage r |w|
///     f = -mu N g (g.s) / max(|g.s|, s_0)  of a wheel with rollers
/// so the force grows with the slip up to mu N and no further: dry friction, of which a wheel at rest uses up all at
/// the stick speed and a rolling one at a slip that is in proportion to how fast it rolls, as tyres do [Pacejka
/// 2012, 1.2]. Over a step h the velocity at its end solves
///     (M / h + sum c J^T J) u = (M u_0 / h + F) + sum c J^T r w d,     c = mu N / max(|s(u)|, s_0)
/// u = (v of the centre of mass; omega) in the body's axes at the step's end. c is found again kRounds times from the
/// velocity that it gave; where wheels slide each round leaves about mu g h / |s| of the error.

#include "murosimf/math/pack.h"

namespace murosimf {

/// A wheel in the ground plane below a body, in plain numbers: place on the base, the way that it drives and the axle
/// of its rollers, both of length 1.
struct PlanarWheel {
  double x = 0, y = 0, drive_x = 1, drive_y = 0, roller_x = 1, roller_y = 0;
  double radius = 0;  ///< [m]; 0 of castors
  bool rollers = false;
  int joint = -1;  ///< that turns it; -1: a castor
};

inline namespace MUROSIMF_ISA {

/// Velocity of the centre of mass, and turning rate.
template <class S = double>
struct PlanarMotion {
  S x{}, y{}, turn{};
};

/// The part of a body's inertia that counts in the plane, centre of mass on the base.
template <class S = double>
struct PlanarBody {
  S mass{}, inertia{}, centre_x{}, centre_y{};
};

/// One wheel at work.
template <class S>
struct WheelGrip {
  S x, y;       ///< from the centre of mass
  S rolling;    ///< r w
  S largest;    ///< mu N
  S free_slip;  ///< s_0 > 0
};

template <class S>
struct Slip {
  S x, y;
};

template <class S>
inline Slip<S> slipOf(const PlanarWheel& wheel, const WheelGrip<S>& grip, const PlanarMotion<S>& u) {
  return {fnma(u.turn, grip.y, u.x) - grip.rolling * S(wheel.drive_x),
          fma(u.turn, grip.x, u.y) - grip.rolling * S(wheel.drive_y)};
}

/// A u = b, A symmetric.
template <class S>
struct PlanarSystem {
  S xx, yy, tt, xy, xt, yt, bx, by, bt;

  /// A force -c (s . g) along g at the wheel.
  void addGrip(const PlanarWheel& wheel, const WheelGrip<S>& grip, S gx, S gy, S c) {
    const S arm = fma(grip.x, gy, -(grip.y * gx));
    const S driven = c * grip.rolling * fma(S(wheel.drive_x), gx, S(wheel.drive_y) * gy);
    xx = fma(c * gx, gx, xx), yy = fma(c * gy, gy, yy), tt = fma(c * arm, arm, tt);
    xy = fma(c * gx, gy, xy), xt = fma(c * gx, arm, xt), yt = fma(c * gy, arm, yt);
    bx = fma(driven, gx, bx), by = fma(driven, gy, by), bt = fma(driven, arm, bt);
  }

  PlanarMotion<S> solved() const {
    const S one(1), lx = xy / xx, mx = xt / xx;
    const S d2 = fnma(lx, xy, yy), e = fnma(lx, xt, yt), ly = e / d2;
    const S d3 = fnma(ly, e, fnma(mx, xt, tt));
    const S c2 = fnma(lx, bx, by), c3 = fnma(ly, c2, fnma(mx, bx, bt));
    const S turn = c3 * (one / d3), y = fnma(ly, turn, c2 / d2);
    return {fnma(mx, turn, fnma(lx, y, bx / xx)), y, turn};
  }
};

/// @param start  velocity at the step's beginning, in the axes of its end
/// @param pushes momentum and turning momentum that forces from outside add in the step
/// @param gripOf gripOf(i) of wheel i
template <class S, class GripOf>
inline PlanarMotion<S> planarVelocity(const PlanarWheel* wheels, int count, const PlanarBody<S>& body,
                                      const PlanarMotion<S>& start, const PlanarMotion<S>& pushes, S per_step,
                                      GripOf&& gripOf) {
  constexpr int kRounds = 6;
  const S zero(0), mass = body.mass * per_step, inertia = body.inertia * per_step;
  PlanarMotion<S> u = start;
  for (int round = 0; round < kRounds; ++round) {
    PlanarSystem<S> system{mass,
                           mass,
                           inertia,
                           zero,
                           zero,
                           zero,
                           fma(mass, start.x, pushes.x * per_step),
                           fma(mass, start.y, pushes.y * per_step),
                           fma(inertia, start.turn, pushes.turn * per_step)};
    for (int i = 0; i < count; ++i) {
      const PlanarWheel& wheel = wheels[i];
      const WheelGrip<S> grip = gripOf(i);
      const Slip<S> s = slipOf(wheel, grip, u);
      if (wheel.rollers) {
        const S gx(wheel.roller_x), gy(wheel.roller_y), along = fma(s.x, gx, s.y * gy);
        system.addGrip(wheel, grip, gx, gy, grip.largest / max(abs(along), grip.free_slip));
      } else {
        const S c = grip.largest / max(sqrt(fma(s.x, s.x, s.y * s.y)), grip.free_slip);
        system.addGrip(wheel, grip, S(1), zero, c);
        system.addGrip(wheel, grip, zero, S(1), c);
      }
    }
    u = system.solved();
  }
  return u;
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
