#pragma once

/// @file Flattens a robot's kinematic tree into the table that kernels walk: one row per joint, plus the base.
///
/// Fixed elements are folded into their neighbours, so they cost nothing while running. A row's frame R is the frame of
/// its joint after the motion, re-framed so that the joint's axis is +x, +y or +z of it: for an axis a that is none of
/// these, R_ER is a rotation that takes the nearest coordinate axis to a. Bodies fixed to each other share a row.
///
/// Joint j is row j + 1; row 0 is the base, with the frame of the tree's base element.

#include <string>
#include <vector>

#include "murosimf/robot/kinematic_tree.h"

namespace murosimf {

/// Where something fixed lies on the rows.
struct RowPlace {
  int row = 0;
  Pose X_RB{};  ///< its frame B in the row's frame R
};

struct FlatTree {
  TreeTable table{};
  std::vector<RowPlace> bodies{};              ///< of each body of the tree: its row and its frame on it
  std::vector<MassProperties> row_mass{};      ///< of each row: all its bodies welded, in the row's frame
  std::vector<std::vector<int>> row_bodies{};  ///< of each row: its bodies
  std::vector<std::string> row_names{};  ///< of each row: its first body's name; the base's or joint's where none hangs
};

/// O(elements + bodies). The tree must be one that TreeBuilder or readUrdf made.
FlatTree flattenTree(const KinematicTree& tree);

/// A rotation whose column `k` is the unit vector `axis`; the identity when that is already a coordinate axis.
struct AxisFrame {
  int k = 2;
  Rotation3 R_ER{};
};
AxisFrame frameOfAxis(const Vector3& axis);

}  // namespace murosimf
