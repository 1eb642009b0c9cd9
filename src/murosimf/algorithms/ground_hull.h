#pragma once

/// @file The ground under capsules and convex hulls (ground_contact.h tells of all others).
///
/// Capsule    the deepest points of its two round ends, with half of the pair's stiffness each: lying it rests
///            m g / s_c deep, on one end twice as deep, and one without length is a sphere. Turning friction at both.
/// Hull       its vertices. On how many of them it rests is not known before: 4 of a cube, 3 of a tetrahedron, 30 of a
///            sole with a round outline. So those that are below the ground share the stiffness s_c by their number,
///            counted by their depths x, and never fewer than the face with the fewest corners has, n_f:
///                k = s_c / max(n_f, sum x / max x)
///            A hull that lies on a face rests m g / s_c deep, whatever the number of its corners; a cube is the same
///            as a box, on its edges and corners too. The force is continuous as vertices come and go.
/// Cost       hull: 10 operations a vertex, and as of any other point for each that touches in any lane. A body that
///            rests takes as long as one that is a box with 8 vertices, 2 times as long with 30, 8 times with 128.

#include "murosimf/algorithms/ground_contact.h"

namespace murosimf {
inline namespace MUROSIMF_ISA {

template <class S>
MUROSIMF_INLINE Vec3<S> pointOnBody(const double (&p)[3]) {
  return {S(p[0]), S(p[1]), S(p[2])};
}

template <class S>
MUROSIMF_INLINE void addGroundCapsule(const GroundShape& shape, const GroundedBody<S>& body, S h,
                                      GroundReaction<S>& sum) {
  for (int end = 0; end < 2; ++end) {
    const Vec3<S> r = pointOnBody<S>(shape.corners[end]) - body.up * S(shape.half_size[0]);
    const PointResponse<S> response = addGroundPoint(shape.pair, body, r, S(shape.stiffness), h, sum);
    addTurningFriction(shape.pair, body.velocity.w, response.steady(), h, sum);
  }
}

/// Depth of a body's points at the end of a step of length h, as a plane over the body: x(r) = -(height + slope . r).
template <class S>
struct DepthAhead {
  S height;
  Vec3<S> slope;

  MUROSIMF_INLINE DepthAhead(const GroundedBody<S>& body, S h)
      : height(fma(h, dot(body.velocity.v, body.up), body.height)),
        slope(body.up + cross(body.up, body.velocity.w) * h) {}
  MUROSIMF_INLINE S operator()(const Vec3<S>& r) const { return -(height + dot(slope, r)); }
};

/// The stiffness of each vertex of a hull [N/m].
template <class S>
MUROSIMF_INLINE S vertexStiffness(const GroundShape& shape, const DepthAhead<S>& depthAhead) {
  S deepest(0), total(0);
  for (int i = 0; i < shape.vertex_count; ++i) {
    const S depth = max(depthAhead(pointOnBody<S>(shape.vertices[i].p)), S(0));
    deepest = max(deepest, depth);
    total += depth;
  }
  const auto touches = deepest > S(0);
  const S number = select(touches, total / select(touches, deepest, S(1)), S(0));
  return S(shape.stiffness) / max(number, S(shape.least_corners));
}

/// visit(number, response) hears of each vertex that touches in some lane.
template <class S, class Visit>
MUROSIMF_INLINE void addGroundHull(const GroundShape& shape, const GroundedBody<S>& body, S h, GroundReaction<S>& sum,
                                   Visit&& visit) {
  // Farther above the ground than rounding reaches: whether a lane looks at a vertex must not depend on the others.
  constexpr double kSurelyAbove = 1e-9;  // [m]
  const DepthAhead<S> depthAhead(body, h);
  const S k = vertexStiffness(shape, depthAhead);
  for (int i = 0; i < shape.vertex_count; ++i) {
    const Vec3<S> r = pointOnBody<S>(shape.vertices[i].p);
    if (any(depthAhead(r) > S(-kSurelyAbove))) visit(i, addGroundPoint(shape.pair, body, r, k, h, sum));
  }
}

/// A capsule or a hull; visit(number, response) hears of a hull's vertices.
template <class S, class Visit>
MUROSIMF_INLINE void addGroundBulge(const GroundShape& shape, const GroundedBody<S>& body, S h, GroundReaction<S>& sum,
                                    Visit&& visit) {
  if (shape.kind == GroundShape::Kind::kCapsule) return addGroundCapsule(shape, body, h, sum);
  addGroundHull(shape, body, h, sum, visit);
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
