#include "murosimf/algorithms/ray_caster_kernel.h"

namespace murosimf {
inline namespace MUROSIMF_ISA {
void castTilesInLanes(const CastJob& job);
void castTilesInLanes(const CastJob& job) { castTiles<Pack<float, 16>>(job); }
}  // namespace MUROSIMF_ISA
}  // namespace murosimf
