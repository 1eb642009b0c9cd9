#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "experiment/sweep_table.h"

namespace murosimf {

namespace {

using Json = nlohmann::ordered_json;

std::string quotedField(const std::string& field) {
  if (field.find_first_of(",\"\r\n") == field.npos) return field;
  std::string out = "\"";
  for (const char c : field) out += c == '"' ? "\"\"" : std::string(1, c);
  return out + "\"";
}

/// Shortest digits that read back to the same number; nothing for what is not known.
std::string digits(double value) { return std::isfinite(value) ? fmt::format("{}", value) : ""; }

Json jsonNumber(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

std::string line(const std::vector<std::string>& fields) {
  std::vector<std::string> quoted;
  for (const std::string& field : fields) quoted.push_back(quotedField(field));
  return fmt::format("{}\n", fmt::join(quoted, ","));
}

std::string markdownField(std::string field) {
  for (std::size_t at = field.find('|'); at != field.npos; at = field.find('|', at + 2)) field.insert(at, "\\");
  return field;
}

std::string cellText(const SweepCell& cell) {
  const Estimate& e = cell.estimate;
  if (e.size == 0) return "";
  const std::string interval =
      std::isfinite(e.interval.low) ? fmt::format(" [{:.4g}, {:.4g}]", e.interval.low, e.interval.high) : "";
  return fmt::format("{:.4g}{}", e.mean, interval);
}

std::string runCount(int count) { return fmt::format("{} run{}", count, count == 1 ? "" : "s"); }

std::string notes(const SweepPlan& plan, const SweepTable& table) {
  std::string out;
  for (std::size_t c = 0; c < table.rows.size(); ++c) {
    const SweepRow& row = table.rows[c];
    const std::string name = plan.cases[c].name();
    if (row.missing > 0) out += fmt::format("* {}: {} of {} missing\n", name, row.missing, runCount(row.runs));
    if (row.failed > 0) out += fmt::format("* {}: {} of {} failed\n", name, row.failed, runCount(row.runs));
    for (std::size_t m = 0; m < row.cells.size(); ++m)
      if (row.cells[m].unmeasured > 0)
        out += fmt::format("* {}: {} did not measure {}\n", name, runCount(row.cells[m].unmeasured),
                           plan.metrics[m]->text());
  }
  return out.empty() ? out : "\nWhat is not in these figures:\n\n" + out;
}

}  // namespace

std::string tableCsv(const SweepPlan& plan, const SweepTable& table) {
  std::vector<std::string> head = plan.axes;
  for (const char* name :
       {"metric", "kind", "runs", "failed", "missing", "unmeasured", "n", "mean", "standard_deviation", "low", "high"})
    head.emplace_back(name);
  std::string out = line(head);
  for (const SweepRow& row : table.rows) {
    for (std::size_t m = 0; m < row.cells.size(); ++m) {
      const SweepCell& cell = row.cells[m];
      std::vector<std::string> fields = row.labels;
      for (const std::string& field :
           {plan.metrics[m]->text(), std::string(cell.is_rate ? "rate" : "mean"), std::to_string(row.runs),
            std::to_string(row.failed), std::to_string(row.missing), std::to_string(cell.unmeasured),
            std::to_string(cell.estimate.size), digits(cell.estimate.mean), digits(cell.estimate.deviation),
            digits(cell.estimate.interval.low), digits(cell.estimate.interval.high)})
        fields.push_back(field);
      out += line(fields);
    }
  }
  return out;
}

std::string runsCsv(const SweepPlan& plan, const SweepTable& table) {
  std::vector<std::string> head = plan.axes;
  head.insert(head.end(), {"seed", "state"});
  for (const Located<Metric>& metric : plan.metrics) head.push_back(metric->text());
  head.insert(head.end(), {"state_hash", "failure"});
  std::string out = line(head);
  for (const SweepLine& run : table.lines) {
    std::vector<std::string> fields = run.labels;
    fields.push_back(std::to_string(run.seed));
    fields.emplace_back(run.missing ? "missing" : run.failure.empty() ? "done" : "failed");
    for (const std::optional<double>& value : run.values) fields.push_back(value ? digits(*value) : "");
    fields.insert(fields.end(), {run.state_hash, run.failure});
    out += line(fields);
  }
  return out;
}

std::string tableJson(const SweepPlan& plan, const SweepTable& table) {
  Json out;
  out["confidence"] = plan.confidence;
  out["axes"] = plan.axes;
  out["cases"] = Json::array();
  for (const SweepRow& row : table.rows) {
    Json one = {{"labels", row.labels}, {"runs", row.runs},       {"done", row.done},
                {"failed", row.failed}, {"missing", row.missing}, {"metrics", Json::array()}};
    for (std::size_t m = 0; m < row.cells.size(); ++m) {
      const SweepCell& cell = row.cells[m];
      one["metrics"].push_back({{"metric", plan.metrics[m]->text()},
                                {"kind", cell.is_rate ? "rate" : "mean"},
                                {"n", cell.estimate.size},
                                {"unmeasured", cell.unmeasured},
                                {"mean", jsonNumber(cell.estimate.mean)},
                                {"standard_deviation", jsonNumber(cell.estimate.deviation)},
                                {"low", jsonNumber(cell.estimate.interval.low)},
                                {"high", jsonNumber(cell.estimate.interval.high)},
                                {"values", cell.values}});
    }
    out["cases"].push_back(std::move(one));
  }
  return out.dump(2) + "\n";
}

std::string tableMarkdown(const SweepPlan& plan, const SweepTable& table) {
  std::vector<std::string> head = plan.axes;
  head.emplace_back("runs");
  for (const Located<Metric>& metric : plan.metrics) head.push_back(markdownField(metric->text()));
  std::string out = fmt::format("| {} |\n|", fmt::join(head, " | "));
  for (std::size_t i = 0; i < head.size(); ++i) out += i < plan.axes.size() ? "---|" : "---:|";
  out += "\n";
  for (const SweepRow& row : table.rows) {
    std::vector<std::string> fields;
    for (const std::string& label : row.labels) fields.push_back(markdownField(label));
    fields.push_back(row.done == row.runs ? std::to_string(row.runs) : fmt::format("{} of {}", row.done, row.runs));
    for (const SweepCell& cell : row.cells) fields.push_back(cellText(cell));
    out += fmt::format("| {} |\n", fmt::join(fields, " | "));
  }
  return out +
         fmt::format("\nMean or rate over the seeds, with its {:.4g} % confidence interval.\n", 100 * plan.confidence) +
         notes(plan, table);
}

}  // namespace murosimf
