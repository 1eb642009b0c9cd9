#include "experiment/shard.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace murosimf {

namespace {

constexpr int kNone = -1;

/// kNone where the text is no number from 0.
int wholeNumber(std::string_view text) {
  int value = 0;
  const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = failed == std::errc{} && end == text.data() + text.size() && value >= 0;
  return whole ? value : kNone;
}

class EnvironmentReader {
 public:
  EnvironmentReader(const Environment& environment, Diagnostics& diagnostics)
      : environment_(environment), diagnostics_(diagnostics) {}

  bool isSet(const char* name) const {
    const char* text = environment_(name);
    return text != nullptr && *text != '\0';
  }

  /// kNone after an error.
  int number(const char* name) const {
    if (!isSet(name)) {
      diagnostics_.error({name, 0, 0}, "is not set, expected a whole number; or say --shard INDEX/COUNT");
      return kNone;
    }
    const int value = wholeNumber(environment_(name));
    if (value < 0) {
      diagnostics_.error({name, 0, 0}, fmt::format("is \"{}\", expected a whole number from 0", environment_(name)));
    }
    return value;
  }

  std::optional<Shard> part(const char* index_name, int index, const char* count_name, int count) const {
    if (index >= 0 && index < count) return Shard{index, count, fmt::format("{}, {}", index_name, count_name)};
    diagnostics_.error({index_name, 0, 0},
                       fmt::format("gives part {} of {} ({}), expected 0 to {}", index, count, count_name, count - 1));
    return std::nullopt;
  }

  std::optional<Shard> pair(const char* index_name, const char* count_name) const {
    const int index = number(index_name), count = number(count_name);
    if (index < 0 || count < 0) return std::nullopt;
    return part(index_name, index, count_name, count);
  }

  /// Numbers of an array begin where the user said, and leave out what lies between its steps.
  std::optional<Shard> slurmArray() const {
    const int id = number("SLURM_ARRAY_TASK_ID"), count = number("SLURM_ARRAY_TASK_COUNT");
    const int least = isSet("SLURM_ARRAY_TASK_MIN") ? number("SLURM_ARRAY_TASK_MIN") : 0;
    const int step = isSet("SLURM_ARRAY_TASK_STEP") ? number("SLURM_ARRAY_TASK_STEP") : 1;
    if (id < 0 || count < 0 || least < 0 || step < 1) return std::nullopt;
    const int index = (id - least) / step;
    return part("SLURM_ARRAY_TASK_ID", least + index * step == id ? index : kNone, "SLURM_ARRAY_TASK_COUNT", count);
  }

 private:
  const Environment& environment_;
  Diagnostics& diagnostics_;
};

}  // namespace

std::optional<Shard> readShard(const std::string& text, Diagnostics& diagnostics) {
  const std::size_t slash = std::min(text.find('/'), text.size());
  const int index = wholeNumber(std::string_view(text).substr(0, slash));
  const int count = wholeNumber(std::string_view(text).substr(std::min(slash + 1, text.size())));
  if (index >= 0 && index < count) return Shard{index, count, "--shard"};
  const std::string expected = index < 0 || count < 1
                                   ? "INDEX/COUNT such as 0/4"
                                   : fmt::format("an INDEX from 0 to {}: parts count from 0", count - 1);
  diagnostics.error({"--shard", 0, 0}, fmt::format("is \"{}\", expected {}", text, expected));
  return std::nullopt;
}

std::optional<Shard> shardOf(const Environment& environment, Diagnostics& diagnostics) {
  const EnvironmentReader reader(environment, diagnostics);
  const auto isSet = [&](const char* name) { return reader.isSet(name); };
  std::optional<Shard> outer = Shard{}, inner = Shard{};
  if (isSet("SLURM_ARRAY_TASK_ID")) outer = reader.slurmArray();
  if (isSet("JOB_COMPLETION_INDEX")) outer = reader.pair("JOB_COMPLETION_INDEX", "JOB_COMPLETIONS");
  if (isSet("OMPI_COMM_WORLD_RANK"))
    inner = reader.pair("OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE");
  else if (isSet("PMI_RANK"))
    inner = reader.pair("PMI_RANK", "PMI_SIZE");
  else if (isSet("SLURM_PROCID") && isSet("SLURM_STEP_ID"))
    inner = reader.pair("SLURM_PROCID", "SLURM_STEP_NUM_TASKS");
  if (!outer || !inner) return std::nullopt;
  const std::string both = outer->source.empty() || inner->source.empty() ? "" : "; ";
  return Shard{outer->index * inner->count + inner->index, outer->count * inner->count,
               outer->source + both + inner->source};
}

}  // namespace murosimf
