// The program itself: sweeps whose processes are killed at random end with the same table as one that nobody disturbs.

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>

#include "experiment/folders.h"
#include "experiment/killed_sweep.h"

namespace murosimf::test {
namespace {

namespace fs = std::filesystem;

/// 24 games of a second: two cases and twelve seeds, which differ by what the robots see.
fs::path writePlan(const fs::path& folder) {
  writeFile(folder / "plan.toml",
            fmt::format("scenario = \"{}/scenarios/game_3v3.toml\"\nseeds = {{count = 12}}\n"
                        "metrics = [\"robots[robots.blue.3].distance_walked\", \"score.red\", \"count(goals)\"]\n"
                        "[set]\nsimulation.duration = 1\nrobots.all.level = \"oracle\"\n"
                        "robots.all.cameras.head.distance_noise = 0.1\n"
                        "[parameters]\nrobots.blue.3.cameras.head = [\"none\", \"oracle\"]\n",
                        MUROSIMF_SOURCE_DIR));
  return folder / "plan.toml";
}

TEST(KilledSweep, HasTheTableOfAnUndisturbedOneByteForByte) {
  const fs::path folder = emptyFolder("killed_sweep"), plan = writePlan(folder);
  ASSERT_EQ(waitFor(startProgram({"sweep", "run", plan.string(), "--out", (folder / "calm").string()})), 0);
  const std::string expected = collectedBytes(plan, folder / "calm");
  EXPECT_GT(expected.size(), 3000u);
  int kills = 0;
  for (const char* shard : {"0/2", "1/2"})
    kills += playAndKill(plan, folder / "killed", shard, Killer{shard[0] == '0' ? 1u : 2u, .6, 20, 4});
  EXPECT_GT(kills, 0) << "the games were too short to be killed";
  EXPECT_EQ(collectedBytes(plan, folder / "killed"), expected);
}

TEST(KilledSweep, StopsCleanlyWhenAsked) {
  const fs::path folder = emptyFolder("stopped_sweep"), plan = writePlan(folder);
  const pid_t pid = startProgram({"sweep", "run", plan.string(), "--out", folder.string()});
  while (!fs::exists(folder / "runs") || fs::is_empty(folder / "runs")) usleep(1000);
  kill(pid, SIGTERM);
  EXPECT_EQ(waitFor(pid), 75);
  for (const fs::directory_entry& entry : fs::directory_iterator(folder / "runs"))
    EXPECT_EQ(entry.path().extension(), ".json");
}

}  // namespace
}  // namespace murosimf::test
