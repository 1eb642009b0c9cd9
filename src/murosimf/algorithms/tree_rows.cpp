#include "murosimf/algorithms/tree_rows.h"

namespace murosimf {

KernelPose kernelPose(const Pose& pose) {
  KernelPose result;
  __builtin_memcpy(result.numbers, &pose, sizeof(result.numbers));
  return result;
}

std::vector<KernelRow> kernelRows(const TreeTable& table) {
  std::vector<KernelRow> rows;
  for (const TreeRow& row : table.rows) {
    KernelRow& out = rows.emplace_back();
    const KernelPose place = kernelPose(row.X_PF);
    out.parent = row.parent;
    out.axis = row.axis;
    out.prismatic = row.kind == JointKind::kPrismatic;
    out.turned = row.turned;
    for (int i = 0; i < 9; ++i) out.rotation[i] = place.numbers[i];
    for (int i = 0; i < 3; ++i) out.translation[i] = place.numbers[9 + i];
  }
  return rows;
}

}  // namespace murosimf
