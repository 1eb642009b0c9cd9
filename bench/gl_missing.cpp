// Stands in for bench/gl where OpenGL's part is not built.

#include <cstdio>

#include "paired_ratio.h"

namespace murosimf::bench {

std::vector<Part> glParts() {
  std::printf("not compared with OpenGL: `make deps-view` installs what is missing\n");
  return {};
}

}  // namespace murosimf::bench
