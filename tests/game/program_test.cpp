// The program as its user meets it.

#include <gtest/gtest.h>

#include <filesystem>

#include "game/program.h"

namespace murosimf::test {
namespace {

TEST(Program, EveryBrokenFileGetsItsPlaceAndExitCodeTwo) {
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(MUROSIMF_SOURCE_DIR "/tests/data/broken")) {
    if (entry.path().extension() != ".toml" && entry.path().extension() != ".urdf") continue;
    ++files;
    const Outcome outcome = runProgram("check " + entry.path().string());
    EXPECT_EQ(outcome.exit_code, 2) << entry.path() << "\n" << outcome.text;
    EXPECT_NE(outcome.text.find(entry.path().filename().string() + ":"), std::string::npos) << outcome.text;
    EXPECT_NE(outcome.text.find("error: "), std::string::npos) << outcome.text;
  }
  EXPECT_GE(files, 10);
}

TEST(Program, ShippedRobotsAndScenariosAreRight) {
  const Outcome outcome = runProgram("check robots/ks21.urdf scenarios/game_3v3.toml scenarios/walk.toml");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.text;
}

TEST(Program, WrongArgumentsAreExplained) {
  EXPECT_EQ(runProgram("run").exit_code, 2);
  EXPECT_EQ(runProgram("fly").exit_code, 2);
  const Outcome missing = runProgram("run no_such_file.toml");
  EXPECT_EQ(missing.exit_code, 2);
  EXPECT_NE(missing.text.find("no_such_file.toml"), std::string::npos) << missing.text;
  const Outcome wrong_key = runProgram("run scenarios/walk.toml --set simulation.durration=3");
  EXPECT_EQ(wrong_key.exit_code, 2);
  EXPECT_NE(wrong_key.text.find("did you mean"), std::string::npos) << wrong_key.text;
}

TEST(Program, ModulesPrintsWhatEachNeedsAndAdds) {
  const Outcome table = runProgram("modules");
  EXPECT_EQ(table.exit_code, 0);
  for (const char* word : {"kinematic_walking", "base_pose", "needs", "adds", "soles"}) {
    EXPECT_NE(table.text.find(word), std::string::npos) << word;
  }
  const Outcome schedule = runProgram("modules --scenario scenarios/walk.toml");
  EXPECT_EQ(schedule.exit_code, 0) << schedule.text;
  EXPECT_NE(schedule.text.find("robots.red.1"), std::string::npos) << schedule.text;
}

TEST(Program, ReportHasWhatPeopleLookFor) {
  const std::string folder = freshFolder("report");
  const nlohmann::json report = playGame(folder, "--duration 2");
  for (const char* key : {"simulated_seconds", "wall_seconds", "real_time_factor", "threads", "score", "state_hash",
                          "state_hashes", "stages"}) {
    EXPECT_TRUE(report.contains(key)) << key;
  }
  for (const char* key : {"robot_pairs_near_mean", "shape_pairs_near_mean", "shape_pairs_tested_mean", "points_mean",
                          "points_most", "deepest"}) {
    EXPECT_TRUE(report["robot_contacts"].contains(key)) << key;
  }
  EXPECT_DOUBLE_EQ(report["simulated_seconds"].get<double>(), 2.0);
  EXPECT_EQ(report["state_hashes"].size(), 2u);
  EXPECT_TRUE(report["score"].contains("red"));
  EXPECT_TRUE(std::filesystem::exists(folder + "/overview.png"));
  EXPECT_TRUE(std::filesystem::exists(folder + "/robots.red.1.head.png"));
  EXPECT_TRUE(std::filesystem::exists(folder + "/robots.blue.3.chest.png"));
}

TEST(Program, PacedRunKeepsToTheWallClock) {
  const nlohmann::json report = playGame(freshFolder("paced"), "--duration 2 --pace 2");
  EXPECT_GE(report["wall_seconds"].get<double>(), 0.99);
  EXPECT_TRUE(report["pace"].contains("deadline_misses"));
}

}  // namespace
}  // namespace murosimf::test
