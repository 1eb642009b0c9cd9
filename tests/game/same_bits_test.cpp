// The same game, to the last bit, however it is computed.

#include <gtest/gtest.h>

#include <filesystem>

#include "game/program.h"

namespace murosimf::test {
namespace {

constexpr const char* kShort = "--duration 4 --seed 5 ";

const nlohmann::json& reference() {
  static const nlohmann::json report = playGame(freshFolder("reference"), kShort);
  return report;
}

void expectSameGame(const nlohmann::json& report) {
  EXPECT_EQ(report["state_hash"], reference()["state_hash"]);
  EXPECT_EQ(report["state_hashes"], reference()["state_hashes"]);
}

TEST(SameBits, OneThreadAndTwoThreads) {
  expectSameGame(playGame(freshFolder("one_thread"), std::string(kShort) + "--threads 1"));
  expectSameGame(playGame(freshFolder("two_threads"), std::string(kShort) + "--threads 2"));
}

TEST(SameBits, ScalarAndLanes) {
  for (const char* lanes : {"1", "4", "8"}) {
    expectSameGame(playGame(freshFolder("lanes"), std::string(kShort) + "--lanes " + lanes));
  }
}

TEST(SameBits, WithAndWithoutFilmAndRecording) {
  const std::string folder = freshFolder("film");
  expectSameGame(
      playGame(folder, std::string(kShort) + "--video " + folder + "/game.mp4 --record " + folder + "/game.recording"));
  EXPECT_GT(std::filesystem::file_size(folder + "/game.mp4"), 10000u);
}

TEST(SameBits, AnotherSeedIsAnotherGame) {
  const nlohmann::json other = playGame(freshFolder("other_seed"), "--duration 4 --seed 6");
  EXPECT_NE(other["state_hash"], reference()["state_hash"]);
}

TEST(SameBits, StoppedAndContinuedGameIsTheWholeGame) {
  const std::string first = freshFolder("first_half"), second = freshFolder("second_half");
  playGame(first, std::string(kShort) + "--checkpoint " + first + "/half.checkpoint --checkpoint-at 2");
  expectSameGame(playGame(second, std::string(kShort) + "--from " + first + "/half.checkpoint"));
}

TEST(SameBits, CompareNamesWhereTwoGamesPart) {
  const std::string folder = freshFolder("compare");
  for (const char* seed : {"1", "2"}) {
    playGame(folder, "--duration 3 --seed " + std::string(seed) + " --record " + folder + "/" + seed + ".recording");
  }
  const Outcome same = runProgram("compare " + folder + "/1.recording " + folder + "/1.recording");
  EXPECT_EQ(same.exit_code, 0) << same.text;
  const Outcome different = runProgram("compare " + folder + "/1.recording " + folder + "/2.recording");
  EXPECT_EQ(different.exit_code, 1);
  EXPECT_NE(different.text.find("robots."), std::string::npos) << different.text;
  EXPECT_NE(different.text.find("frame"), std::string::npos) << different.text;
}

}  // namespace
}  // namespace murosimf::test
