#include "experiment/plan_reader.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "murosimf/scene/robot_reader.h"

namespace murosimf {

namespace {

const std::vector<std::string> kKeys = {"scenario",   "directory", "seeds",      "metrics",
                                        "confidence", "set",       "parameters", "cases"};

bool isPlainKey(const std::string& key) {
  return !key.empty() && std::all_of(key.begin(), key.end(), [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-';
  });
}

}  // namespace

std::string valueText(const TextNode& value) {
  std::vector<std::string> parts;
  switch (value.kind) {
    case TextNode::Kind::kText:
      return nlohmann::json(std::get<std::string>(value.scalar)).dump();  // a JSON string is a TOML string
    case TextNode::Kind::kArray:
      for (const TextNode& child : value.children) parts.push_back(valueText(child));
      return fmt::format("[{}]", fmt::join(parts, ", "));
    case TextNode::Kind::kTable:
      for (const TextNode& child : value.children) {
        const std::string key = isPlainKey(child.key) ? child.key : nlohmann::json(child.key).dump();
        parts.push_back(fmt::format("{} = {}", key, valueText(child)));
      }
      return fmt::format("{{{}}}", fmt::join(parts, ", "));
    default:
      return describe(value);
  }
}

SweepPlan PlanReader::read() {
  SweepPlan plan;
  plan.file = file_;
  if (plan_.find("scenario") == nullptr && plan_.find("robots") != nullptr) {
    problems_.error({file_.string(), 0, 0},
                    "this is a scenario, expected the plan of a sweep, which names one: scenario = \"" +
                        file_.filename().string() + "\" (docs/sweeps.md)");
    return plan;
  }
  refuseUnknown(plan_, "", kKeys);
  readScenario(plan);
  readDirectory(plan);
  readSeeds(plan);
  readMetrics(plan);
  readConfidence(plan);
  combine(plan, readChanges(plan_.find("set"), "set"));
  if (static_cast<double>(plan.cases.size()) * static_cast<double>(plan.seeds.size()) > kMostRuns)
    problems_.error({file_.string(), 0, 0},
                    fmt::format("these are {} cases with {} seeds each, expected at most {} runs", plan.cases.size(),
                                plan.seeds.size(), kMostRuns));
  return plan;
}

void PlanReader::fail(const TextNode& node, const std::string& name, const std::string& expected) {
  problems_.error(node.where, fmt::format("{} is {}, expected {}", name, describe(node), expected));
}

void PlanReader::refuseUnknown(const TextNode& table, const std::string& name, const std::vector<std::string>& known) {
  for (const TextNode& child : table.children) {
    if (std::find(known.begin(), known.end(), child.key) != known.end()) continue;
    problems_.error(child.key_where, fmt::format("unknown key \"{}\"{}, expected {}{}", printable(child.key),
                                                 name.empty() ? "" : " in " + name, fmt::join(known, ", "),
                                                 didYouMean(child.key, known)));
  }
}

std::string PlanReader::text(const TextNode& node, const char* name) {
  if (node.kind == TextNode::Kind::kText && !std::get<std::string>(node.scalar).empty())
    return std::get<std::string>(node.scalar);
  fail(node, name, "a text");
  return "";
}

void PlanReader::readScenario(SweepPlan& plan) {
  const TextNode* node = plan_.find("scenario");
  if (node == nullptr)
    return problems_.error({file_.string(), 0, 0}, "scenario is missing, expected the file of a scenario");
  const std::string name = text(*node, "scenario");
  if (name.empty()) return;
  plan.scenario = findDataFile(name, file_);
  if (plan.scenario.empty())
    problems_.error(node->where, fmt::format("there is no scenario {}", whereLooked(name, file_)));
}

void PlanReader::readDirectory(SweepPlan& plan) {
  const TextNode* node = plan_.find("directory");
  plan.directory = std::filesystem::path("out") / "sweeps" / file_.stem();
  if (node != nullptr) plan.directory = text(*node, "directory");
}

void PlanReader::readConfidence(SweepPlan& plan) {
  const TextNode* node = plan_.find("confidence");
  if (node == nullptr) return;
  const double* number = std::get_if<double>(&node->scalar);
  if (number == nullptr || !(*number >= 0.5 && *number <= 0.9999))
    return fail(*node, "confidence", "a number of at least 0.5 and at most 0.9999, such as 0.95");
  plan.confidence = *number;
}

void PlanReader::readMetrics(SweepPlan& plan) {
  const TextNode* node = plan_.find("metrics");
  if (node == nullptr)
    return problems_.error({file_.string(), 0, 0},
                           "metrics is missing, expected a list of paths in report.json such as [\"score.red\"]");
  if (node->kind != TextNode::Kind::kArray || node->children.empty())
    return fail(*node, "metrics", "a list of paths in report.json such as [\"score.red\"]");
  std::set<std::string> known;
  for (const TextNode& child : node->children) {
    const std::string written = text(child, "a metric");
    if (written.empty()) continue;
    std::string problem;
    const std::optional<Metric> metric = Metric::parse(written, problem);
    if (!metric)
      problems_.error(child.where, problem);
    else if (!known.insert(metric->text()).second)
      problems_.error(child.where, fmt::format("\"{}\" is there twice", printable(written)));
    else
      plan.metrics.push_back({*metric, child.where});
  }
}

std::optional<std::uint64_t> PlanReader::readCount(const TextNode& node, const char* name, double least, double most) {
  const std::int64_t* number = std::get_if<std::int64_t>(&node.scalar);
  if (number == nullptr || static_cast<double>(*number) < least || static_cast<double>(*number) > most) {
    fail(node, name, fmt::format("a whole number from {} to {}", least, most));
    return std::nullopt;
  }
  return static_cast<std::uint64_t>(*number);
}

void PlanReader::readSeeds(SweepPlan& plan) {
  const TextNode* node = plan_.find("seeds");
  constexpr const char* kExpected = "a list such as [1, 2, 3], or {from = 1, count = 100}";
  if (node == nullptr)
    return problems_.error({file_.string(), 0, 0}, fmt::format("seeds is missing, expected {}", kExpected));
  if (node->isTable()) return readSeedRange(*node, plan);
  if (node->kind != TextNode::Kind::kArray || node->children.empty()) return fail(*node, "seeds", kExpected);
  std::set<std::uint64_t> known;
  for (const TextNode& child : node->children) {
    const std::optional<std::uint64_t> seed = readCount(child, "a seed", 0, 9e15);
    if (!seed) continue;
    if (!known.insert(*seed).second) problems_.error(child.where, fmt::format("seed {} is there twice", *seed));
    plan.seeds.push_back(*seed);
  }
}

void PlanReader::readSeedRange(const TextNode& table, SweepPlan& plan) {
  refuseUnknown(table, "seeds", {"from", "count"});
  const TextNode *from = table.find("from"), *count = table.find("count");
  if (count == nullptr) return problems_.error(table.where, "seeds lacks count, expected {from = 1, count = 100}");
  const std::uint64_t first = from == nullptr ? 1 : readCount(*from, "from", 0, 9e15).value_or(1);
  const std::uint64_t size = readCount(*count, "count", 1, kMostRuns).value_or(0);
  for (std::uint64_t i = 0; i < size; ++i) plan.seeds.push_back(first + i);
}

}  // namespace murosimf
