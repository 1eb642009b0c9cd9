#pragma once

/// @file Where recursions from the leaves of a tree to its base keep what children hand to their parents.
///
/// A body's inertia is complete when all its children have added theirs. Only few bodies wait at a time (a humanoid:
/// the pelvis and the trunk), so the sums stand in few slots, taken and freed like registers; along a chain of bodies
/// it is always the same one, which stays in the fastest memory.

#include <vector>

#include "murosimf/algorithms/tree_table.h"

namespace murosimf {

struct GatherRow {
  int slot = -1;         ///< holds the sum of this body's children; -1: it has none
  int parent_slot = -1;  ///< takes this body's contribution
  bool first = false;    ///< the parent's slot holds nothing yet: overwrite it
};

struct GatherPlan {
  std::vector<GatherRow> rows;  ///< of each row of the tree
  int slots = 0;
};

/// For a recursion that visits the rows from the last to the first. A row's own slot may be taken again by its parent:
/// read it before the contribution is written.
GatherPlan planGathering(const TreeTable& table);

}  // namespace murosimf
