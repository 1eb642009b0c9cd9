// Stands in for bench/peers where MuJoCo and ODE are not installed.

#include <cstdio>

#include "paired_ratio.h"

namespace murosimf::bench {

std::vector<Part> peerParts() {
  std::printf("not compared with MuJoCo and ODE: `tools/install_packages.sh bench` installs what is missing\n");
  return {};
}

}  // namespace murosimf::bench
