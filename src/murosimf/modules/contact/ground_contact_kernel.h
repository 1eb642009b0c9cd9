#pragma once

/// @file Kernel of ground_contact.h.

#include "murosimf/algorithms/corner_forces.h"
#include "murosimf/algorithms/ground_hull.h"
#include "murosimf/algorithms/ground_wheel.h"
#include "murosimf/algorithms/touch_response.h"
#include "murosimf/linking/kernel.h"

namespace murosimf {

struct GroundContactArguments {
  const GroundShape* shapes = nullptr;
  int count = 0;   ///< of boxes, ellipsoids and cylinders, which come first
  int bulges = 0;  ///< of capsules and hulls
  ColumnRef twist, up, height, force, inertia, touch, sole_response, touch_response;
  int wheels = 0;  ///< which come last
  ColumnRef wheel_friction{}, wheel_stick_speed{}, wheel_creepage{};
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

template <class S>
inline GroundedBody<S> groundedBody(const GroundContactArguments& a, const BlockMemory& block, int row) {
  return {columnAt<SpatialMotion<S>, S>(block, a.twist)[row], columnAt<Vec3<S>, S>(block, a.up)[row],
          columnAt<S, S>(block, a.height)[row]};
}

/// Adds what the ground does to a shape to all who ask.
template <class S>
MUROSIMF_INLINE void deliver(const GroundContactArguments& a, const BlockMemory& block, const StepTime& time,
                             const GroundShape& shape, const Vec3<S>& up, const GroundReaction<S>& sum) {
  if (!any(sum.touched > S(0))) return;
  columnAt<SpatialForce<S>, S>(block, a.force)[shape.row] += sum.force;
  if (shape.touch_sensor >= 0)
    columnAt<TouchResponse<S>, S>(block, a.touch_response)[shape.touch_sensor] += touchResponse(sum, up);
  if (time.implicit == 0) return;
  addInertia(columnAt<ArticulatedInertia<S>, S>(block, a.inertia)[shape.row], columnAt<S, S>(block, a.touch)[shape.row],
             sum);
}

template <class S>
__attribute__((noinline)) void groundUnderWheels(const GroundContactArguments& a, const BlockMemory& block,
                                                 const StepTime& time) {
  const S h(time.implicit);
  for (int i = a.count + a.bulges; i < a.count + a.bulges + a.wheels; ++i) {
    const GroundShape& shape = a.shapes[i];
    const GroundedBody<S> body = groundedBody<S>(a, block, shape.row);
    if (!mayTouch(shape, body, h)) continue;
    const WheelFriction<S> friction{columnAt<S, S>(block, a.wheel_friction)[shape.wheel.number],
                                    columnAt<S, S>(block, a.wheel_stick_speed)[shape.wheel.number],
                                    columnAt<S, S>(block, a.wheel_creepage)[shape.wheel.number]};
    GroundReaction<S> sum;
    addGroundWheel(shape, body, friction, h, sum);
    deliver(a, block, time, shape, body.up, sum);
  }
}

/// Capsules and hulls. A loop of its own leaves the other one, which is laid out for boxes, as short as it is.
template <class S>
__attribute__((noinline)) void groundUnderBulges(const GroundContactArguments& a, const BlockMemory& block,
                                                 const StepTime& time) {
  auto* soles = columnAt<CornerResponses<S>, S>(block, a.sole_response);
  const S h(time.implicit);
  for (int i = a.count; i < a.count + a.bulges; ++i) {
    const GroundShape& shape = a.shapes[i];
    const GroundedBody<S> body = groundedBody<S>(a, block, shape.row);
    if (!mayTouch(shape, body, h)) continue;
    GroundReaction<S> sum;
    addGroundBulge(shape, body, h, sum, [&](int vertex, const PointResponse<S>& response) MUROSIMF_INLINE_LAMBDA {
      for (int corner = 0; shape.sole >= 0 && corner < 4; ++corner) {
        const S share(shape.shares[vertex].of[corner]);
        soles[shape.sole].force.of[corner] += response.force * share;
        soles[shape.sole].mass.of[corner] += response.mass * share;
      }
    });
    deliver(a, block, time, shape, body.up, sum);
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
  if (a.wheels > 0) groundUnderWheels<S>(a, block, time);
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
