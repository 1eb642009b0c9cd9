// `murosimf bench` as people run it: what it prints and writes, and what it refuses.

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "game/program.h"

namespace murosimf::test {
namespace {

TEST(BenchTable, TellsHowManyRobotsWalkAndSee) {
  const std::string file = freshFolder("bench_table") + "/table.json";
  const Outcome outcome = runProgram(
      "bench table --quick --robots 6 --threads 1 --rows 'multibody,kinematic distorted camera' --json " + file);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.text;
  EXPECT_NE(outcome.text.find("| multibody | 1000 Hz |  | 1 |"), std::string::npos) << outcome.text;
  std::ifstream stream(file);
  const auto rows = nlohmann::json::parse(stream, nullptr, false);
  ASSERT_EQ(rows.size(), 2U) << rows;
  EXPECT_EQ(rows[0]["row"], "kinematic distorted camera");
  EXPECT_EQ(rows[0]["paper"], 3);
  EXPECT_EQ(rows[1]["row"], "multibody");
  EXPECT_TRUE(rows[1]["paper"].is_null());
  for (const auto& row : rows) {
    EXPECT_EQ(row["threads"], 1);
    EXPECT_TRUE(row["robots"] == 6 || row["robots"] == 0) << row;  // 0: they are too many for this machine
  }
}

/// It ends with an error when the replayed game goes another way than the recorded one.
TEST(BenchGame, ReplaysTheControlOfAGameToTheSameBits) {
  const Outcome outcome = runProgram("bench game --seconds 0.3");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.text;
  EXPECT_NE(outcome.text.find("| 14 distorted cameras, 640 x 480, 30 Hz |"), std::string::npos) << outcome.text;
  EXPECT_NE(outcome.text.find("| no pictures |"), std::string::npos) << outcome.text;
  EXPECT_EQ(runProgram("bench game --seconds 0").exit_code, 2);
}

TEST(BenchTable, RefusesWhatItDoesNotKnow) {
  const Outcome row = runProgram("bench table --quick --rows kinematik");
  EXPECT_EQ(row.exit_code, 2);
  EXPECT_NE(row.text.find("unknown row \"kinematik\""), std::string::npos) << row.text;
  EXPECT_NE(row.text.find("did you mean \"kinematic\"?"), std::string::npos) << row.text;
  EXPECT_EQ(runProgram("bench table --quick --isa sse").exit_code, 2);
  EXPECT_EQ(runProgram("bench table --quick --threads 0").exit_code, 2);
  EXPECT_EQ(runProgram("bench table --quick --threads some").exit_code, 2);
  EXPECT_EQ(runProgram("bench table --quick --threads 2 --processor-time").exit_code, 2);
  EXPECT_EQ(runProgram("bench").exit_code, 2);
  const Outcome file = runProgram("bench table --quick --json /nowhere/table.json");
  EXPECT_EQ(file.exit_code, 2);
  EXPECT_NE(file.text.find("/nowhere/table.json"), std::string::npos) << file.text;
}

}  // namespace
}  // namespace murosimf::test
