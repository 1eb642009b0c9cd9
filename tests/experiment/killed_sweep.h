#pragma once

/// @file The program's sweeps, and somebody who kills their processes at random.

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace murosimf::test {

/// Starts `murosimf ARGUMENTS` without its output.
pid_t startProgram(const std::vector<std::string>& arguments);
/// Exit code, or the signal's number below 0.
int waitFor(pid_t pid);

/// All files that `murosimf sweep collect` writes, one behind the other.
std::string collectedBytes(const std::filesystem::path& plan, const std::filesystem::path& out);

struct Killer {
  std::uint64_t seed = 1;
  double longest_pause = .6;  ///< between two kills [s]
  int most_kills = 20;        ///< so that it ends on machines that have much else to do
  int most_supervisors = 4;   ///< of these, processes that watch over workers: the sweep is started anew then
};

/// Plays a part of a plan with two workers, killing now a worker and now the process that watches over them, and
/// starting again until all is done. @return how many were killed
int playAndKill(const std::filesystem::path& plan, const std::filesystem::path& out, const std::string& shard,
                const Killer& killer);

}  // namespace murosimf::test
