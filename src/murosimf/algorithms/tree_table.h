#pragma once

/// @file A kinematic tree flattened for kernels: one row per body, parents before children.
///
/// Row 0 is the base. Body i hangs on its parent P by one joint: X_PB(q) = X_PF J(q), J turning about (revolute) or
/// sliding along (prismatic) one coordinate axis of F. Other axes and fixed elements have been folded into X_PF and
/// into the places of what the body carries. Joint j of a robot belongs to row j + 1.

#include <cstdint>
#include <vector>

#include "murosimf/math/transform.h"

namespace murosimf {

enum class JointKind : std::uint8_t { kRevolute, kPrismatic };

struct TreeRow {
  friend bool operator==(const TreeRow&, const TreeRow&) = default;

  int parent = -1;  ///< row of the parent body; -1 for the base
  JointKind kind = JointKind::kRevolute;
  int axis = 2;         ///< 0, 1, 2: x, y, z of F
  bool turned = false;  ///< X_PF has a rotation; false saves a matrix product
  Pose X_PF;            ///< joint frame on the parent body
};

struct TreeTable {
  std::vector<TreeRow> rows;
  int bodyCount() const { return static_cast<int>(rows.size()); }
  int jointCount() const { return bodyCount() - 1; }
  friend bool operator==(const TreeTable&, const TreeTable&) = default;
};

}  // namespace murosimf
