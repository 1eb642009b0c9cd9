#include <gtest/gtest.h>

#include <cstring>

#include "murosimf/math/random.h"
#include "murosimf/simulation/recorder.h"
#include "murosimf/simulation/recording_reader.h"
#include "simulation/bouncing_balls.h"

namespace murosimf {
namespace {

/// The bits of all state variables, in the recording's order.
std::vector<double> stateOf(const LinkedWorld& linked) {
  std::vector<double> numbers;
  for (const Place& place : linked.places()) {
    linked.visitState(place, [&](const ColumnLayout&, int, int, double value) { numbers.push_back(value); });
  }
  return numbers;
}

/// Every frame's state as the simulation had it.
class Diary final : public FrameObserver {
 public:
  void afterFrame(Simulation& simulation) override { states.push_back(stateOf(simulation.linked())); }
  std::vector<std::vector<double>> states;
};

/// Records the two balls; the orange one is put back in frame 150.
void record(const std::filesystem::path& file, long frames, Diary* diary = nullptr) {
  test::BouncingBalls game;
  Recorder recorder(file, *game.simulation, "balls", 42);
  game.simulation->observe(&recorder);
  if (diary != nullptr) game.simulation->observe(diary);
  game.simulation->interventions().placeBody(150, game.orange, {0, 1, 0.5}, {0, 0, -0.0});
  game.run(frames);
  EXPECT_EQ(recorder.finish(), "");
}

TEST(Recording, HoldsEveryBitOfEveryFrame) {
  const test::Folder folder;
  Diary diary;
  record(folder / "a.rec", 600, &diary);
  RecordingReader reader(folder / "a.rec");
  EXPECT_EQ(reader.header().scenario, "balls");
  EXPECT_EQ(reader.header().seed, 42U);
  EXPECT_EQ(reader.header().frame_length, 0.001);
  for (std::size_t frame = 0; frame < 600; ++frame) {
    ASSERT_TRUE(reader.next());
    EXPECT_EQ(reader.frame(), static_cast<long>(frame));
    std::vector<double> numbers;
    for (const RecordedColumn& column : reader.header().columns) {
      for (const double x : reader.numbers(column)) numbers.push_back(x);
    }
    const std::vector<double>& truth = diary.states[frame];
    ASSERT_EQ(numbers.size(), truth.size());
    ASSERT_EQ(std::memcmp(numbers.data(), truth.data(), truth.size() * sizeof(double)), 0) << frame;
  }
  EXPECT_FALSE(reader.next());
  EXPECT_TRUE(reader.complete());
}

TEST(Recording, NamesAssembliesPropertiesUnitsAndMembers) {
  const test::Folder folder;
  record(folder / "a.rec", 1);
  const RecordingReader reader(folder / "a.rec");
  const RecordingHeader& header = reader.header();
  int found = 0;
  for (const RecordedColumn& column : header.columns) {
    if (column.property != kBodyVelocity.name) continue;
    const RecordedGroup& group = header.groupOf(column);
    EXPECT_EQ(column.unit, "m/s");
    EXPECT_EQ(column.components, 3U);
    EXPECT_EQ(group.subset, "self");
    ASSERT_EQ(group.members.size(), 1U);
    EXPECT_EQ(group.members[0], group.assembly);
    EXPECT_TRUE(group.assembly == "balls.orange" || group.assembly == "balls.blue");
    ++found;
  }
  EXPECT_EQ(found, 2);
}

TEST(Recording, TellsInterventionsInTheirFrame) {
  const test::Folder folder;
  record(folder / "a.rec", 200);
  RecordingReader reader(folder / "a.rec");
  std::vector<RecordedIntervention> all;
  while (reader.next()) {
    for (const RecordedIntervention& act : reader.interventions()) {
      EXPECT_EQ(act.frame, reader.frame());
      all.push_back(act);
    }
  }
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[0].object, "balls.blue");  // of one frame: in the order of paths
  EXPECT_EQ(all[0].velocity, (Vector3{1.5, 0, 0}));
  EXPECT_EQ(all[1].object, "balls.orange");
  EXPECT_EQ(all[2].frame, 150);
  EXPECT_EQ(all[2].pose, (PlanarPose{0, 1, 0}));
  EXPECT_EQ(all[2].height, 0.5);
}

TEST(Recording, OfAWorldAtRestTakesFewBytesAFrame) {
  const test::Folder folder;
  test::BouncingBalls game(1);
  Recorder recorder(folder / "a.rec", *game.simulation, "ball", 1);
  game.simulation->interventions().placeBody(1, game.orange, {0, 0, 0.07});
  game.simulation->observe(&recorder);
  game.run(9000);
  EXPECT_EQ(recorder.finish(), "");
  const auto size = std::filesystem::file_size(folder / "a.rec");
  EXPECT_LT(double(size) / 9000, 13 + 4 + 2 + 8 * 18 + 20);  // never more than all numbers
  RecordingReader reader(folder / "a.rec");
  while (reader.next()) {
  }
  EXPECT_TRUE(reader.complete());
  EXPECT_EQ(reader.frame(), 8999);
}

TEST(Recording, ThatCannotBeWrittenIsRefusedWithItsName) {
  const test::Folder folder;
  test::BouncingBalls game;
  const std::filesystem::path file = folder / "no" / "a.rec";
  const std::string error = test::errorOf([&] { Recorder recorder(file, *game.simulation, "balls", 1); });
  EXPECT_EQ(error, file.string() + ": cannot write the recording: No such file or directory");
}

TEST(Recording, OnAFullDiskIsReportedAtTheEnd) {
  test::BouncingBalls game;
  Recorder recorder("/dev/full", *game.simulation, "balls", 1);
  game.simulation->observe(&recorder);
  game.run(20000);  // several buffers
  EXPECT_EQ(recorder.finish(), "/dev/full: the recording is not complete: No space left on device");
}

/// Reads all of it; returns the error's words.
std::string readAll(const std::filesystem::path& file) {
  return test::errorOf([&] {
    RecordingReader reader(file);
    while (reader.next()) {
    }
  });
}

TEST(Recording, DamagedOnesAreRefusedWithTheirByteAndNeverCrash) {
  const test::Folder folder;
  record(folder / "a.rec", 40);
  const std::string whole = test::readBytes(folder / "a.rec");
  const RandomStream random(7, "mutations", 0);
  int refused = 0, trials = 0;
  for (std::uint64_t trial = 0; trial < 3000; ++trial) {
    std::string bytes = whole;
    const std::size_t place = random.bits(4 * trial) % bytes.size();
    bytes[place] = static_cast<char>(random.bits(4 * trial + 1));
    if (trial % 3 == 0) {  // a number of all ones
      for (std::size_t i = place; i < std::min(place + 4, bytes.size()); ++i) bytes[i] = '\xff';
    }
    test::writeBytes(folder / "b.rec", bytes);
    const std::string error = readAll(folder / "b.rec");
    ++trials;
    refused += error.empty() ? 0 : 1;
    if (error.empty()) continue;
    EXPECT_NE(error.find("b.rec: byte "), std::string::npos) << error;
    EXPECT_NE(error.find(", expected "), std::string::npos) << error;
  }
  EXPECT_GT(refused, 100);     // lengths, counts, kinds, frames
  EXPECT_LT(refused, trials);  // a changed number is another number
}

TEST(Recording, CutAnywhereIsRefusedOrToldToBeIncomplete) {
  const test::Folder folder;
  record(folder / "a.rec", 12);
  const std::string whole = test::readBytes(folder / "a.rec");
  for (std::size_t size = 0; size < whole.size(); ++size) {
    test::writeBytes(folder / "b.rec", whole.substr(0, size));
    bool complete = true;
    const std::string error = test::errorOf([&] {
      RecordingReader reader(folder / "b.rec");
      while (reader.next()) {
      }
      complete = reader.complete();
    });
    EXPECT_TRUE(!error.empty() || !complete) << size;
  }
}

TEST(Recording, OtherFilesAreNamedAsWhatTheyAre) {
  const test::Folder folder;
  test::writeBytes(folder / "a.txt", "this is no recording");
  EXPECT_EQ(readAll(folder / "a.txt"),
            (folder / "a.txt").string() + ": byte 0: found another kind of file, expected a recording of murosimf");
  EXPECT_EQ(readAll(folder / "none"), (folder / "none").string() + ": cannot be read: no such file");
  EXPECT_EQ(readAll(std::filesystem::temp_directory_path()),
            std::filesystem::temp_directory_path().string() + ": cannot be read: not a file");
}

}  // namespace
}  // namespace murosimf
