#include "experiment/sweep_table.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <tinyxml2.h>

#include <cmath>

#include "experiment/folders.h"
#include "experiment/sweep_plot.h"

namespace murosimf::test {
namespace {

/// Two axes, three seeds, three metrics; the plan's text is not read.
SweepPlan examplePlan() {
  SweepPlan plan;
  plan.axes = {"case", "field.brightness"};
  for (const char* name : {"even", "a \"b\", c"})
    for (const char* value : {"0.5", "1"}) plan.cases.push_back({{name, value}, {}});
  plan.seeds = {1, 2, 3};
  for (const char* text : {"score.red", "trial.passed", "perception.recall"}) {
    std::string problem;
    plan.metrics.push_back({*Metric::parse(text, problem), {"plan.toml", 3, 4}});
  }
  return plan;
}

std::vector<BatchRun> exampleRuns(const SweepPlan& plan) {
  std::vector<BatchRun> runs;
  for (std::size_t c = 0; c < plan.cases.size(); ++c)
    for (const std::uint64_t seed : plan.seeds) runs.push_back({{"", {}, seed}, fmt::format("c{}s{}", c, seed), ""});
  return runs;
}

/// Scores are seed + case; the last case has no results, one run of the third failed, one did not measure its recall.
void writeResults(const ResultStore& store, double wall_seconds) {
  for (int c = 0; c < 3; ++c) {
    for (int seed = 1; seed <= 3; ++seed) {
      RunResult result;
      result.wall_seconds = wall_seconds;
      if (c == 2 && seed == 2) result.failure = "crashed";
      result.report = {{"state_hash", "ff"},
                       {"score", {{"red", seed + c}}},
                       {"trial", {{"passed", seed > 1}}},
                       {"perception", {{"recall", nullptr}}}};
      if (seed != 3) result.report["perception"]["recall"] = .5;
      const std::string identity = fmt::format("c{}s{}", c, seed);
      store.write(identity, result, *store.claim(identity));
    }
  }
}

TEST(SweepTables, HoldMeansRatesAndIntervals) {
  const SweepPlan plan = examplePlan();
  const ResultStore store(emptyFolder("table"));
  writeResults(store, 1);
  Diagnostics diagnostics;
  const SweepTable table = collectSweep(plan, exampleRuns(plan), store, diagnostics);
  EXPECT_EQ(diagnostics.text(), "");
  ASSERT_EQ(table.rows.size(), 4u);
  const SweepCell& score = table.rows[1].cells[0];
  EXPECT_EQ(score.values, (std::vector<double>{2, 3, 4}));
  EXPECT_DOUBLE_EQ(score.estimate.mean, 3);
  EXPECT_NEAR(score.estimate.interval.high, 3 + 4.302653 / std::sqrt(3.0), 1e-6);
  EXPECT_TRUE(table.rows[1].cells[1].is_rate);
  EXPECT_NEAR(table.rows[1].cells[1].estimate.mean, 2.0 / 3, 1e-15);
  EXPECT_LT(table.rows[1].cells[1].estimate.interval.high, 1);
}

TEST(SweepTables, CountWhatIsMissingFailedAndNotMeasured) {
  const SweepPlan plan = examplePlan();
  const ResultStore store(emptyFolder("table_missing"));
  writeResults(store, 1);
  Diagnostics diagnostics;
  const SweepTable table = collectSweep(plan, exampleRuns(plan), store, diagnostics);
  EXPECT_EQ(table.failed(), 1);
  EXPECT_EQ(table.missing(), 3);
  EXPECT_EQ(table.rows[0].cells[2].unmeasured, 1);
  EXPECT_EQ(table.rows[2].cells[0].values, (std::vector<double>{3, 5}));
  const std::string text = tableMarkdown(plan, table);
  for (const char* line : {"| even | 0.5 | 3 | 2 [-0.4841, 4.484] | 0.6667 [0.2077, 0.9385] | 0.5 [0.5, 0.5] |\n",
                           "* even, 0.5: 1 run did not measure perception.recall\n",
                           "* a \"b\", c, 0.5: 1 of 3 runs failed\n", "* a \"b\", c, 1: 3 of 3 runs missing\n"})
    EXPECT_NE(text.find(line), std::string::npos) << line << text;
  const std::string csv = tableCsv(plan, table);
  EXPECT_NE(csv.find("\"a \"\"b\"\", c\",0.5,score.red,mean,3,1,0,0,2,4,1.4142135623730951,"), std::string::npos)
      << csv;
  EXPECT_NE(csv.find("\"a \"\"b\"\", c\",1,score.red,mean,3,0,3,0,0,,,,\n"), std::string::npos) << csv;
  EXPECT_NE(runsCsv(plan, table).find("\"a \"\"b\"\", c\",0.5,2,failed,,,,,crashed\n"), std::string::npos);
}

TEST(SweepTables, AreTheSameBytesHoweverLongTheRunsTook) {
  const SweepPlan plan = examplePlan();
  std::string texts[2];
  for (int i = 0; i < 2; ++i) {
    const ResultStore store(emptyFolder("table_bytes"));
    writeResults(store, 1 + i);
    Diagnostics diagnostics;
    const SweepTable table = collectSweep(plan, exampleRuns(plan), store, diagnostics);
    texts[i] = tableCsv(plan, table) + tableJson(plan, table) + tableMarkdown(plan, table) + runsCsv(plan, table) +
               sweepPlot(plan, table);
  }
  EXPECT_EQ(texts[0], texts[1]);
}

TEST(SweepTables, RefuseMetricsThatNoReportHas) {
  SweepPlan plan = examplePlan();
  std::string problem;
  plan.metrics[0].value = *Metric::parse("score.rde", problem);
  const ResultStore store(emptyFolder("table_metric"));
  writeResults(store, 1);
  Diagnostics diagnostics;
  collectSweep(plan, exampleRuns(plan), store, diagnostics);
  EXPECT_EQ(diagnostics.text(), "plan.toml:3:4: error: no report has \"score.rde\" (did you mean \"score.red\"?)\n");
}

TEST(SweepPlots, AreWellFormedPicturesWithADotAMean) {
  SweepPlan plan = examplePlan();
  const ResultStore store(emptyFolder("plot"));
  writeResults(store, 1);
  Diagnostics diagnostics;
  for (const bool numeric : {true, false}) {
    if (!numeric)
      for (SweepCase& one : plan.cases) one.labels[1] += " <&>";
    const std::string svg = sweepPlot(plan, collectSweep(plan, exampleRuns(plan), store, diagnostics));
    tinyxml2::XMLDocument document;
    ASSERT_EQ(document.Parse(svg.c_str()), tinyxml2::XML_SUCCESS) << svg;
    int dots = 0;
    for (auto* e = document.RootElement()->FirstChildElement("circle"); e != nullptr;
         e = e->NextSiblingElement("circle"))
      ++dots;
    EXPECT_EQ(dots, 3 * 3 + (numeric ? 3 * 2 : 0));  // a metric and case with results; legends of two series
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_EQ(svg.find("inf"), std::string::npos);
  }
}

}  // namespace
}  // namespace murosimf::test
