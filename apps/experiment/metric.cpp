#include "experiment/metric.h"

#include <fmt/format.h>

#include <charconv>

#include "murosimf/world/diagnostics.h"

namespace murosimf {

namespace {

using Json = nlohmann::ordered_json;

/// What entries of the report's lists are called by.
const char* const kNameKeys[] = {"robot", "name", "module"};

std::string trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return std::string(text);
}

std::string nameOf(const Json& entry, std::size_t place) {
  if (entry.is_object())
    for (const char* key : kNameKeys)
      if (const auto at = entry.find(key); at != entry.end() && at->is_string()) return at->get<std::string>();
  return std::to_string(place);
}

void addPaths(const Json& json, const std::string& path, std::vector<std::string>& paths) {
  if (json.is_object()) {
    for (const auto& [key, value] : json.items()) addPaths(value, path.empty() ? key : path + "." + key, paths);
  } else if (json.is_array()) {
    paths.push_back("count(" + path + ")");
    for (std::size_t i = 0; i < json.size(); ++i)
      if (json[i].is_object()) addPaths(json[i], fmt::format("{}[{}]", path, nameOf(json[i], i)), paths);
  } else if (!json.is_string()) {
    paths.push_back(path);
  }
}

}  // namespace

std::vector<std::string> metricPaths(const Json& report) {
  std::vector<std::string> paths;
  addPaths(report, "", paths);
  return paths;
}

std::optional<Metric> Metric::parse(const std::string& text, std::string& problem) {
  Metric metric;
  metric.text_ = metric.path_ = trimmed(text);
  if (const std::size_t equals = metric.path_.find("=="); equals != std::string::npos) {
    metric.wanted_ = trimmed(std::string_view(metric.path_).substr(equals + 2));
    metric.path_ = trimmed(std::string_view(metric.path_).substr(0, equals));
  } else if (metric.path_.starts_with("count(") && metric.path_.ends_with(")")) {
    metric.counts_ = true;
    metric.path_ = trimmed(std::string_view(metric.path_).substr(6, metric.path_.size() - 7));
  }
  const auto fail = [&](const char* what) {
    problem = fmt::format("\"{}\" {}, expected a path in report.json such as score.red", text, what);
    return std::nullopt;
  };
  std::string_view rest = metric.path_;
  while (!rest.empty()) {
    const bool entry = rest.front() == '[';
    const std::size_t end = entry ? rest.find(']') : rest.find_first_of(".[");
    if (entry && end == rest.npos) return fail("has a [ without ]");
    const std::string_view word = rest.substr(entry ? 1 : 0, end - (entry ? 1 : 0));
    if (word.empty() || (entry && metric.steps_.empty())) return fail("has an empty part");
    metric.steps_.push_back({entry, std::string(word)});
    rest = end == rest.npos ? std::string_view{} : rest.substr(end + (entry ? 1 : 0));
    if (rest.empty() || rest.front() == '[') continue;
    if (rest.front() != '.' || rest.size() == 1) return fail("has an empty part");
    rest.remove_prefix(1);
    if (rest.front() == '[') return fail("has an empty part");
  }
  if (metric.steps_.empty()) return fail("has an empty part");
  return metric;
}

const Json* Metric::stepInto(const Json& json, const Step& step) {
  if (!step.is_entry) {
    if (!json.is_object()) return nullptr;
    const auto at = json.find(step.text);
    return at == json.end() ? nullptr : &*at;
  }
  if (!json.is_array()) return nullptr;
  std::size_t place = 0;
  const char* const end = step.text.data() + step.text.size();
  const auto [stop, failed] = std::from_chars(step.text.data(), end, place);
  if (failed == std::errc{} && stop == end) return place < json.size() ? &json[place] : nullptr;
  for (const Json& entry : json) {
    if (!entry.is_object()) continue;
    for (const Json& value : entry)
      if (value.is_string() && value.get_ref<const std::string&>() == step.text) return &entry;
  }
  return nullptr;
}

std::string Metric::whatThereIs(const Json& report) const {
  const Json* at = &report;
  std::string where;
  for (const Step& step : steps_) {
    const Json* next = stepInto(*at, step);
    if (next == nullptr) break;
    at = next;
    where += step.is_entry ? "[" + step.text + "]" : (where.empty() ? "" : ".") + step.text;
  }
  if (where.empty()) where = "a report";
  if (at->is_array()) return fmt::format("; {} is a list of {}", where, at->size());
  std::string names;
  if (at->is_object())
    for (const auto& [key, value] : at->items()) names += (names.empty() ? "" : ", ") + key;
  return names.empty() ? "" : fmt::format("; {} has {}", where, names);
}

const Json* Metric::find(const Json& report) const {
  const Json* at = &report;
  for (const Step& step : steps_)
    if (at != nullptr) at = stepInto(*at, step);
  return at;
}

std::optional<MetricValue> Metric::read(const Json& report) const {
  const Json* at = find(report);
  if (counts_) {
    if (at == nullptr) return MetricValue{0, false};
    if (!at->is_array()) return std::nullopt;
    return MetricValue{static_cast<double>(at->size()), false};
  }
  if (at == nullptr) return std::nullopt;
  if (wanted_) {
    if (!at->is_string()) return std::nullopt;
    return MetricValue{at->get_ref<const std::string&>() == *wanted_ ? 1.0 : 0.0, true};
  }
  if (at->is_boolean()) return MetricValue{at->get<bool>() ? 1.0 : 0.0, true};
  if (at->is_number()) return MetricValue{at->get<double>(), false};
  return std::nullopt;
}

std::string Metric::problem(const Json& report) const {
  const Json* at = find(report);
  if (at != nullptr && at->is_null()) return "";
  if (read(report)) return "";
  if (at == nullptr) {
    const std::string wanted = counts_ ? "count(" + path_ + ")" : path_;
    const std::string near = didYouMean(wanted, metricPaths(report));
    return fmt::format("no report has \"{}\"{}", text_, near.empty() ? whatThereIs(report) : near);
  }
  const std::string found = at->is_string()   ? fmt::format("the text \"{}\"", at->get<std::string>())
                            : at->is_array()  ? "a list"
                            : at->is_object() ? "a table"
                                              : "no text";
  const std::string hint = at->is_string()  ? fmt::format(" or {}==TEXT", path_)
                           : at->is_array() ? fmt::format(" or count({})", path_)
                                            : "";
  return fmt::format("\"{}\" is {} in the reports, expected a number, true or false{}", text_, found, hint);
}

}  // namespace murosimf
