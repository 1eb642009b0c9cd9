#pragma once

/// @file Reads the tables of a sweep's plan. What its cases make of the scenario is not looked at.

#include "experiment/sweep_plan.h"
#include "murosimf/scene/text_tree.h"

namespace murosimf {

/// A value as it would be written behind `--set PATH=`: TOML in one line.
std::string valueText(const TextNode& value);

inline constexpr double kMostRuns = 1e6;  ///< of one plan

class PlanReader {
 public:
  PlanReader(const TextNode& plan, const std::filesystem::path& file, Diagnostics& diagnostics)
      : plan_(plan), file_(file), problems_(diagnostics) {}

  /// What could be read; errors go to the diagnostics.
  SweepPlan read();

 private:
  using Changes = std::vector<Located<std::string>>;
  struct Axis {
    std::string name;
    SourceLocation where;
    std::vector<SweepCase> values;  ///< each with its label and what it changes
  };

  void readScenario(SweepPlan& plan);
  void readDirectory(SweepPlan& plan);
  void readConfidence(SweepPlan& plan);
  void readMetrics(SweepPlan& plan);
  void readSeeds(SweepPlan& plan);
  void readSeedRange(const TextNode& table, SweepPlan& plan);
  std::optional<std::uint64_t> readCount(const TextNode& node, const char* name, double least, double most);
  void combine(SweepPlan& plan, const Changes& all);

  Changes readChanges(const TextNode* table, const std::string& name);
  void addChanges(const TextNode& table, const std::string& path, Changes& changes);
  std::vector<Axis> readAxes();
  void addParameters(const TextNode& table, const std::string& path, std::vector<Axis>& axes);
  Axis readValues(const TextNode& list, const std::string& path);
  Axis readCases(const TextNode& list);
  bool isOurs(const std::string& path, const TextNode& node);
  void refuseUnknown(const TextNode& table, const std::string& name, const std::vector<std::string>& known);
  std::string text(const TextNode& node, const char* name);
  void fail(const TextNode& node, const std::string& name, const std::string& expected);

  const TextNode& plan_;
  const std::filesystem::path& file_;
  Diagnostics& problems_;
};

}  // namespace murosimf
