#include "murosimf/algorithms/composite_body.h"

namespace murosimf {

MassMatrixPlan planMassMatrix(const TreeTable& table) {
  MassMatrixPlan plan;
  const auto add = [&](int parent) {
    const int depth = parent < 0 ? 0 : plan.unknowns[static_cast<std::size_t>(parent)].depth + 1;
    plan.unknowns.push_back({parent, depth, plan.entries});
    plan.entries += depth + 1;
  };
  for (int k = 0; k < 6; ++k) add(k - 1);
  for (int i = 1; i < table.bodyCount(); ++i) add(table.rows[static_cast<std::size_t>(i)].parent + 5);
  return plan;
}

}  // namespace murosimf
