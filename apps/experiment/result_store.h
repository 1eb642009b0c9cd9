#pragma once

/// @file The folder of an experiment's results, one file a run, shared by any number of processes on any machines.
///
/// FOLDER/IDENTITY.json is written under another name, flushed and renamed: whoever finds it finds all of it. It holds
/// the hash of its own contents, so that a file that a broken disk or an editor changed counts as absent.

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "experiment/run_settings.h"

namespace murosimf {

struct RunResult {
  RunSettings run;
  std::string program;  ///< SHA-256 of the program that played
  std::string failure;  ///< empty: none
  /// report.json without what depends on clocks, paths and the number of threads: the same whoever played.
  nlohmann::ordered_json report;
  double cpu_seconds = 0;   ///< of all frames, all threads together; differs a little from time to time
  double wall_seconds = 0;  ///< of building the world and of all frames; differs much
};

/// The report without its paths, clocks and threads.
nlohmann::ordered_json withoutClocks(nlohmann::ordered_json report);

/// The right to play a run, held by one process at a time: a lock that ends with its process, so none is ever stale.
/// On a file system without locks everybody is given it: the same run is then played twice, to the same result.
class RunClaim {
 public:
  ~RunClaim();
  RunClaim(const RunClaim&) = delete;
  RunClaim& operator=(const RunClaim&) = delete;
  bool exclusive() const { return exclusive_; }

 private:
  friend class ResultStore;
  RunClaim(std::filesystem::path file, int descriptor, bool exclusive)
      : file_(std::move(file)), descriptor_(descriptor), exclusive_(exclusive) {}

  std::filesystem::path file_;
  int descriptor_;
  bool exclusive_;
};

class ResultStore {
 public:
  /// Makes the folder where it is missing. @throws std::filesystem::filesystem_error
  explicit ResultStore(std::filesystem::path folder);

  const std::filesystem::path& folder() const { return folder_; }
  std::filesystem::path fileOf(const std::string& identity) const { return folder_ / (identity + ".json"); }

  /// Nothing where there is no result, or one that is not whole.
  std::optional<RunResult> read(const std::string& identity) const;
  /// @throws std::runtime_error naming the file where it cannot be written
  void write(const std::string& identity, const RunResult& result, const RunClaim& claim) const;
  /// Null where another process is playing this run. @throws std::runtime_error where the folder cannot be written
  std::unique_ptr<RunClaim> claim(const std::string& identity) const;

 private:
  std::filesystem::path folder_;
};

}  // namespace murosimf
