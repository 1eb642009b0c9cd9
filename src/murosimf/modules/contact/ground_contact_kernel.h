#pragma once

/// @file Kernel of ground_contact.h.

#include "murosimf/algorithms/corner_forces.h"
#include "murosimf/algorithms/ground_hull.h"
#include "murosimf/algorithms/touch_response.h"
#include "murosimf/linking/kernel.h"

namespace murosimf {

struct GroundContactArguments {
  const GroundShape* shapes = nullptr;
  int count = 0;   ///< of boxes, ellipsoids and cylinders, which come first
  int bulges = 0;  ///< of capsules and hulls
  ColumnRef twist, up, height, force, inertia, touch, sole_response, touch_response;
};

void addBaselineKernels(KernelSet<GroundContactArguments>& kernels);
void addWideKernels(KernelSet<GroundContactArguments>& kernels);

inline namespace MUROSIMF_ISA {

/// A body may carry several shapes: the first that touches begins its sum.
template <class S>
MUROSIMF_INLINE void addInertia(ArticulatedInertia<S>& body, S& touch, const GroundReaction<S>& sum) {
  if (any(touch > S(0))) {
    body += sum.inertia;
  } else {
    body = sum.inertia;
  }
  touch = max(touch, sum.touched);
}

/// The part of a shape's reaction along up.
template <class S>
inline TouchResponse<S> touchResponse(const GroundReaction<S>& sum, const Vec3<S>& up) {
  return {dot(sum.force.f, up), {sum.inertia.H * up, sum.inertia.M * up}};
}

/// Capsules and hulls. A loop of its own leaves the other one, which is laid out for boxes, as short as it is.
template <class S>
__attribute__((noinline)) void groundUnderBulges(const GroundContactArguments& a, const BlockMemory& block,
                                                 const StepTime& time) {
  auto* soles = columnAt<CornerResponses<S>, S>(block, a.sole_response);
  const S h(time.implicit);
  for (int i = a.count; i < a.count + a.bulges; ++i) {
    const GroundShape& shape = a.shapes[i];
    const GroundedBody<S> body{columnAt<SpatialMotion<S>, S>(block, a.twist)[shape.row],
                               columnAt<Vec3<S>, S>(block, a.up)[shape.row],
                               columnAt<S, S>(block, a.height)[shape.row]};
    if (!mayTouch(shape, body, h)) continue;
    GroundReaction<S> sum;
    addGroundBulge(shape, body, h, sum, [&](int vertex, const PointResponse<S>& response) MUROSIMF_INLINE_LAMBDA {
      for (int corner = 0; shape.sole >= 0 && corner < 4; ++corner) {
        const S share(shape.shares[vertex].of[corner]);
        soles[shape.sole].force.of[corner] += response.force * share;
        soles[shape.sole].mass.of[corner] += response.mass * share;
      }
    });
    if (!any(sum.touched > S(0))) continue;
    columnAt<SpatialForce<S>, S>(block, a.force)[shape.row] += sum.force;
    if (shape.touch_sensor >= 0)
      columnAt<TouchResponse<S>, S>(block, a.touch_response)[shape.touch_sensor] += touchResponse(sum, body.up);
    if (time.implicit == 0) continue;
    addInertia(columnAt<ArticulatedInertia<S>, S>(block, a.inertia)[shape.row],
               columnAt<S, S>(block, a.touch)[shape.row], sum);
  }
}

template <class S>
void groundContact(const GroundContactArguments& a, const BlockMemory& block, const StepTime& time) {
  const auto* twist = columnAt<SpatialMotion<S>, S>(block, a.twist);
  const auto* up = columnAt<Vec3<S>, S>(block, a.up);
  const S* height = columnAt<S, S>(block, a.height);
  auto* force = columnAt<SpatialForce<S>, S>(block, a.force);
  auto* soles = columnAt<CornerResponses<S>, S>(block, a.sole_response);
  const S h(time.implicit);
  for (int i = 0; i < a.count; ++i) {
    const GroundShape& shape = a.shapes[i];
    const GroundedBody<S> body{twist[shape.row], up[shape.row], height[shape.row]};
    if (!mayTouch(shape, body, h)) continue;
    GroundReaction<S> sum;
    addGroundShape(shape, body, h, sum, [&](int point, const PointResponse<S>& response) MUROSIMF_INLINE_LAMBDA {
      if (shape.sole < 0 || point >= 4) return;
      soles[shape.sole].force.of[point] += response.force;
      soles[shape.sole].mass.of[point] += response.mass;
    });
    if (!any(sum.touched > S(0))) continue;
    force[shape.row] += sum.force;
    if (shape.touch_sensor >= 0) [[unlikely]]
      columnAt<TouchResponse<S>, S>(block, a.touch_response)[shape.touch_sensor] += touchResponse(sum, body.up);
    if (time.implicit == 0) continue;
    addInertia(columnAt<ArticulatedInertia<S>, S>(block, a.inertia)[shape.row],
               columnAt<S, S>(block, a.touch)[shape.row], sum);
  }
  if (a.bulges > 0) groundUnderBulges<S>(a, block, time);
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
