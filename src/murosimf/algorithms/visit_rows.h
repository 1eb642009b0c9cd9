#pragma once

/// @file The rows of a tree in the order in which a recursion from the leaves to the base best visits them.
///
/// The deepest rows come first, so that rows which follow each other mostly do not wait for each other: a processor
/// works on several limbs at a time. What children hand to their parents stands in few slots, which are taken and freed
/// like registers (gather_rows.h says the same for the order of the table). Slot 0 stays empty: it is that of leaves.

#include <vector>

#include "murosimf/algorithms/tree_rows.h"

namespace murosimf {

struct VisitRow {
  KernelRow row;        ///< its joint
  int body = 0;         ///< number of the row in the table; its joint is body - 1
  int slot = 0;         ///< holds the sum of this body's children; 0: it has none
  int parent_slot = 0;  ///< takes this body's contribution
  bool first = false;   ///< the parent's slot holds nothing yet: overwrite it
};

struct VisitPlan {
  std::vector<VisitRow> rows;  ///< all but the base
  int base_slot = 0;
  int slots = 1;
};

VisitPlan planVisits(const TreeTable& table);

}  // namespace murosimf
