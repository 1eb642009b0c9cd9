#include "murosimf/algorithms/light/light_kernel.h"

namespace murosimf {
inline namespace MUROSIMF_ISA {
LightPasses lightPassesInLanes();
LightPasses lightPassesInLanes() { return lightPasses<Pack<float, 16>>(); }
}  // namespace MUROSIMF_ISA
}  // namespace murosimf
