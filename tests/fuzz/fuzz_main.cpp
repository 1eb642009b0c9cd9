// What libFuzzer calls: the target that MUROSIMF_FUZZ_TARGET names (tools/fuzz.sh).

#include <cstdio>
#include <cstdlib>

#include "fuzz/targets.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const murosimf::fuzz::Target* const target = [] {
    const char* name = std::getenv("MUROSIMF_FUZZ_TARGET");
    for (const murosimf::fuzz::Target& t : murosimf::fuzz::allTargets()) {
      if (name != nullptr && t.name == name) return &t;
    }
    std::fputs("MUROSIMF_FUZZ_TARGET names no target, expected one of:", stderr);
    for (const murosimf::fuzz::Target& t : murosimf::fuzz::allTargets())
      std::fprintf(stderr, " %.*s", static_cast<int>(t.name.size()), t.name.data());
    std::fputs("\n", stderr);
    std::exit(2);
  }();
  target->run({data, size});
  return 0;
}
