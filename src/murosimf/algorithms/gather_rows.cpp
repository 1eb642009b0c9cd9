#include "murosimf/algorithms/gather_rows.h"

#include <algorithm>

namespace murosimf {

GatherPlan planGathering(const TreeTable& table) {
  GatherPlan plan;
  plan.rows.resize(table.rows.size());
  std::vector<bool> taken;
  for (std::size_t i = table.rows.size(); i-- > 1;) {
    GatherRow& row = plan.rows[i];
    GatherRow& parent = plan.rows[static_cast<std::size_t>(table.rows[i].parent)];
    if (row.slot >= 0) taken[static_cast<std::size_t>(row.slot)] = false;
    if (table.rows[i].parent == static_cast<int>(i) - 1) {
      parent.starts = false;
      continue;
    }
    row.first = parent.slot < 0;
    if (row.first) {
      const auto free = std::find(taken.begin(), taken.end(), false);
      parent.slot = static_cast<int>(free - taken.begin());
      if (free == taken.end()) taken.push_back(false);
      taken[static_cast<std::size_t>(parent.slot)] = true;
    }
    row.parent_slot = parent.slot;
  }
  plan.slots = static_cast<int>(taken.size());
  return plan;
}

}  // namespace murosimf
