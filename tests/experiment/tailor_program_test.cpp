// The program's own search, on the smallest scenario.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "experiment/folders.h"
#include "experiment/killed_sweep.h"
#include "murosimf/scene/scenario_reader.h"

namespace murosimf::test {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> tailorArguments(const fs::path& out, const std::string& metric) {
  return {
      "tailor", "scenarios/walk.toml",    "--metric", metric, "--tolerance", "1", "--seeds", "2", "--out", out.string(),
      "--set",  "simulation.duration=0.1"};
}

TEST(TailorProgram, LeavesAScenarioWithTheLevelsItFound) {
  const fs::path out = emptyFolder("tailor_program");
  ASSERT_EQ(waitFor(startProgram(tailorArguments(out, "robot_contacts.points_most"))), 0);
  const nlohmann::json found = nlohmann::json::parse(readFile(out / "tailor.json"));
  EXPECT_TRUE(found["check"]["equivalent"]);
  EXPECT_TRUE(found["constant"]) << "nobody touches a robot that stands alone";
  Diagnostics diagnostics;
  const std::optional<Scene> scene = readScenario(out / "tailored.toml", {}, diagnostics);
  ASSERT_TRUE(scene) << diagnostics.text();
  EXPECT_EQ(*scene->simulation.duration, .1);
  for (const nlohmann::json& detail : found["details"])
    EXPECT_TRUE(detail["detail"] != "robots.red.1.level" || detail["chosen"] == *scene->robots[0].level);
  EXPECT_NE(readFile(out / "tailor.md").find("--set robots.red.1.level="), std::string::npos);
}

TEST(TailorProgram, PlaysNothingTwice) {
  const fs::path out = emptyFolder("tailor_again");
  ASSERT_EQ(waitFor(startProgram(tailorArguments(out, "robot_contacts.points_most"))), 0);
  const std::string before = readFile(out / "tailor.json");
  const auto written = fs::last_write_time(out / "runs");
  ASSERT_EQ(waitFor(startProgram(tailorArguments(out, "robot_contacts.points_most"))), 0);
  EXPECT_EQ(readFile(out / "tailor.json"), before);
  EXPECT_EQ(fs::last_write_time(out / "runs"), written);
}

TEST(TailorProgram, RefusesAMetricThatNoReportHas) {
  EXPECT_EQ(waitFor(startProgram(tailorArguments(emptyFolder("tailor_wrong"), "robot_contacts.point_most"))), 2);
}

}  // namespace
}  // namespace murosimf::test
