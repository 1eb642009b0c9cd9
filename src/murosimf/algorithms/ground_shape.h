#pragma once

/// @file Which points of a body's shapes may touch the ground, as tables that kernels read.
///
/// A box touches with its corners; an ellipsoid with its one deepest point; a cylinder with three points on the rim of
/// each of its ends: the deepest one and those a third of a turn from it, so that it stands, tips and lies as it
/// should; a wheel with the lowest point of its rim (ground_wheel.h); a capsule with the deepest point of each round
/// end; a convex hull with its vertices (ground_hull.h). Heights over the ground z = 0 follow from the world's up
/// direction u in the body's axes and the height of the body's origin alone: h(r) = h_0 + u . r.

#include "murosimf/algorithms/surface_pair.h"
#include "murosimf/algorithms/tree_rows.h"

namespace murosimf {

struct GroundPoint {
  double p[3];  ///< [m]
};
struct CornerShares {
  double of[4];  ///< corners of a sole
};

/// What a wheel has besides: its axle on the body, and the angle from the way that it drives to its lowest roller's
/// axle. A castor is a wheel without axle that grips alike in all directions.
struct GroundWheel {
  int number = 0;  ///< in the robot's
  bool castor = false, rollers = false;
  double axle[3] = {0, 1, 0};
  double cosine = 1, sine = 0;  ///< of the angle
};

/// One shape on a row of the tree, in plain numbers.
struct GroundShape {
  enum class Kind { kBox, kEllipsoid, kCylinder, kCapsule, kConvex, kWheel };
  Kind kind = Kind::kBox;
  int row = 0;
  int sole = -1;                    ///< number of the sole that this box's lower face is, or a hull's part, or -1
  int touch_sensor = -1;            ///< number of the touch sensor that feels it, or -1
  KernelPose X_RS;                  ///< shape on the body
  double half_size[3] = {0, 0, 0};  ///< as in Shape [m]
  double corners[8][3] = {};        ///< of a box, on the body, those of its lower face first: x, then y alternate [m];
                                    ///< the first two of a capsule: its ends' centres
  const GroundPoint* vertices = nullptr;  ///< of a hull, on the body; not owned
  const CornerShares* shares = nullptr;   ///< of the force on each vertex, for `sole`; not owned
  int vertex_count = 0;
  int least_corners = 0;  ///< of any face of a hull
  double reach = 0;       ///< radius of a sphere about the shape's centre that holds it [m]
  double stiffness = 0;   ///< of one point: s_c over the points on which the shape rests; of a hull s_c [N/m]
  SurfacePair pair;       ///< with the ground; of a wheel its normal law alone counts
  GroundWheel wheel;      ///< of a wheel

  /// Points on which a shape rests, by which the pair's stiffness is shared.
  static constexpr int kBoxPoints = 4, kCylinderPoints = 3, kEllipsoidPoints = 1, kCapsulePoints = 2, kConvexPoints = 1;
};

inline namespace MUROSIMF_ISA {

// Each calls visit(p, number) for every candidate point: of corners in the body's axes, of the others in the shape's,
// in which `up` is the world's z there.

template <class S, class Visit>
MUROSIMF_INLINE void forCorners(const GroundShape& shape, Visit&& visit) {
  for (int i = 0; i < 8; ++i) {
    const double* corner = shape.corners[i];
    visit(Vec3<S>{S(corner[0]), S(corner[1]), S(corner[2])}, i);
  }
}
template <class S, class Visit>
MUROSIMF_INLINE void forDeepestPoint(const GroundShape& shape, const Vec3<S>& up, Visit&& visit) {
  const S a(shape.half_size[0]), b(shape.half_size[1]), c(shape.half_size[2]);
  const Vec3<S> scaled{a * up.x, b * up.y, c * up.z};
  const S per_length = S(-1) / sqrt(squaredNorm(scaled));
  visit(Vec3<S>{a * scaled.x * per_length, b * scaled.y * per_length, c * scaled.z * per_length}, 0);
}
template <class S, class Visit>
MUROSIMF_INLINE void forRims(const GroundShape& shape, const Vec3<S>& up, Visit&& visit) {
  constexpr double kHalf = 0.5, kSineOfThird = 0.86602540378443864676;
  constexpr double kUpright = 1e-9;  // tilts smaller than this have no lowest side
  const S radius(shape.half_size[0]), tilt = sqrt(fma(up.x, up.x, up.y * up.y));
  const auto leans = tilt > S(kUpright);
  const S scale = radius / select(leans, tilt, S(1));
  const S x = select(leans, -up.x * scale, radius), y = select(leans, -up.y * scale, S(0));
  for (int end = 0; end < 2; ++end) {
    const S z(end == 0 ? -shape.half_size[2] : shape.half_size[2]);
    const S back_x = S(-kHalf) * x, back_y = S(-kHalf) * y;
    visit(Vec3<S>{x, y, z}, 3 * end);
    visit(Vec3<S>{fnma(S(kSineOfThird), y, back_x), fma(S(kSineOfThird), x, back_y), z}, 3 * end + 1);
    visit(Vec3<S>{fma(S(kSineOfThird), y, back_x), fnma(S(kSineOfThird), x, back_y), z}, 3 * end + 2);
  }
}
/// All points of a box, an ellipsoid or a cylinder in the body's axes, in which `up` is the world's z.
template <class S, class Visit>
MUROSIMF_INLINE void forGroundPoints(const GroundShape& shape, const Vec3<S>& up, Visit&& visit) {
  if (shape.kind == GroundShape::Kind::kBox) return forCorners<S>(shape, visit);
  const Transform<S> X_BS = poseFrom<S>(shape.X_RS);
  const Vec3<S> up_S = applyTransposed(X_BS.rotation, up);
  const auto visitOnBody = [&](const Vec3<S>& p_S, int number) MUROSIMF_INLINE_LAMBDA { visit(X_BS * p_S, number); };
  if (shape.kind == GroundShape::Kind::kEllipsoid) return forDeepestPoint(shape, up_S, visitOnBody);
  return forRims(shape, up_S, visitOnBody);
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
