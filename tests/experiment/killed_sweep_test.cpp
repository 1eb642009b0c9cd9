// The program itself: sweeps whose processes are killed at random end with the same table as one that nobody disturbs.

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <sstream>

#include "experiment/folders.h"
#include "murosimf/math/random.h"

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

pid_t startProgram(const std::vector<std::string>& arguments) {
  const pid_t pid = fork();
  if (pid != 0) return pid;
  std::vector<char*> pointers;
  std::vector<std::string> all = arguments;
  all.insert(all.begin(), MUROSIMF_PROGRAM);
  for (std::string& argument : all) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  if (freopen("/dev/null", "w", stdout) == nullptr || freopen("/dev/null", "w", stderr) == nullptr) _exit(126);
  execv(MUROSIMF_PROGRAM, pointers.data());
  _exit(127);
}

/// Exit code, or the signal's number below 0.
int waitFor(pid_t pid) {
  int status = 0;
  waitpid(pid, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

bool hasEnded(pid_t pid) {
  siginfo_t info{};
  return waitid(P_PID, static_cast<id_t>(pid), &info, WEXITED | WNOHANG | WNOWAIT) != 0 || info.si_pid == pid;
}

/// One of the processes that this one started, or none.
pid_t someWorkerOf(pid_t supervisor, std::uint64_t random) {
  std::istringstream list(readFile(fmt::format("/proc/{0}/task/{0}/children", supervisor)));
  std::vector<pid_t> workers;
  for (pid_t pid = 0; list >> pid;) workers.push_back(pid);
  return workers.empty() ? 0 : workers[random % workers.size()];
}

std::string collect(const fs::path& plan, const fs::path& out) {
  EXPECT_EQ(waitFor(startProgram({"sweep", "collect", plan.string(), "--out", out.string()})), 0);
  std::string all;
  for (const char* file : {"table.csv", "table.json", "table.md", "runs.csv", "plot.svg"}) all += readFile(out / file);
  return all;
}

/// Plays a part of the plan, killing now a worker and now the process that watches over them, until all is done.
int playAndKill(const fs::path& plan, const fs::path& out, const std::string& shard, std::uint64_t seed) {
  const RandomStream random(seed, "killed_sweep_test", 0);
  int kills = 0;
  for (std::uint64_t step = 0;; step += 3) {
    const pid_t pid =
        startProgram({"sweep", "run", plan.string(), "--out", out.string(), "--shard", shard, "--workers", "2"});
    for (int k = 0; k < 3; ++k) {
      usleep(static_cast<useconds_t>(random.uniform(3 * step + static_cast<unsigned>(k), 5e4, 6e5)));
      if (hasEnded(pid)) break;
      const pid_t worker = someWorkerOf(pid, random.bits(1000 + 3 * step + static_cast<unsigned>(k)));
      if (k < 2 && worker > 0 && kill(worker, SIGKILL) == 0) ++kills;
      if (k == 2 && kills < 12 && kill(pid, SIGKILL) == 0) ++kills;
    }
    if (waitFor(pid) == 0) return kills;
  }
}

TEST(KilledSweep, HasTheTableOfAnUndisturbedOneByteForByte) {
  const fs::path folder = emptyFolder("killed_sweep"), plan = writePlan(folder);
  ASSERT_EQ(waitFor(startProgram({"sweep", "run", plan.string(), "--out", (folder / "calm").string()})), 0);
  const std::string expected = collect(plan, folder / "calm");
  EXPECT_GT(expected.size(), 3000u);
  int kills = 0;
  for (const char* shard : {"0/2", "1/2"})
    kills += playAndKill(plan, folder / "killed", shard, shard[0] == '0' ? 1u : 2u);
  EXPECT_GT(kills, 0) << "the games were too short to be killed";
  EXPECT_EQ(collect(plan, folder / "killed"), expected);
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
