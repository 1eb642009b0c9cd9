#include "murosimf/bench/machine.h"

#include <fmt/format.h>

#include <fstream>
#include <thread>

namespace murosimf {

namespace {

std::string processor() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    const std::size_t colon = line.find(": ");
    if (line.rfind("model name", 0) == 0 && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown processor";
}

bool isWide() { return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq"); }

}  // namespace

int lanesOf(const std::string& isa) {
  if (isa == "avx2") return 4;
  if (isa == "avx512" && !isWide()) return -1;
  return isWide() ? 8 : 4;
}

std::string machineLine(int lanes) {
#ifdef __clang__
  const std::string compiler = "clang++ " __clang_version__;
#else
  const std::string compiler = "g++ " __VERSION__;
#endif
  return fmt::format("{}, {} threads, {}, {}", processor(), std::thread::hardware_concurrency(),
                     lanes == 8 ? "AVX-512" : "AVX2", compiler);
}

}  // namespace murosimf
