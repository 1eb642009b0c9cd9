// murosimf render: pictures of a game's cameras, and training sets.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "game/program.h"
#include "murosimf/simulation/png_writer.h"

namespace murosimf::test {
namespace {

namespace fs = std::filesystem;

const std::string kGame = "render scenarios/game_3v3.toml ";

std::string bytesOf(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(Render, WritesEveryKindOfPicture) {
  const std::string folder = freshFolder("render");
  for (const std::string as : {"colour", "depth", "labels", "boxes"}) {
    const std::string file = folder + "/" + as + ".png";
    const Outcome outcome = runProgram(kGame + "--camera robots.red.1.head --at 0.05 --as " + as + " --out " + file);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.text;
    EXPECT_EQ(bytesOf(file).substr(1, 3), "PNG") << as;
    EXPECT_EQ(outcome.text.find("robots.blue.1\n") != std::string::npos, as == "labels") << outcome.text;
  }
  EXPECT_NE(bytesOf(folder + "/colour.png"), bytesOf(folder + "/boxes.png"));
}

TEST(Render, ShowsTheSamePictureEachTime) {
  const std::string folder = freshFolder("render_twice");
  for (const char* name : {"a", "b"})
    runProgram(kGame + "--camera robots.red.2.head --at 0.5 --out " + folder + "/" + name + ".png");
  ASSERT_TRUE(fs::exists(folder + "/a.png"));
  EXPECT_EQ(bytesOf(folder + "/a.png"), bytesOf(folder + "/b.png"));
}

TEST(Render, SaysWhereItCannotWrite) {
  const Outcome outcome = runProgram(kGame + "--camera robots.red.1.head --at 0.05 --out no/such/folder/a.png");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.text.find("no/such/folder/a.png"), std::string::npos) << outcome.text;
}

TEST(Render, DatasetsHaveAPictureOfEveryCameraAtEveryTime) {
  const std::string folder = freshFolder("dataset") + "/set";
  const Outcome outcome =
      runProgram(kGame + "--camera robots.red.1.head --camera robots.red.1.chest --every 0.1 --dataset " + folder +
                 " --set simulation.duration=0.3");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.text;
  std::ifstream in(folder + "/annotations.json");
  const nlohmann::json all = nlohmann::json::parse(in);
  EXPECT_EQ(all["images"].size(), 8U) << "two cameras at 0, 0.1, 0.2, 0.3 s";
  for (const auto& image : all["images"]) EXPECT_TRUE(fs::exists(folder + "/" + image["file_name"].get<std::string>()));
  ASSERT_FALSE(all["annotations"].empty());
  for (const auto& seen : all["annotations"]) EXPECT_NE(seen["object"], "robots.red.1") << "hidden from its own eyes";
}

TEST(Render, MistakesAreExplained) {
  const Outcome wrong = runProgram(kGame + "--camera robots.red.1.hed --out nowhere.png");
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_NE(wrong.text.find("did you mean \"robots.red.1.head\"?"), std::string::npos) << wrong.text;
  EXPECT_EQ(runProgram(kGame + "--out nowhere.png").exit_code, 2) << "no camera";
  EXPECT_EQ(runProgram(kGame + "--camera robots.red.1.head --as smell").exit_code, 2);
  EXPECT_EQ(runProgram(kGame + "--dataset nowhere").exit_code, 2) << "without --every";
}

}  // namespace
}  // namespace murosimf::test
