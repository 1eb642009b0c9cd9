#pragma once

/// @file Tree tables as kernels read them, and the walk from one body to the next.
///
/// Plain numbers: a kernel of another instruction set has vectors and poses of another type.

#include <vector>

#include "murosimf/algorithms/tree_table.h"

namespace murosimf {

/// TreeRow without types of math/. Rotation by columns, as in Rotation.
struct KernelRow {
  int parent = -1;
  int axis = 2;
  bool prismatic = false, turned = false;
  double rotation[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  double translation[3] = {0, 0, 0};
};

/// A pose as twelve numbers, rotation first.
struct KernelPose {
  double numbers[12] = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
};

std::vector<KernelRow> kernelRows(const TreeTable& table);
KernelPose kernelPose(const Pose& pose);

inline namespace MUROSIMF_ISA {

template <class S>
inline Rotation<S> rotationFrom(const double* n) {
  return {{S(n[0]), S(n[1]), S(n[2])}, {S(n[3]), S(n[4]), S(n[5])}, {S(n[6]), S(n[7]), S(n[8])}};
}
template <class S>
inline Transform<S> poseFrom(const KernelPose& pose) {
  const double* n = pose.numbers;
  return {rotationFrom<S>(n), {S(n[9]), S(n[10]), S(n[11])}};
}

/// R J for a turn J about a coordinate axis: two columns mix, one stays.
template <class S>
inline Rotation<S> turned(const Rotation<S>& r, int axis, const SinCos<S>& a) {
  const auto mixed = [&](const Vec3<S>& u, const Vec3<S>& v) {  // u cos + v sin
    return Vec3<S>{fma(u.x, a.cos, v.x * a.sin), fma(u.y, a.cos, v.y * a.sin), fma(u.z, a.cos, v.z * a.sin)};
  };
  if (axis == 0) return {r.x, mixed(r.y, r.z), mixed(r.z, -r.y)};
  if (axis == 1) return {mixed(r.x, -r.z), r.y, mixed(r.z, r.x)};
  return {mixed(r.x, r.y), mixed(r.y, -r.x), r.z};
}

/// X_WB of the body on a row from X_WP of its parent and its joint's position.
template <class S>
inline Transform<S> childPose(const Transform<S>& X_WP, const KernelRow& row, S q) {
  const Vec3<S> p{S(row.translation[0]), S(row.translation[1]), S(row.translation[2])};
  Rotation<S> rotation = row.turned ? X_WP.rotation * rotationFrom<S>(row.rotation) : X_WP.rotation;
  Vec3<S> position = X_WP * p;
  if (row.prismatic)
    return {rotation, position + (row.axis == 0 ? rotation.x : row.axis == 1 ? rotation.y : rotation.z) * q};
  return {turned(rotation, row.axis, sincos(q)), position};
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
