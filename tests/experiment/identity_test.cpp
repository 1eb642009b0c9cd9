#include <gtest/gtest.h>

#include "experiment/content_hash.h"
#include "experiment/folders.h"
#include "experiment/input_files.h"
#include "experiment/run_identity.h"

namespace murosimf::test {
namespace {

namespace fs = std::filesystem;

TEST(ContentHash, IsThatOfTheStandardsExamples) {
  // FIPS 180-4, examples of NIST.
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST(ContentHash, KeepsPartsApart) {
  ContentHash a, b;
  a.add("ab"), a.add("c");
  b.add("a"), b.add("bc");
  EXPECT_NE(a.text(), b.text());
}

/// A scenario with a robot, its mesh, that mesh's colours, a servo file, a lens and a texture.
fs::path writeExperiment(const std::string& name) {
  const fs::path folder = emptyFolder(name);
  writeFile(folder / "game.toml",
            "[field]\ntexture = \"turf.png\"\n[robots.red.1]\nfile = \"robots/one.urdf\"\n"
            "pose = [0, 0, 0]\ncameras.head = {lens = \"lenses/wide.yaml\"}\n");
  writeFile(folder / "turf.png", std::string("\x89PNG\0\"", 6));
  writeFile(folder / "robots/one.urdf",
            "<robot><!-- it's one --><mesh filename='meshes/arm.obj'/>"
            "<joint servo_file=\"robots/servo.json\"/></robot>");
  writeFile(folder / "robots/meshes/arm.obj", "mtllib arm.mtl\r\nv 0 0 0\n");
  writeFile(folder / "robots/meshes/arm.mtl", "newmtl red\n");
  writeFile(folder / "robots/servo.json", "{}");
  writeFile(folder / "lenses/wide.yaml", "k1: 0.1\n");
  writeFile(folder / "lenses/narrow.yaml", "k1: 0.2\n");
  writeFile(folder / "notes.txt", "nobody reads this");
  return folder;
}

std::string identityOf(const fs::path& folder, std::vector<std::string> overrides = {}, std::uint64_t seed = 1,
                       const std::string& program = "program") {
  return RunIdentifier(program).identify({folder / "game.toml", std::move(overrides), seed});
}

TEST(RunIdentity, FindsEveryFileThatARunReads) {
  const fs::path folder = writeExperiment("inputs");
  std::vector<std::string> names;
  for (const InputFile& input : inputFiles(folder / "game.toml", {"robots.red.1.cameras.head.lens=lenses/narrow.yaml"}))
    names.push_back(input.name);
  EXPECT_EQ(names, (std::vector<std::string>{"arm.mtl", "lenses/narrow.yaml", "lenses/wide.yaml", "meshes/arm.obj",
                                             "robots/one.urdf", "robots/servo.json", "turf.png"}));
}

TEST(RunIdentity, FindsTheRobotOfTheGame) {
  const std::vector<InputFile> found = inputFiles(fs::path(MUROSIMF_SOURCE_DIR) / "scenarios/game_3v3.toml", {});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].name, "robots/ks21.urdf");
}

TEST(RunIdentity, ChangesWithEachByteThatEnters) {
  const std::string before = identityOf(writeExperiment("changes"));
  for (const char* file : {"game.toml", "turf.png", "robots/one.urdf", "robots/meshes/arm.obj", "robots/meshes/arm.mtl",
                           "robots/servo.json", "lenses/wide.yaml"}) {
    const fs::path folder = writeExperiment("changes");
    std::ofstream(folder / file, std::ios::app) << " ";
    EXPECT_NE(identityOf(folder), before) << file;
  }
  const fs::path folder = writeExperiment("changes");
  EXPECT_NE(identityOf(folder, {}, 2), before);
  EXPECT_NE(identityOf(folder, {}, 1, "another program"), before);
  EXPECT_NE(identityOf(folder, {"ball.present=false"}), before);
  EXPECT_NE(identityOf(folder, {"a.b=1", "a.c=2"}), identityOf(folder, {"a.c=2", "a.b=1"}));
}

TEST(RunIdentity, StaysWithWhatDoesNotEnter) {
  const fs::path folder = writeExperiment("stays");
  const std::string before = identityOf(folder);
  writeFile(folder / "notes.txt", "changed");
  EXPECT_EQ(identityOf(folder), before);
  EXPECT_EQ(identityOf(writeExperiment("stays_elsewhere")), before) << "paths enter";
  fs::last_write_time(folder / "game.toml", fs::file_time_type::clock::now() + std::chrono::hours(1));
  EXPECT_EQ(identityOf(folder), before) << "times enter";
}

TEST(RunIdentity, NamesAFileThatCannotBeRead) {
  try {
    identityOf("/nowhere");
    FAIL();
  } catch (const std::runtime_error& problem) {
    EXPECT_STREQ(problem.what(), "/nowhere/game.toml: cannot be read: No such file or directory");
  }
}

}  // namespace
}  // namespace murosimf::test
