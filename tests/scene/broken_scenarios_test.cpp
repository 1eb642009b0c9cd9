// Every broken scenario of tests/data/broken gets its lines and words, and nothing but these.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "scene/scenario_for_test.h"

namespace murosimf::test {
namespace {

namespace fs = std::filesystem;

/// Starts of the lines that are said of each file, after "FILE:".
const std::map<std::string, std::vector<std::string>> kExpected = {
    {"binary_garbage", {"3:1: error: byte 0xa5 is not UTF-8, expected a text file (TOML)"}},
    {"degrees_misspelt",
     {"3:38: error: unknown key \"degs\" in heading, expected a number in rad or {deg = ...} (did you mean \"deg\"?)",
      "7:38: error: heading is text \"180 deg\", expected a number in rad or {deg = ...}"}},
    {"duplicate_key", {"4:8: error: this is not TOML: "}},
    {"duplicate_pair",
     {"4:11: error: the pair ball-turf is there twice, also in line 1, expected it once",
      "7:11: error: surfaces.bal-turf is no built-in pair, expected stiffness and restitution_factor for it (did you "
      "mean \"ball-turf\"?)"}},
    {"missing_values",
     {"1:13: error: file is missing, expected the robot's file", "1:13: error: pose is missing, expected pose = ",
      "3:11: error: control names no program, expected program = \"player\" or \"none\""}},
    {"nested_too_deep", {"2:65: error: nested deeper than 64 levels"}},
    {"out_of_range",
     {"2:9: error: frame is -0.001 s, expected a number, more than 0 and at most 0.02 s",
      "3:9: error: lanes is 3, expected 0, 1, 4 or 8",
      "4:12: error: duration is nan, expected a number, more than 0 and at most 1e+07 s",
      "7:8: error: mass is 500 kg, expected a number, at least 0.001 and at most 10 kg",
      "8:11: error: colour is 255, expected [red, green, blue], each from 0 to 1",
      "11:22: error: restitution_factor is 1.5, expected a number, at least 0 and at most 1",
      "15:9: error: x is 2100 m, expected at least -100 and at most 100 m"}},
    {"parts_of_frames",
     {"2:9: error: control_period is 0.01 s, expected a multiple of the frame's length of 0.004 s",
      "8:50: error: period is 0.006 s, expected a multiple of the frame's length of 0.004 s"}},
    {"pose_with_two_numbers",
     {"3:8: error: pose is an array of 2 values, expected [x, y, heading] or {x = ..., y = ..., heading = ...}"}},
    {"robot_file_missing", {"2:8: error: there is no robot file \"robots/ks12.urdf\", looked for from "}},
    {"same_goal",
     {"5:11: error: both teams attack the same goal, expected attacks = \"+x\" for one of them and \"-x\" for the "
      "other",
      "8:14: error: goal_width is 3.5 m, expected at most 3 m, as width is 3 m"}},
    {"syntax_error", {"2:12: error: this is not TOML: "}},
    {"unknown_key",
     {"3:1: error: unknown key \"brightnes\" in field, expected one of its 23 keys (did you mean \"brightness\"?)",
      "5:2: error: unknown key \"balls\", expected \"simulation\", \"field\", \"ball\", \"surfaces\", \"contacts\", "
      "\"teams\", \"robots\", \"obstacles\", \"course\", \"referee\", \"game_controller\" or \"output\" (did you mean "
      "\"ball\"?)",
      "11:1: error: unknown key \"moton\" in robots.red.1, expected one of its 28 keys (did you mean \"motion\"?)"}},
    {"unknown_preset",
     {"2:10: error: preset is text \"2025_kit\", expected \"2007\", \"2025_kid\", \"2025_adult\", \"2026_small\", "
      "\"2026_middle\" or \"2026_large\" (did you mean \"2025_kid\"?)"}},
    {"unknown_team",
     {"1:8: error: there is no team \"blu\" in teams, expected \"red\" or \"blue\" (did you mean \"blue\"?)",
      "4:9: error: there is no team \"green\" in robots, expected \"red\", \"blue\" or \"all\"",
      "8:13: error: robots.red.\"0\" is no jersey number, expected 1 to 99"}},
    {"wrong_type",
     {"2:11: error: threads is 1.5, expected a whole number, at least 0 and at most 1024",
      "3:8: error: seed is text \"lucky\", expected a whole number, at least 0",
      "6:8: error: mass is text \"heavy\", expected a number, at least 0.001 and at most 10 kg",
      "9:11: error: enabled is text \"yes\", expected true or false",
      "14:10: error: motion is 3, expected a name in quotes or a table",
      "15:8: error: role is an array of 1 value, expected a text in quotes"}},
};

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text.find('\n', at);
    lines.push_back(text.substr(at, end - at));
    at = end == text.npos ? text.size() : end + 1;
  }
  return lines;
}

void checkFile(const fs::path& file, const std::vector<std::string>& expected) {
  Diagnostics diagnostics;
  EXPECT_FALSE(readScenario(file, {}, diagnostics).has_value());
  const std::vector<std::string> said = linesOf(diagnostics.text());
  ASSERT_EQ(said.size(), expected.size()) << diagnostics.text();
  for (std::size_t i = 0; i < said.size(); ++i)
    EXPECT_TRUE(startsWith(said[i], file.string() + ":" + expected[i])) << said[i] << "\n  does not start with\n"
                                                                        << expected[i];
}

TEST(BrokenScenarios, EachIsRefusedWithItsPlacesAndWords) {
  std::size_t count = 0;
  const std::string prefix = "scenario_";
  for (const auto& entry : fs::directory_iterator(kRoot / "tests/data/broken")) {
    const std::string stem = entry.path().stem().string();
    if (entry.path().extension() != ".toml" || !startsWith(stem, prefix)) continue;
    SCOPED_TRACE(stem);
    const auto expected = kExpected.find(stem.substr(prefix.size()));
    ASSERT_NE(expected, kExpected.end()) << "a broken scenario of which this test expects nothing";
    checkFile(entry.path(), expected->second);
    ++count;
  }
  EXPECT_EQ(count, kExpected.size());
}

TEST(BrokenScenarios, AMissingRobotFileNamesItsNeighbour) {
  Diagnostics diagnostics;
  readScenario(kRoot / "tests/data/broken/scenario_robot_file_missing.toml", {}, diagnostics);
  EXPECT_NE(diagnostics.text().find("(did you mean \"robots/ks21.urdf\"?)"), std::string::npos) << diagnostics.text();
}

TEST(BrokenScenarios, AFileThatIsNotThereOrIsAFolderIsNamed) {
  Diagnostics diagnostics;
  EXPECT_FALSE(readScenario("no/such.toml", {}, diagnostics).has_value());
  EXPECT_FALSE(readScenario(kRoot / "scenarios", {}, diagnostics).has_value());
  ASSERT_EQ(diagnostics.errorCount(), 2);
  EXPECT_EQ(diagnostics.all()[0].where.file, "no/such.toml");
  EXPECT_TRUE(startsWith(diagnostics.all()[0].message, "there is no such file"));
  EXPECT_TRUE(startsWith(diagnostics.all()[1].message, "this is no file"));
}

TEST(BrokenScenarios, AMistakeInDefaultsIsToldOnceForAllRobots) {
  const auto said = complaints("[robots.all]\nmotion = {period = \"fast\"}\n" + kTwoRobots);
  ASSERT_EQ(said.size(), 1u);
  EXPECT_TRUE(startsWith(said[0], "2:20: period is text \"fast\", expected a number, at least 0 and at most 10 s"));
}

TEST(BrokenScenarios, AMistakeInDefaultsIsToldEvenIfEveryRobotOverridesIt) {
  const auto said = complaints("[teams.red]\nlevel = \"kinematik\"\n" + kTwoRobots, {"robots.red.1.level=kinematic"});
  ASSERT_EQ(said.size(), 1u);
  EXPECT_EQ(said[0],
            "2:9: level is text \"kinematik\", expected \"kinematic\", \"fast\", \"full\" or \"oracle\" (did you mean "
            "\"kinematic\"?)");
}

TEST(BrokenScenarios, StartPosesDoNotStandAmongDefaults) {
  const auto said = complaints("[robots.all]\npose = [0, 0, 0]\n" + kTwoRobots);
  ASSERT_EQ(said.size(), 1u);
  EXPECT_TRUE(startsWith(said[0], "2:1: pose stands among the defaults of many robots"));
}

TEST(BrokenScenarios, RobotsOnTopOfEachOtherAreOnlyAWarning) {
  Diagnostics diagnostics;
  EXPECT_TRUE(readScenarioText(kTwoRobots, kPlace, {"robots.red.1.pose=[0.95, 0, 0]"}, diagnostics).has_value());
  ASSERT_EQ(diagnostics.all().size(), 1u);
  EXPECT_EQ(diagnostics.errorCount(), 0);
  EXPECT_EQ(diagnostics.all()[0].message, "robots.blue.1 stands within 0.1 m of robots.red.1");
}

}  // namespace
}  // namespace murosimf::test
