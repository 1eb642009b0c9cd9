#include <fmt/format.h>

#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "murosimf/simulation/comparison.h"
#include "murosimf/simulation/recording.h"

namespace murosimf {

namespace {

/// The hashes of one report, as they are written.
struct Hashes {
  std::vector<std::string> seconds;
  std::string last;
};

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& reason) {
  throw std::runtime_error(fmt::format("{}: not a report that can be compared: {}", file.string(), reason));
}

Hashes readHashes(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) throw std::runtime_error(fmt::format("{}: cannot be read: {}", file.string(), std::strerror(errno)));
  const nlohmann::json report = nlohmann::json::parse(stream, nullptr, false);
  if (report.is_discarded()) fail(file, "found no JSON");
  if (!report.is_object()) fail(file, "found no JSON object");
  const auto list = report.find("state_hashes"), last = report.find("state_hash");
  if (list == report.end() || !list->is_array()) fail(file, "it lacks the list state_hashes");
  if (last == report.end()) fail(file, "it lacks state_hash");
  Hashes hashes;
  for (const nlohmann::json& hash : *list) hashes.seconds.push_back(hash.dump());
  hashes.last = last->dump();
  return hashes;
}

bool isRecording(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string start(kRecordingMagic.size(), '\0');
  stream.read(start.data(), static_cast<std::streamsize>(start.size()));
  return stream && start == kRecordingMagic;
}

std::filesystem::path reportOf(const std::filesystem::path& run) {
  return std::filesystem::is_directory(run) ? run / "report.json" : run;
}

}  // namespace

Comparison compareReports(const std::filesystem::path& file_a, const std::filesystem::path& file_b) {
  const Hashes a = readHashes(file_a), b = readHashes(file_b);
  Comparison result;
  const std::size_t both = std::min(a.seconds.size(), b.seconds.size());
  result.compared = fmt::format("{} seconds", both);
  for (std::size_t i = 0; i < both; ++i) {
    if (a.seconds[i] == b.seconds[i]) continue;
    result.notes.push_back(
        fmt::format("they differ first between t = {} s and t = {} s: hashes {} and {}; record both "
                    "runs to see the object and the property",
                    i, i + 1, a.seconds[i], b.seconds[i]));
    break;
  }
  if (a.seconds.size() != b.seconds.size()) {
    result.notes.push_back(fmt::format("they last {} s and {} s", a.seconds.size(), b.seconds.size()));
  }
  if (result.notes.empty() && a.last != b.last) {
    result.notes.push_back(fmt::format("they differ after the last full second: hashes {} and {}", a.last, b.last));
  }
  result.equal = result.notes.empty();
  return result;
}

Comparison compareRuns(const std::filesystem::path& run_a, const std::filesystem::path& run_b) {
  const std::filesystem::path a = reportOf(run_a), b = reportOf(run_b);
  const bool recorded_a = isRecording(a), recorded_b = isRecording(b);
  if (recorded_a && recorded_b) return compareRecordings(a, b);
  if (!recorded_a && !recorded_b) return compareReports(a, b);
  throw std::runtime_error(fmt::format("{} is a recording, {} is none: both runs must be told by the same kind of file",
                                       (recorded_a ? a : b).string(), (recorded_a ? b : a).string()));
}

}  // namespace murosimf
