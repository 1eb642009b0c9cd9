#include "murosimf/simulation/checkpoint.h"

#include <gtest/gtest.h>

#include "murosimf/math/random.h"
#include "murosimf/simulation/comparison.h"
#include "murosimf/simulation/recorder.h"
#include "simulation/bouncing_balls.h"

namespace murosimf {
namespace {

/// Counts frames, and keeps the count in checkpoints: an observer with state, like a referee.
class Counter final : public FrameObserver {
 public:
  void afterFrame(Simulation&) override { ++count; }
  void archive(StateArchive& archive) override { archive(count); }
  long count = 0;
};

TEST(Checkpoint, AContinuedRunIsTheSameRun) {
  const test::Folder folder;
  test::BouncingBalls whole;
  Counter whole_count;
  Recorder whole_recorder(folder / "whole", *whole.simulation, "balls", 1);
  whole.simulation->observe(&whole_count);
  whole.simulation->observe(&whole_recorder);
  // Something that still waits when the checkpoint is made.
  whole.simulation->interventions().placeBody(700, whole.orange, {0, 1, 0.5}, {0, -1, 0});
  whole.run(500);
  saveCheckpoint(folder / "half", *whole.simulation, "balls");
  whole.run(500);

  test::BouncingBalls second;
  Counter second_count;
  Recorder second_recorder(folder / "second", *second.simulation, "balls", 1);
  second.simulation->observe(&second_count);
  second.simulation->observe(&second_recorder);
  loadCheckpoint(folder / "half", *second.simulation);
  EXPECT_EQ(second.simulation->frame(), 500);
  second.run(500);

  EXPECT_EQ(second.simulation->stateHash(), whole.simulation->stateHash());
  EXPECT_EQ(second_count.count, 1000);
  EXPECT_EQ(whole_recorder.finish() + second_recorder.finish(), "");
  const Comparison c = compareRecordings(folder / "whole", folder / "second");
  EXPECT_TRUE(c.equal) << c.text("whole", "second");
  EXPECT_EQ(c.compared, "500 frames");
}

TEST(Checkpoint, WithoutContactsThatWereKeptTheRunWouldBeAnother) {
  // The test above can fail: placing the balls where they are is not enough to continue.
  test::BouncingBalls whole, second;
  whole.run(500);
  second.run(1);
  for (const ObjectId ball : {whole.orange, whole.blue}) {
    LinkedWorld &from = whole.simulation->linked(), &to = second.simulation->linked();
    to.handle(ball, kBasePose).set(from.handle(ball, kBasePose).get());
    to.handle(ball, kBodyVelocity).set(from.handle(ball, kBodyVelocity).get());
  }
  whole.run(499), second.run(499);
  EXPECT_NE(second.simulation->stateHash(), whole.simulation->stateHash());
}

TEST(Checkpoint, AtTheStartIsTheStart) {
  const test::Folder folder;
  test::BouncingBalls a, b;
  saveCheckpoint(folder / "start", *a.simulation, "balls");
  loadCheckpoint(folder / "start", *b.simulation);
  a.run(300), b.run(300);
  EXPECT_EQ(a.simulation->stateHash(), b.simulation->stateHash());
}

TEST(Checkpoint, OfAnotherWorldIsRefusedByTheFirstLineThatDiffers) {
  const test::Folder folder;
  test::BouncingBalls two, one(1);
  two.run(30);
  saveCheckpoint(folder / "two", *two.simulation, "two_balls.toml");
  const std::uint64_t before = one.simulation->stateHash();
  const std::string error = test::errorOf([&] { loadCheckpoint(folder / "two", *one.simulation); });
  EXPECT_NE(error.find("a checkpoint of two_balls.toml at t = 0.030 s does not fit: found balls.blue self"),
            std::string::npos)
      << error;
  EXPECT_NE(error.find("expected balls.orange self"), std::string::npos) << error;
  EXPECT_EQ(one.simulation->stateHash(), before);
  EXPECT_EQ(one.simulation->frame(), 0);
}

TEST(Checkpoint, WithOtherObserversIsRefused) {
  const test::Folder folder;
  test::BouncingBalls counted, plain;
  Counter count;
  counted.simulation->observe(&count);
  saveCheckpoint(folder / "counted", *counted.simulation, "balls");
  const std::string error = test::errorOf([&] { loadCheckpoint(folder / "counted", *plain.simulation); });
  EXPECT_NE(error.find("kept other state: more state was saved than is needed"), std::string::npos) << error;
  saveCheckpoint(folder / "plain", *test::BouncingBalls().simulation, "balls");
  const std::string other = test::errorOf([&] { loadCheckpoint(folder / "plain", *counted.simulation); });
  EXPECT_NE(other.find("kept other state: state archive: data ends too early"), std::string::npos) << other;
}

TEST(Checkpoint, DamagedOnesAreRefusedWithTheirByteAndNeverCrash) {
  const test::Folder folder;
  test::BouncingBalls game;
  game.run(100);
  saveCheckpoint(folder / "a", *game.simulation, "balls");
  const std::string whole = test::readBytes(folder / "a");
  const RandomStream random(3, "mutations", 0);
  const std::size_t scenario_end = 8 + 4 + 4 + 5, frame_end = scenario_end + 8;
  for (std::uint64_t trial = 0; trial < 600; ++trial) {
    std::string bytes = whole;
    const std::size_t place = random.bits(2 * trial) % bytes.size();
    bytes[place] = static_cast<char>(bytes[place] ^ static_cast<char>(1 + random.bits(2 * trial + 1) % 255));
    if (trial % 4 == 0) bytes.resize(place);  // cut off
    test::writeBytes(folder / "b", bytes);
    test::BouncingBalls fresh(1);
    const std::string error = test::errorOf([&] { loadCheckpoint(folder / "b", *fresh.simulation); });
    // Names and the time are for people: any are as good as others.
    const bool only_words = place >= 16 && place < frame_end + 8 && trial % 4 != 0;
    const bool fits_not = error.find("does not fit") != std::string::npos;  // fresh has one ball alone
    EXPECT_TRUE(error.find("b: byte ") != std::string::npos || (only_words && fits_not)) << place << ": " << error;
  }
}

TEST(Checkpoint, IsWrittenWholeOrNotAtAll) {
  const test::Folder folder;
  test::BouncingBalls game;
  const std::string error = test::errorOf([&] { saveCheckpoint(folder / "no/a", *game.simulation, "balls"); });
  EXPECT_NE(error.find("no/a: cannot write the checkpoint: No such file"), std::string::npos) << error;
  saveCheckpoint(folder / "a", *game.simulation, "balls");
  EXPECT_FALSE(std::filesystem::exists(folder / "a.part"));
  test::writeBytes(folder / "text", "not a checkpoint");
  const std::string other = test::errorOf([&] { loadCheckpoint(folder / "text", *game.simulation); });
  EXPECT_NE(other.find("text: byte 0: found another kind of file, expected a checkpoint"), std::string::npos) << other;
}

}  // namespace
}  // namespace murosimf
