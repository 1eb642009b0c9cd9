#include "math/masks.h"

namespace murosimf::test {

int wrongWideMasks() { return wrongMasks<double, 8>() + wrongMasks<float, 16>(); }

}  // namespace murosimf::test
