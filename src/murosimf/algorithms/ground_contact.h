#pragma once

/// @file What the ground does to one body that touches it: a force, and for steps that look ahead an added inertia.
///
/// A point at r on a body that moves with V = (w; v) has v_p = v + w x r, separating speed u = up . v_p, tangential
/// velocity v_t = v_p - u up, and the acceleration  a_p = (A_v + A_w x r) + w x v_p - g up  where A is the body's
/// proper acceleration (what the articulated-body algorithm finds). The law gives
///     f = f_n up - c v_t - K a_p,     K = k_t E + (k_n - k_t) up up^T
/// What multiplies A is the inertia of the point masses k_n, k_t at r, added to the body's:
///     M += K,   H += [r]x K,   I += [r]x K [r]x^T
/// and the rest of K a_p, centripetal and gravity, is taken off the force here: whoever adds the inertia to a body
/// whose accelerations are proper need not know of it. Cost: about 70 operations a point that touches in any lane; a
/// comparison with 30 operations a shape that does not.

#include "murosimf/algorithms/gravity.h"
#include "murosimf/algorithms/ground_law.h"
#include "murosimf/algorithms/ground_shape.h"
#include "murosimf/math/spatial.h"

namespace murosimf {
inline namespace MUROSIMF_ISA {

/// How a body moves over the ground, in its own axes, about its origin.
template <class S>
struct GroundedBody {
  SpatialMotion<S> velocity;
  Vec3<S> up;
  S height;
};

/// Added to by every point; begins with zeros.
template <class S>
struct GroundReaction {
  SpatialForce<S> force{};
  ArticulatedInertia<S> inertia{};
  S touched{};  ///< 1 in lanes where some point touches
};

/// I += [r]x K [r]x^T and so on, for K = kt E + d up up^T.
template <class S>
MUROSIMF_INLINE void addPointMass(ArticulatedInertia<S>& a, const Vec3<S>& r, const Vec3<S>& up, S kt, S d) {
  const Vec3<S> arm = cross(r, up);
  const S square = squaredNorm(r);
  const auto outer = [](Symmetric3<S>& m, const Vec3<S>& u, S scale) MUROSIMF_INLINE_LAMBDA {
    const Vec3<S> s = u * scale;
    m.xx = fma(s.x, u.x, m.xx), m.yy = fma(s.y, u.y, m.yy), m.zz = fma(s.z, u.z, m.zz);
    m.xy = fma(s.x, u.y, m.xy), m.xz = fma(s.x, u.z, m.xz), m.yz = fma(s.y, u.z, m.yz);
  };
  const auto diagonal = [](Symmetric3<S>& m, S value)
                            MUROSIMF_INLINE_LAMBDA { m.xx += value, m.yy += value, m.zz += value; };
  diagonal(a.M, kt);
  outer(a.M, up, d);
  diagonal(a.I, kt * square);
  outer(a.I, r, -kt);
  outer(a.I, arm, d);
  const Vec3<S> s = arm * d, k = r * kt;
  auto& H = a.H.e;
  H[0][0] = fma(s.x, up.x, H[0][0]), H[0][1] = fma(s.x, up.y, H[0][1]) - k.z, H[0][2] = fma(s.x, up.z, H[0][2]) + k.y;
  H[1][0] = fma(s.y, up.x, H[1][0]) + k.z, H[1][1] = fma(s.y, up.y, H[1][1]), H[1][2] = fma(s.y, up.z, H[1][2]) - k.x;
  H[2][0] = fma(s.z, up.x, H[2][0]) - k.y, H[2][1] = fma(s.z, up.y, H[2][1]) + k.x, H[2][2] = fma(s.z, up.z, H[2][2]);
}

/// The normal force on a point as a line: `force` less `mass` times the point's share of the body's proper acceleration
/// along up.
template <class S>
struct PointResponse {
  S force{}, mass{};
  /// >= 0, on a body that does not accelerate, as one that stands or rolls.
  MUROSIMF_INLINE S steady() const { return max(fnma(mass, S(kGravity), force), S(0)); }
};

/// One point. Adds nothing where the point will not be below the ground.
/// @param k  its stiffness [N/m]
/// @param h  as in ground_law.h
template <class S>
MUROSIMF_INLINE PointResponse<S> addGroundPoint(const SurfacePair& pair, const GroundedBody<S>& body, const Vec3<S>& r,
                                                S k, S h, GroundReaction<S>& sum) {
  const S height = body.height + dot(body.up, r);
  const Vec3<S> velocity = body.velocity.v + cross(body.velocity.w, r);
  const S speed = dot(velocity, body.up), depth_ahead = -fma(h, speed, height);
  const auto touches = depth_ahead > S(0);
  if (!any(touches)) return {};
  const Vec3<S> sliding = velocity - body.up * speed;
  const GroundForce<S> law = groundForce(pair, k, touches, depth_ahead, speed, norm(sliding), h);
  const Vec3<S> turning = cross(body.velocity.w, velocity);  // of a_p, as is gravity
  const S along = dot(turning, body.up), d = law.normal_mass - law.tangential_mass;
  const S lift = fnma(d, along - S(kGravity), fma(law.tangential_mass, S(kGravity), law.normal));
  const Vec3<S> f = body.up * lift - sliding * law.damping - turning * law.tangential_mass;
  sum.touched = select(touches, S(1), sum.touched);
  sum.force += SpatialForce<S>{cross(r, f), f};
  addPointMass(sum.inertia, r, body.up, law.tangential_mass, d);
  return {fnma(law.normal_mass, along - S(kGravity), law.normal), law.normal_mass};
}

/// Whether any point of the shape may touch by the end of the step.
template <class S>
MUROSIMF_INLINE bool mayTouch(const GroundShape& shape, const GroundedBody<S>& body, S h) {
  const double* p = shape.X_RS.numbers + 9;
  const Vec3<S> centre{S(p[0]), S(p[1]), S(p[2])};
  const Vec3<S>& w = body.velocity.w;
  const S speed = dot(body.velocity.v + cross(w, centre), body.up);
  const S turning = abs(w.x) + abs(w.y) + abs(w.z);  // at least |w|
  const S lowest = body.height + dot(body.up, centre) - S(shape.reach) * fma(h, turning, S(1));
  return any(fma(h, speed, lowest) < S(0));
}

/// Turning friction of a shape that touches with one point: torque -s_nu f w, at the step's end.
template <class S>
MUROSIMF_INLINE void addTurningFriction(const SurfacePair& pair, const Vec3<S>& w, S normal, S h,
                                        GroundReaction<S>& sum) {
  const S resistance = S(pair.turning_friction) * normal, inertia = h * resistance;
  sum.force.n -= w * resistance;
  sum.inertia.I.xx += inertia, sum.inertia.I.yy += inertia, sum.inertia.I.zz += inertia;
}

/// All points of a box, an ellipsoid or a cylinder; visit(number, response) hears of each.
template <class S, class Visit>
MUROSIMF_INLINE void addGroundShape(const GroundShape& shape, const GroundedBody<S>& body, S h, GroundReaction<S>& sum,
                                    Visit&& visit) {
  forGroundPoints(shape, body.up, [&](const Vec3<S>& r, int number) MUROSIMF_INLINE_LAMBDA {
    const PointResponse<S> response = addGroundPoint(shape.pair, body, r, S(shape.stiffness), h, sum);
    visit(number, response);
    if (shape.kind == GroundShape::Kind::kEllipsoid)
      addTurningFriction(shape.pair, body.velocity.w, response.steady(), h, sum);
  });
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
