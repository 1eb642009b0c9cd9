#pragma once

/// @file The ground under wheels: one point that grips along the wheel and across it, or along the axle of a roller.
///
/// Point      the lowest of the rim, in the wheel's middle plane: r = c - R (up less its part along the axle a),
///            normalised; of a castor, a ball, r = c - R up. It carries the whole stiffness of the pair.
/// Grip       As in wheel_slip.h: with slip s = tangential velocity of the wheel's own material at r, turning included,
///                f_t = -c P s,   c = mu f_n / max(|P s|, s_0),   s_0 = stick speed + creepage R |w.a|
///            P = 1 on the ground of tyres and castors, g g^T of wheels with rollers, g the axle of the lowest roller,
///            turned from d = a x up by the wheel's roller_angle about up. Across it rollers turn without resistance.
/// Look ahead As in ground_contact.h: K = k_n up up^T + h c P.
/// Cost       about 150 operations a wheel that touches.

#include "murosimf/algorithms/ground_contact.h"

namespace murosimf {
inline namespace MUROSIMF_ISA {

/// What the ground does to a wheel, besides its load.
template <class S>
struct WheelFriction {
  S coefficient, stick_speed, creepage;
};

template <class S>
MUROSIMF_INLINE Vec3<S> unitOr(const Vec3<S>& v, const Vec3<S>& otherwise) {
  constexpr double kShortest = 1e-6;
  const S length = norm(v);
  const auto known = length > S(kShortest);
  return select(known, v * (S(1) / select(known, length, S(1))), otherwise);
}

/// M += k u u^T at r, u of length 1.
template <class S>
MUROSIMF_INLINE void addMassAlong(ArticulatedInertia<S>& a, const Vec3<S>& r, const Vec3<S>& u, S k) {
  addPointMass(a, r, u, S(0), k);
}

template <class S>
MUROSIMF_INLINE void addGroundWheel(const GroundShape& shape, const GroundedBody<S>& body, const WheelFriction<S>& mu,
                                    S h, GroundReaction<S>& sum) {
  const GroundWheel& wheel = shape.wheel;
  const double* p = shape.X_RS.numbers + 9;
  const Vec3<S> centre{S(p[0]), S(p[1]), S(p[2])}, axle{S(wheel.axle[0]), S(wheel.axle[1]), S(wheel.axle[2])};
  const Vec3<S>& up = body.up;
  const Vec3<S> rim = wheel.castor ? up : unitOr(up - axle * dot(up, axle), up);
  const Vec3<S> r = centre - rim * S(shape.half_size[0]);
  const S height = body.height + dot(up, r);
  const Vec3<S> velocity = body.velocity.v + cross(body.velocity.w, r);
  const S speed = dot(velocity, up), depth_ahead = -fma(h, speed, height);
  const auto touches = depth_ahead > S(0);
  if (!any(touches)) return;
  const NormalForce<S> law = normalForce(shape.pair, S(shape.stiffness), select(touches, depth_ahead, S(0)), speed);
  const S normal_mass = select(touches, h * fma(h, law.by_depth, law.by_speed), S(0));
  // Directions of grip: two on the ground, or that of a roller's axle alone.
  const Vec3<S> drive = wheel.castor ? unitOr(cross(Vec3<S>{S(0), S(1), S(0)}, up), Vec3<S>{S(1), S(0), S(0)})
                                     : unitOr(cross(axle, up), Vec3<S>{S(1), S(0), S(0)});
  const Vec3<S> across = cross(up, drive);
  const Vec3<S> first = drive * S(wheel.cosine) + across * S(wheel.sine);
  const Vec3<S> slide = velocity - up * speed;
  const S along = dot(slide, first), beside = wheel.rollers ? S(0) : dot(slide, cross(up, first));
  const S rolling = wheel.castor ? S(0) : abs(dot(body.velocity.w, axle)) * S(shape.half_size[0]);
  const S free_slip = fma(mu.creepage, rolling, mu.stick_speed);
  const S slip = sqrt(fma(along, along, beside * beside));
  const S c = mu.coefficient * law.force / max(slip, free_slip), tangential_mass = h * c;
  const Vec3<S> proper = cross(body.velocity.w, velocity) - up * S(kGravity);  // of a_p, without that of the body
  Vec3<S> f = up * fnma(normal_mass, dot(proper, up), law.force);
  const auto grip = [&](const Vec3<S>& g, S s) MUROSIMF_INLINE_LAMBDA {
    f -= g * fma(tangential_mass, dot(proper, g), c * s);
    addMassAlong(sum.inertia, r, g, tangential_mass);
  };
  grip(first, along);
  if (!wheel.rollers) grip(cross(up, first), beside);
  addMassAlong(sum.inertia, r, up, normal_mass);
  sum.touched = select(touches, S(1), sum.touched);
  sum.force += SpatialForce<S>{cross(r, f), f};
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
