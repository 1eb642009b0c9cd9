// Replays what the fuzzer found worth keeping, and what once went wrong.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "fuzz/targets.h"

namespace murosimf::fuzz {
namespace {

class Corpus : public ::testing::TestWithParam<std::size_t> {};

TEST_P(Corpus, IsReadWithoutHarm) {
  const Target& target = allTargets()[GetParam()];
  const auto folder = std::filesystem::path(MUROSIMF_SOURCE_DIR) / "tests/fuzz/corpus" / target.name;
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    std::ifstream file(entry.path(), std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    const std::vector<std::uint8_t> bytes(text.begin(), text.end());
    SCOPED_TRACE(entry.path().string());
    target.run(bytes);
    for (std::size_t size = 0; size < bytes.size(); size += bytes.size() / 8 + 1)
      target.run(std::span(bytes).first(size));
    ++count;
  }
  EXPECT_GT(count, 0) << "no corpus in " << folder;
}

INSTANTIATE_TEST_SUITE_P(Targets, Corpus, ::testing::Range(std::size_t{0}, allTargets().size()),
                         [](const auto& target) { return std::string(allTargets()[target.param].name); });

}  // namespace
}  // namespace murosimf::fuzz
