#include "murosimf/simulation/recording_reader.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstring>

namespace murosimf {

namespace {

// What no recording comes near; a damaged one must not make us take all memory.
constexpr std::uint64_t kMostComponents = 4096, kMostNumbers = std::uint64_t{1} << 24;
constexpr std::uint64_t kMostGroups = 1U << 20, kMostFrame = std::uint64_t{1} << 53;

}  // namespace

RecordingReader::RecordingReader(const std::filesystem::path& file) : source_(file) {
  const std::span<const std::uint8_t> magic = source_.bytes(kRecordingMagic.size(), "a recording's first bytes");
  if (std::memcmp(magic.data(), kRecordingMagic.data(), magic.size()) != 0) {
    source_.fail("another kind of file", "a recording of murosimf");
  }
  const std::uint32_t version = source_.u32("the recording's version");
  if (version != kRecordingVersion) {
    source_.fail(fmt::format("version {}", version), fmt::format("version {}", kRecordingVersion));
  }
  header_.scenario = source_.text("the scenario's name");
  header_.seed = source_.u64("the seed");
  header_.frame_length = source_.f64("the frame's length");
  if (!(header_.frame_length > 0) || !std::isfinite(header_.frame_length)) {
    source_.fail(fmt::format("{}", header_.frame_length), "a frame's length above 0");
  }
  const std::uint64_t first = source_.u64("the first frame");
  if (first > kMostFrame) source_.fail(fmt::format("frame {}", first), "the number of the first frame");
  header_.first_frame = static_cast<long>(first);
  frame_ = header_.first_frame - 1;
  readGroups();
  readColumns();
  numbers_.resize(header_.numberCount());
}

void RecordingReader::readGroups() {
  const std::uint32_t groups = source_.count("groups of objects", 12, kMostGroups);
  for (std::uint32_t i = 0; i < groups; ++i) {
    RecordedGroup group;
    group.assembly = source_.text("an assembly's path");
    group.subset = source_.text("a subset's name");
    const std::uint32_t members = source_.count("members of a subset", 4, kMostNumbers);
    for (std::uint32_t m = 0; m < members; ++m) group.members.push_back(source_.text("an object's path"));
    header_.groups.push_back(std::move(group));
  }
}

void RecordingReader::readColumns() {
  const std::uint32_t columns = source_.count("columns", 16, kMostNumbers);
  for (std::uint32_t i = 0; i < columns; ++i) {
    RecordedColumn column;
    column.group = source_.u32("a column's group");
    if (column.group >= header_.groups.size()) {
      source_.fail(fmt::format("group {}", column.group), fmt::format("one of {} groups", header_.groups.size()));
    }
    column.property = source_.text("a property's name");
    column.unit = source_.text("a property's unit");
    column.components = source_.count("numbers an object", 1, kMostComponents);
    column.first = header_.numberCount();
    header_.columns.push_back(std::move(column));
    if (header_.numberCount() > kMostNumbers) {
      source_.fail(fmt::format("{} numbers a frame", header_.numberCount()), fmt::format("at most {}", kMostNumbers));
    }
  }
}

bool RecordingReader::next() {
  interventions_.clear();
  while (!source_.atEnd() && !complete_) {
    const std::uint8_t kind = source_.u8("a record");
    if (kind == 'I') {
      readIntervention();
    } else if (kind == 'F') {
      readFrame();
      return true;
    } else if (kind == 'E') {
      readEnd();
    } else {
      source_.fail(fmt::format("a record of kind {}", kind), "'F', 'I' or 'E'");
    }
  }
  return false;
}

void RecordingReader::readFrame() {
  const std::uint64_t frame = source_.u64("a frame's number");
  if (frame != static_cast<std::uint64_t>(frame_ + 1)) {
    source_.fail(fmt::format("frame {}", frame), fmt::format("frame {}", frame_ + 1));
  }
  const std::uint32_t changed = source_.count("changed columns", 6, header_.columns.size());
  for (std::uint32_t i = 0; i < changed; ++i) readColumn();
  ++frame_;
  ++frames_;
}

void RecordingReader::readColumn() {
  const std::uint32_t index = source_.u32("a column");
  if (index >= header_.columns.size()) {
    source_.fail(fmt::format("column {}", index), fmt::format("one of {} columns", header_.columns.size()));
  }
  const RecordedColumn& column = header_.columns[index];
  const std::size_t size = header_.sizeOf(column);
  const std::span<const std::uint8_t> bits = source_.bytes((size + 7) / 8, "marks of changed numbers");
  const std::vector<std::uint8_t> mask(bits.begin(), bits.end());
  for (std::size_t i = 0; i < 8 * mask.size(); ++i) {
    if ((mask[i / 8] >> (i % 8) & 1) == 0) continue;
    if (i >= size) source_.fail(fmt::format("number {} of {}", i, column.property), fmt::format("{} numbers", size));
    numbers_[column.first + i] = source_.f64("a number");
  }
}

void RecordingReader::readIntervention() {
  RecordedIntervention act;
  const std::uint64_t frame = source_.u64("the frame of an intervention");
  if (frame != static_cast<std::uint64_t>(frame_ + 1)) {
    source_.fail(fmt::format("an intervention in frame {}", frame), fmt::format("one in frame {}", frame_ + 1));
  }
  act.frame = static_cast<long>(frame);
  const std::uint8_t kind = source_.u8("the kind of an intervention");
  if (kind > static_cast<std::uint8_t>(Intervention::Kind::kPush)) {
    source_.fail(fmt::format("an intervention of kind {}", kind), "0 (robot), 1 (body), 2 (level) or 3 (push)");
  }
  act.kind = static_cast<Intervention::Kind>(kind);
  act.object = source_.text("the object of an intervention");
  double x[8];
  for (double& number : x) number = source_.f64("a number of an intervention");
  act.pose = {x[0], x[1], x[2]};
  act.height = x[3];
  act.velocity = {x[4], x[5], x[6]};
  act.level = static_cast<int>(x[7]);
  interventions_.push_back(std::move(act));
}

void RecordingReader::readEnd() {
  const std::uint64_t frames = source_.u64("the count of frames");
  if (frames != frames_) source_.fail(fmt::format("{} frames", frames), fmt::format("{} frames", frames_));
  if (!source_.atEnd()) source_.fail(fmt::format("{} bytes after the end", source_.remaining()), "nothing");
  complete_ = true;
}

}  // namespace murosimf
