#include "murosimf/simulation/comparison.h"

#include <gtest/gtest.h>

#include "murosimf/simulation/recorder.h"
#include "simulation/bouncing_balls.h"

namespace murosimf {
namespace {

struct Nudge {
  long frame = -1;         // none
  double velocity = 0.25;  // that the blue ball gets along y instead of what it has
};

/// Records the balls; from a frame on, the blue one moves otherwise: by its state, not by an intervention.
std::filesystem::path record(const std::filesystem::path& file, long frames, int balls = 2, Nudge nudge = {}) {
  test::BouncingBalls game(balls);
  Recorder recorder(file, *game.simulation, "balls", 42);
  game.simulation->observe(&recorder);
  for (long i = 0; i < frames; ++i) {
    if (i == nudge.frame) {
      Handle<Vector3> velocity = game.simulation->linked().handle(game.blue, kBodyVelocity);
      Vector3 v = velocity.get();
      v.y = nudge.velocity;
      velocity.set(v);
    }
    game.simulation->step();
  }
  EXPECT_EQ(recorder.finish(), "");
  return file;
}

bool hasNote(const Comparison& comparison, const std::string& words) {
  for (const std::string& note : comparison.notes) {
    if (note.find(words) != std::string::npos) return true;
  }
  return false;
}

TEST(Comparison, TwoRunsOfTheSameAreTheSame) {
  const test::Folder folder;
  const Comparison c = compareRuns(record(folder / "a", 300), record(folder / "b", 300));
  EXPECT_TRUE(c.equal) << c.text("a", "b");
  EXPECT_FALSE(c.first);
  EXPECT_EQ(c.compared, "300 frames");
  EXPECT_TRUE(c.notes.empty());
}

TEST(Comparison, NamesFrameObjectPropertyAndBothValuesOfTheFirstDifference) {
  const test::Folder folder;
  const Comparison c = compareRuns(record(folder / "a", 400), record(folder / "b", 400, 2, {123, 1e-300}));
  EXPECT_FALSE(c.equal);
  ASSERT_TRUE(c.first);
  EXPECT_EQ(c.first->frame, 123);
  EXPECT_NEAR(c.first->time, 0.124, 1e-12);
  EXPECT_EQ(c.first->object, "balls.blue");
  EXPECT_EQ(c.first->assembly, "balls.blue");
  EXPECT_NE(c.first->a, c.first->b);
  const std::string text = c.text("A", "B");
  EXPECT_NE(text.find("after frame 123 (t = 0.124 s) in balls.blue, "), std::string::npos) << text;
  EXPECT_NE(text.find("first:  A"), std::string::npos) << text;
}

TEST(Comparison, ShorterRunsAndMissingObjectsAreDifferences) {
  const test::Folder folder;
  const Comparison shorter = compareRuns(record(folder / "a", 100), record(folder / "b", 80));
  EXPECT_FALSE(shorter.equal);
  EXPECT_FALSE(shorter.first);
  EXPECT_TRUE(hasNote(shorter, "the second ends after frame 79 (t = 0.080 s)")) << shorter.text("a", "b");
  const Comparison fewer = compareRuns(record(folder / "a", 100), record(folder / "c", 100, 1));
  EXPECT_FALSE(fewer.equal);
  EXPECT_TRUE(hasNote(fewer, "only the first has body_velocity of balls.blue self (1 x 3)"));
  EXPECT_TRUE(hasNote(fewer, "interventions differ first in frame 0: balls.blue put at (0, -0.5)"));
  const Comparison more = compareRuns(folder / "c", folder / "a");
  EXPECT_TRUE(hasNote(more, "only the second has body_velocity of balls.blue self (1 x 3)"));
}

TEST(Comparison, ARunThatWasCutOffIsNoEqual) {
  const test::Folder folder;
  record(folder / "a", 100);
  const std::string whole = test::readBytes(folder / "a");
  test::writeBytes(folder / "b", whole.substr(0, whole.size() - 9));  // without its end
  const Comparison c = compareRuns(folder / "a", folder / "b");
  EXPECT_FALSE(c.equal);
  EXPECT_TRUE(hasNote(c, "the second was cut off"));
}

std::string report(const std::string& hashes, const std::string& last) {
  return R"({"state_hash": ")" + last + R"(", "state_hashes": [)" + hashes + "]}";
}

TEST(Comparison, OfReportsNamesTheFirstSecondThatDiffers) {
  const test::Folder folder;
  test::writeBytes(folder / "a.json", report(R"("1a", "2b", "3c")", "3c"));
  test::writeBytes(folder / "b.json", report(R"("1a", "2b", "3d")", "3d"));
  test::writeBytes(folder / "c.json", report(R"("1a", "2b")", "2b"));
  test::writeBytes(folder / "d.json", report(R"("1a", "2b", "3c")", "4d"));
  EXPECT_TRUE(compareRuns(folder / "a.json", folder / "a.json").equal);
  const Comparison differ = compareRuns(folder / "a.json", folder / "b.json");
  EXPECT_FALSE(differ.equal);
  EXPECT_TRUE(hasNote(differ, "between t = 2 s and t = 3 s: hashes \"3c\" and \"3d\"")) << differ.text("a", "b");
  EXPECT_TRUE(hasNote(compareRuns(folder / "a.json", folder / "c.json"), "they last 3 s and 2 s"));
  EXPECT_TRUE(hasNote(compareRuns(folder / "a.json", folder / "d.json"), "after the last full second"));
}

TEST(Comparison, OfAFolderTakesItsReport) {
  const test::Folder folder;
  std::filesystem::create_directories(folder / "out");
  test::writeBytes(folder / "out/report.json", report(R"("1a")", "1a"));
  test::writeBytes(folder / "a.json", report(R"("1a")", "1a"));
  EXPECT_TRUE(compareRuns(folder / "out", folder / "a.json").equal);
}

TEST(Comparison, SaysWhatAFileLacks) {
  const test::Folder folder;
  record(folder / "a.rec", 3);
  test::writeBytes(folder / "ok.json", report("", "1a"));
  const auto error = [&](const std::string& text) {
    test::writeBytes(folder / "b.json", text);
    return test::errorOf([&] { compareRuns(folder / "ok.json", folder / "b.json"); });
  };
  const std::string start = (folder / "b.json").string() + ": not a report that can be compared: ";
  EXPECT_EQ(error("no json"), start + "found no JSON");
  EXPECT_EQ(error("[1]"), start + "found no JSON object");
  EXPECT_EQ(error(R"({"state_hash": "1"})"), start + "it lacks the list state_hashes");
  EXPECT_EQ(error(R"({"state_hashes": []})"), start + "it lacks state_hash");
  EXPECT_NE(test::errorOf([&] { compareRuns(folder / "a.rec", folder / "ok.json"); }).find("is a recording"),
            std::string::npos);
  EXPECT_NE(test::errorOf([&] { compareRuns(folder / "ok.json", folder / "none"); }).find("No such file"),
            std::string::npos);
}

}  // namespace
}  // namespace murosimf
