#pragma once

/// @file What is read from the report of a run: a number, or a yes or no.
///
///     score.red                                a member of a table
///     robots[robots.red.1].distance_walked     the entry of a list that has this text as one of its values
///     goals[0].time                            an entry by its place, from 0
///     count(goals)                             how many entries a list has; 0 where there is no such list
///     trial.verdict==passed                    whether a text is this one
///
/// true and false are read as rates. What is null, and what a run's report lacks, was not measured.

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace murosimf {

struct MetricValue {
  double number = 0;      ///< 1 and 0 for true and false
  bool is_truth = false;  ///< of true and false
};

class Metric {
 public:
  /// Nothing where the text is no metric; `problem` says why then.
  static std::optional<Metric> parse(const std::string& text, std::string& problem);

  const std::string& text() const { return text_; }
  /// Nothing where it was not measured: the path leads nowhere, to null or to something that is neither number nor
  /// truth.
  std::optional<MetricValue> read(const nlohmann::ordered_json& report) const;
  /// Why read() gives nothing for this report, with the nearest path that there is; empty where it gives a value or
  /// null.
  std::string problem(const nlohmann::ordered_json& report) const;

 private:
  struct Step {
    bool is_entry = false;  ///< [text], not a member
    std::string text;
  };
  const nlohmann::ordered_json* find(const nlohmann::ordered_json& report) const;
  /// For messages: the names in the table in which the path ends, "; trial has attempts, passed".
  std::string whatThereIs(const nlohmann::ordered_json& report) const;
  static const nlohmann::ordered_json* stepInto(const nlohmann::ordered_json& json, const Step& step);

  std::string text_, path_;
  std::vector<Step> steps_;
  bool counts_ = false;
  std::optional<std::string> wanted_;  // text to compare with
};

/// All paths of a report that lead to a number, true, false or null, as metrics are written; those of lists by the name
/// in their entries where these have one, else by place. Lists of numbers and texts are left out.
std::vector<std::string> metricPaths(const nlohmann::ordered_json& report);

}  // namespace murosimf
