#include <fmt/format.h>

#include "murosimf/commands.h"
#include "murosimf/simulation/comparison.h"

namespace murosimf {

int printComparison(const std::string& a, const std::string& b) {
  try {
    const Comparison comparison = compareRuns(std::filesystem::path(a), std::filesystem::path(b));
    fmt::print("{}", comparison.text(a, b));
    return comparison.equal ? 0 : kDifferent;
  } catch (const std::runtime_error& problem) {
    fmt::print(stderr, "error: {}\n", problem.what());
    return kWrongInput;
  }
}

}  // namespace murosimf
