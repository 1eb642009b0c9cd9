#include "experiment/killed_sweep.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <sstream>

#include "experiment/folders.h"
#include "murosimf/math/random.h"

namespace murosimf::test {

namespace fs = std::filesystem;

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

int waitFor(pid_t pid) {
  int status = 0;
  waitpid(pid, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

namespace {

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

}  // namespace

std::string collectedBytes(const fs::path& plan, const fs::path& out) {
  EXPECT_EQ(waitFor(startProgram({"sweep", "collect", plan.string(), "--out", out.string()})), 0);
  std::string all;
  for (const char* file : {"table.csv", "table.json", "table.md", "runs.csv", "plot.svg"}) all += readFile(out / file);
  return all;
}

int playAndKill(const fs::path& plan, const fs::path& out, const std::string& shard, const Killer& killer) {
  const RandomStream random(killer.seed, "killed_sweep", 0);
  int kills = 0, supervisors = 0;
  std::uint64_t step = 0;
  for (;;) {
    const pid_t pid =
        startProgram({"sweep", "run", plan.string(), "--out", out.string(), "--shard", shard, "--workers", "2"});
    while (!hasEnded(pid)) {
      usleep(static_cast<useconds_t>(1e6 * random.uniform(++step, .05, killer.longest_pause)));
      const std::uint64_t bits = random.bits(++step);
      const bool the_supervisor = supervisors < killer.most_supervisors && bits % 4 == 0;
      const pid_t victim = the_supervisor ? pid : someWorkerOf(pid, bits / 4);
      if (victim == 0 || kills == killer.most_kills || hasEnded(pid) || kill(victim, SIGKILL) != 0) continue;
      ++kills;
      supervisors += the_supervisor ? 1 : 0;
    }
    const int code = waitFor(pid);
    if (code == 0) return kills;
    if (code != -SIGKILL) {
      ADD_FAILURE() << "the sweep ended with " << code;
      return kills;
    }
  }
}

}  // namespace murosimf::test
