#include "murosimf/algorithms/visit_rows.h"

#include <algorithm>

namespace murosimf {

namespace {

/// Rows, the deepest first.
std::vector<int> byDepth(const TreeTable& table) {
  std::vector<int> depth(table.rows.size(), 0), order;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    if (i > 0) depth[i] = depth[static_cast<std::size_t>(table.rows[i].parent)] + 1;
    order.push_back(static_cast<int>(i));
  }
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
    return depth[static_cast<std::size_t>(a)] > depth[static_cast<std::size_t>(b)];
  });
  return order;
}

/// Slots that are taken and freed, the lowest free one first.
class Slots {
 public:
  int take() {
    const auto free = std::find(taken_.begin(), taken_.end(), false);
    const auto slot = free - taken_.begin();
    if (free == taken_.end()) taken_.push_back(false);
    taken_[static_cast<std::size_t>(slot)] = true;
    return static_cast<int>(slot);
  }
  void give(int slot) { taken_[static_cast<std::size_t>(slot)] = slot == 0; }
  int count() const { return static_cast<int>(taken_.size()); }

 private:
  std::vector<bool> taken_{true};
};

}  // namespace

VisitPlan planVisits(const TreeTable& table) {
  VisitPlan plan;
  Slots slots;
  const std::vector<KernelRow> rows = kernelRows(table);
  std::vector<int> slot_of(rows.size(), 0);
  for (const int body : byDepth(table)) {
    if (body == 0) continue;
    const auto i = static_cast<std::size_t>(body);
    VisitRow visit{rows[i], body, slot_of[i], 0, false};
    slots.give(visit.slot);  // read before the contribution is written
    int& parent_slot = slot_of[static_cast<std::size_t>(rows[i].parent)];
    visit.first = parent_slot == 0;
    if (visit.first) parent_slot = slots.take();
    visit.parent_slot = parent_slot;
    plan.rows.push_back(visit);
  }
  plan.base_slot = slot_of[0];
  plan.slots = slots.count();
  return plan;
}

}  // namespace murosimf
