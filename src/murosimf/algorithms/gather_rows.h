#pragma once

/// @file Where recursions from the leaves of a tree to its base keep what children hand to their parents.
///
/// A body's inertia is complete when all its children have added theirs. Rows are visited from the last to the first.
/// What a row hands on is taken at once where the row visited next is its parent, as along all chains. Only other
/// children's contributions wait, and only few at a time (a humanoid: those of the second leg and arm), so their sums
/// stand in few slots, taken and freed like registers.

#include <vector>

#include "murosimf/algorithms/tree_table.h"

namespace murosimf {

struct GatherRow {
  bool starts = true;    ///< the row visited before is none of its children, it is a leaf mostly
  int slot = -1;         ///< holds the sum of its other children; -1: there are none
  int parent_slot = -1;  ///< takes what it hands on; -1: the parent is visited next and takes it at once
  bool first = false;    ///< the parent's slot holds nothing yet: overwrite it
};

struct GatherPlan {
  std::vector<GatherRow> rows;  ///< of each row of the tree
  int slots = 0;
};

/// A row's own slot may be taken again by its parent: read it before the contribution is written.
GatherPlan planGathering(const TreeTable& table);

}  // namespace murosimf
