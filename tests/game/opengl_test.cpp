// Cameras of module opengl as a person meets them: where OpenGL is there, where it was not built, where a machine has
// none.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "game/game.h"
#include "game/program.h"

namespace murosimf::test {
namespace {

const std::string kPicture = "render scenarios/game_3v3.toml --camera robots.red.1.head --at 0.05 --out ";
const std::string kChosen = " --set robots.all.cameras.head.module=opengl";

TEST(OpenGl, DrawsOrSaysThatItIsMissing) {
  const std::string file = freshFolder("opengl") + "/a.png";
  const Outcome outcome = runProgram(kPicture + file + kChosen);
  const std::string missing = allPictureMakers().at("opengl")->missing;
  EXPECT_EQ(outcome.exit_code, missing.empty() ? 0 : 2);
  const std::string words = missing.empty() ? "pictures of 6 cameras by OpenGL " : "camera module opengl: " + missing;
  EXPECT_NE(outcome.text.find(words), std::string::npos) << outcome.text;
  EXPECT_EQ(std::filesystem::exists(file), missing.empty());
}

/// Without any driver: who asks for none needs none.
TEST(OpenGl, IsNotTouchedUnlessACameraAsksForIt) {
  if (!allPictureMakers().at("opengl")->missing.empty()) GTEST_SKIP() << "built without OpenGL";
  const std::string file = freshFolder("opengl_absent") + "/a.png";
  setenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/dev/null", 1);
  const Outcome plain = runProgram(kPicture + file), drawn = runProgram(kPicture + file + kChosen);
  unsetenv("__EGL_VENDOR_LIBRARY_FILENAMES");
  EXPECT_EQ(plain.exit_code, 0) << plain.text;
  EXPECT_EQ(plain.text.find("OpenGL"), std::string::npos) << plain.text;
  EXPECT_EQ(drawn.exit_code, 2);
  EXPECT_NE(drawn.text.find("error: camera robots.red.1.head: no OpenGL without display: "), std::string::npos)
      << drawn.text;
}

}  // namespace
}  // namespace murosimf::test
