#include "murosimf/algorithms/composite_body.h"

namespace murosimf {

MassMatrixPlan planMassMatrix(const TreeTable& table) {
  MassMatrixPlan plan;
  for (int i = 1; i < table.bodyCount(); ++i) {
    const int parent = table.rows[static_cast<std::size_t>(i)].parent - 1;
    const int depth = parent < 0 ? 0 : plan.rows[static_cast<std::size_t>(parent)].depth + 1;
    plan.rows.push_back({parent, depth, plan.entries});
    plan.entries += depth + 7;
  }
  return plan;
}

}  // namespace murosimf
