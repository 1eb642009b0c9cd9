#include "experiment/metric.h"

#include <gtest/gtest.h>

namespace murosimf {
namespace {

const nlohmann::ordered_json kReport = nlohmann::ordered_json::parse(R"({
  "score": {"red": 2, "blue": 0},
  "goals": [{"time": 3.5, "own_goal": false}, {"time": 7, "own_goal": true}],
  "robots": [{"robot": "robots.red.1", "kicks": 4}, {"robot": "robots.blue.1", "kicks": 1}],
  "perception": {"all": {"ball_recall": null, "name": "all"}},
  "trial": {"passed": true, "verdict": "out of bounds"}
})");

std::optional<MetricValue> read(const std::string& text) {
  std::string problem;
  const std::optional<Metric> metric = Metric::parse(text, problem);
  EXPECT_TRUE(metric) << problem;
  return metric ? metric->read(kReport) : std::nullopt;
}

std::string problemOf(const std::string& text) {
  std::string problem;
  const std::optional<Metric> metric = Metric::parse(text, problem);
  return metric ? metric->problem(kReport) : problem;
}

TEST(Metrics, ReadMembersEntriesAndCounts) {
  EXPECT_EQ(read("score.red")->number, 2);
  EXPECT_FALSE(read("score.red")->is_truth);
  EXPECT_EQ(read("robots[robots.blue.1].kicks")->number, 1);
  EXPECT_EQ(read("goals[1].time")->number, 7);
  EXPECT_EQ(read("count(goals)")->number, 2);
  EXPECT_EQ(read("count(frozen_robots)")->number, 0);
}

TEST(Metrics, ReadTruthAndTextsAsRates) {
  EXPECT_EQ(read("trial.passed")->number, 1);
  EXPECT_TRUE(read("trial.passed")->is_truth);
  EXPECT_EQ(read("goals[0].own_goal")->number, 0);
  EXPECT_EQ(read("trial.verdict==out of bounds")->number, 1);
  EXPECT_EQ(read("trial.verdict == fell")->number, 0);
  EXPECT_TRUE(read("trial.verdict==fell")->is_truth);
}

TEST(Metrics, ThatAreNullAreNotMeasuredAndNoMistake) {
  EXPECT_FALSE(read("perception.all.ball_recall"));
  EXPECT_EQ(problemOf("perception.all.ball_recall"), "");
}

TEST(Metrics, ThatNoReportHasAreToldWithTheNearest) {
  EXPECT_EQ(problemOf("score.rd"), "no report has \"score.rd\" (did you mean \"score.red\"?)");
  EXPECT_EQ(problemOf("robots[robots.red.1].kick"),
            "no report has \"robots[robots.red.1].kick\" (did you mean \"robots[robots.red.1].kicks\"?)");
  EXPECT_EQ(problemOf("trial.duration"), "no report has \"trial.duration\"; trial has passed, verdict");
  EXPECT_EQ(problemOf("robots[robots.red.1].mean_speed_in_play"),
            "no report has \"robots[robots.red.1].mean_speed_in_play\"; robots[robots.red.1] has robot, kicks");
  EXPECT_EQ(problemOf("robots[robots.green.17].mean_speed_in_play"),
            "no report has \"robots[robots.green.17].mean_speed_in_play\"; robots is a list of 2");
  EXPECT_EQ(problemOf("winner"), "no report has \"winner\"; a report has score, goals, robots, perception, trial");
  EXPECT_EQ(problemOf("goals"), "\"goals\" is a list in the reports, expected a number, true or false or count(goals)");
  EXPECT_EQ(problemOf("trial.verdict"),
            "\"trial.verdict\" is the text \"out of bounds\" in the reports, expected a number, true or false or "
            "trial.verdict==TEXT");
  EXPECT_EQ(problemOf("score"), "\"score\" is a table in the reports, expected a number, true or false");
}

TEST(Metrics, ThatAreNoPathsAreRefused) {
  for (const char* text : {"", ".", "a.", ".a", "a..b", "a[", "a[]", "[x]", "a.[x]", "a[x]b", "count()", "==x"}) {
    std::string problem;
    EXPECT_FALSE(Metric::parse(text, problem)) << text;
    EXPECT_NE(problem.find("expected a path in report.json"), problem.npos) << text;
  }
}

}  // namespace
}  // namespace murosimf
