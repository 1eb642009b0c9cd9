#pragma once

/// @file Everything that reads what clients send, as functions of bytes alone: for libFuzzer (tools/fuzz.sh), and for
/// the corpus that each run of the tests replays.

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace murosimf::fuzz {

/// Must return whatever the bytes are; aborts where something that always holds does not.
struct Target {
  std::string_view name;  ///< and of its folder in tests/fuzz/corpus
  void (*run)(std::span<const std::uint8_t> bytes);
};

const std::vector<Target>& allTargets();

}  // namespace murosimf::fuzz
