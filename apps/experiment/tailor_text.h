#pragma once

/// @file What the tailor found, for people and for programs.

#include <string>

#include "experiment/tailor.h"

namespace murosimf {

/// What was asked, beside the settings.
struct TailorQuestion {
  std::string scenario, metric;
  EquivalenceTest test;
  int seeds = 0;
};

/// The price of each detail and its effect, the combination found, and whether it held on fresh seeds.
std::string tailorText(const TailorQuestion& question, const std::vector<Detail>& details, const TailorResult& result);
std::string tailorJson(const TailorQuestion& question, const std::vector<Detail>& details, const TailorResult& result);

}  // namespace murosimf
