// The sweep of 200 short games, played in two parts at once, both under fire.

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>

#include "experiment/folders.h"
#include "experiment/killed_sweep.h"

namespace murosimf::test {
namespace {

TEST(KilledGames, HaveTheTableOfUndisturbedOnesByteForByte) {
  const std::filesystem::path folder = emptyFolder("killed_games"), plan = "scenarios/sweeps/short_games.toml";
  const std::string calm = (folder / "calm").string();
  ASSERT_EQ(waitFor(startProgram({"sweep", "run", plan.string(), "--out", calm, "--workers", "2"})), 0);
  const std::string expected = collectedBytes(plan, calm);
  EXPECT_GT(expected.size(), 20000u);
  pid_t parts[2];
  for (unsigned i = 0; i < 2; ++i) {
    parts[i] = fork();
    if (parts[i] != 0) continue;
    const std::string shard = std::to_string(i) + "/2";
    _exit(std::min(99, playAndKill(plan, folder / "killed", shard, Killer{i + 1, 6, 60, 8})));
  }
  const int kills_a = waitFor(parts[0]), kills_b = waitFor(parts[1]);
  EXPECT_GT(kills_a, 0);
  EXPECT_GT(kills_b, 0);
  RecordProperty("kills", kills_a + kills_b);
  EXPECT_EQ(collectedBytes(plan, folder / "killed"), expected);
}

}  // namespace
}  // namespace murosimf::test
