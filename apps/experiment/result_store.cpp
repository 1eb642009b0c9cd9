#include "experiment/result_store.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <string_view>

#include "experiment/content_hash.h"

namespace murosimf {

namespace {

using Json = nlohmann::ordered_json;

[[noreturn]] void fail(const std::filesystem::path& file) {
  throw std::runtime_error(fmt::format("{}: cannot be written: {}", file.string(), std::strerror(errno)));
}

/// Bytes that are no UTF-8 become question marks, as in the message of a library.
std::string dumped(const Json& json) { return json.dump(1, ' ', false, Json::error_handler_t::replace); }

Json toJson(const RunResult& result) {
  return {{"scenario", result.run.scenario.string()},
          {"set", result.run.overrides},
          {"seed", result.run.seed},
          {"program", result.program},
          {"failure", result.failure},
          {"cpu_seconds", result.cpu_seconds},
          {"wall_seconds", result.wall_seconds},
          {"report", result.report}};
}

RunResult fromJson(const Json& json) {
  RunResult result;
  result.run.scenario = json.at("scenario").get<std::string>();
  result.run.overrides = json.at("set").get<std::vector<std::string>>();
  result.run.seed = json.at("seed").get<std::uint64_t>();
  result.program = json.at("program").get<std::string>();
  result.failure = json.at("failure").get<std::string>();
  result.cpu_seconds = json.at("cpu_seconds").get<double>();
  result.wall_seconds = json.at("wall_seconds").get<double>();
  result.report = json.at("report");
  return result;
}

/// Writes and flushes to the disk: after a power cut the name must not stand for an empty file.
void writeDurably(const std::filesystem::path& file, std::string_view text) {
  const int descriptor = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (descriptor < 0) fail(file);
  bool written = true;
  while (written && !text.empty()) {
    const ssize_t count = ::write(descriptor, text.data(), text.size());
    if (count < 0 && errno == EINTR) continue;
    written = count > 0;
    if (written) text.remove_prefix(static_cast<std::size_t>(count));
  }
  written = written && fsync(descriptor) == 0;
  written = close(descriptor) == 0 && written;
  if (!written) fail(file);
}

}  // namespace

nlohmann::ordered_json withoutClocks(Json report) {
  for (const char* key : {"scenario", "wall_seconds", "real_time_factor", "threads", "stages", "pace"})
    report.erase(key);
  if (const auto control = report.find("control"); control != report.end() && control->is_object()) {
    control->erase("picture_seconds_all_threads");
    control->erase("program_seconds_all_threads");
  }
  return report;
}

RunClaim::~RunClaim() {
  if (descriptor_ < 0) return;
  std::error_code gone;
  if (exclusive_) std::filesystem::remove(file_, gone);
  close(descriptor_);
}

ResultStore::ResultStore(std::filesystem::path folder) : folder_(std::move(folder)) {
  std::filesystem::create_directories(folder_);
}

std::optional<RunResult> ResultStore::read(const std::string& identity) const {
  std::ifstream stream(fileOf(identity), std::ios::binary);
  if (!stream) return std::nullopt;
  const Json json = Json::parse(stream, nullptr, false);
  if (!json.is_object() || !json.contains("result") || !json.contains("sha256")) return std::nullopt;
  try {
    if (json.at("sha256") != sha256(dumped(json.at("result")))) return std::nullopt;
    return fromJson(json.at("result"));
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

void ResultStore::write(const std::string& identity, const RunResult& result, const RunClaim& claim) const {
  const Json kept = toJson(result);
  const Json whole = {{"sha256", sha256(dumped(kept))}, {"result", kept}};
  // Alone with a run, one name will do, and what a killed process left is overwritten.
  const std::string own = claim.exclusive() ? "" : fmt::format(".{}", getpid());
  const std::filesystem::path temporary = folder_ / fmt::format("{}{}.part", identity, own);
  writeDurably(temporary, dumped(whole) + "\n");
  if (std::rename(temporary.c_str(), fileOf(identity).c_str()) != 0) fail(fileOf(identity));
}

std::unique_ptr<RunClaim> ResultStore::claim(const std::string& identity) const {
  const std::filesystem::path file = folder_ / (identity + ".lock");
  for (;;) {
    const int descriptor = open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
    if (descriptor < 0) fail(file);
    const bool locked = flock(descriptor, LOCK_EX | LOCK_NB) == 0;
    if (!locked && errno == EWOULDBLOCK) {
      close(descriptor);
      return nullptr;
    }
    struct stat status {};
    const bool removed = fstat(descriptor, &status) == 0 && status.st_nlink == 0;
    if (!locked || !removed) return std::unique_ptr<RunClaim>(new RunClaim(file, descriptor, locked));
    close(descriptor);  // its holder has just finished and removed it
  }
}

}  // namespace murosimf
