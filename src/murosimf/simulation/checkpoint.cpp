#include "murosimf/simulation/checkpoint.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>

#include "murosimf/math/random.h"
#include "murosimf/simulation/byte_source.h"
#include "murosimf/simulation/byte_writer.h"

namespace murosimf {

namespace {

constexpr std::string_view kMagic = "MUROCKPT";
constexpr std::uint32_t kVersion = 3;

/// Hash of bytes, eight at a time.
std::uint64_t hashBytes(std::span<const std::byte> bytes) {
  std::uint64_t hash = mixBits(bytes.size());
  for (std::size_t i = 0; i < bytes.size(); i += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data() + i, std::min<std::size_t>(8, bytes.size() - i));
    hash = mixBits(hash ^ word);
  }
  return hash;
}

std::uint64_t hashLines(const std::vector<std::string>& lines) {
  std::uint64_t hash = 0;
  for (const std::string& line : lines) hash = mixBits(hash ^ hashName(line));
  return hash;
}

/// What stands in front of the state.
struct Head {
  std::string scenario;
  std::uint64_t frame = 0, structure_hash = 0;
  double frame_length = 0;
  std::vector<std::string> structure;
};

Head readHead(ByteSource& source) {
  const std::span<const std::uint8_t> magic = source.bytes(kMagic.size(), "a checkpoint's first bytes");
  if (std::memcmp(magic.data(), kMagic.data(), magic.size()) != 0) {
    source.fail("another kind of file", "a checkpoint of murosimf");
  }
  const std::uint32_t version = source.u32("the checkpoint's version");
  if (version != kVersion) source.fail(fmt::format("version {}", version), fmt::format("version {}", kVersion));
  Head head;
  head.scenario = source.text("the scenario's name");
  head.frame = source.u64("the frame");
  head.frame_length = source.f64("the frame's length");
  head.structure_hash = source.u64("the structure's hash");
  const std::uint32_t lines = source.count("lines of structure", 4, 1U << 20);
  for (std::uint32_t i = 0; i < lines; ++i) head.structure.push_back(source.text("a line of structure"));
  if (hashLines(head.structure) != head.structure_hash) source.fail("a damaged list", "the structure that was saved");
  return head;
}

std::vector<std::byte> readState(ByteSource& source) {
  const std::uint64_t hash = source.u64("the state's hash"), size = source.u64("the size of the state");
  if (size != source.remaining()) {
    source.fail(fmt::format("{} bytes of state", source.remaining()), fmt::format("{}", size));
  }
  const std::span<const std::uint8_t> bytes = source.bytes(size, "state");
  std::vector<std::byte> state(size);
  std::memcpy(state.data(), bytes.data(), size);
  if (hashBytes(state) != hash) source.fail("damaged state", "the state that was saved");
  return state;
}

/// @throws naming the first line in which the structures differ
void checkStructure(const ByteSource& source, const Head& head, const Simulation& simulation) {
  const std::vector<std::string> here = structureOf(simulation);
  const double frame_length = simulation.frameLength();
  const std::string saved_by =
      fmt::format("{}: a checkpoint of {} at t = {:.3f} s does not fit", source.file().string(), head.scenario,
                  static_cast<double>(head.frame) * head.frame_length);
  if (head.frame_length != frame_length) {
    throw std::runtime_error(
        fmt::format("{}: found frames of {} s, expected {} s", saved_by, head.frame_length, frame_length));
  }
  std::size_t i = 0;
  while (i < here.size() && i < head.structure.size() && here[i] == head.structure[i]) ++i;
  if (i == here.size() && i == head.structure.size()) return;
  const std::string found = i < head.structure.size() ? head.structure[i] : "nothing more";
  const std::string expected = i < here.size() ? here[i] : "nothing more";
  throw std::runtime_error(fmt::format("{}: found {}, expected {}", saved_by, found, expected));
}

void writeFile(const std::filesystem::path& file, const ByteWriter& head, const std::vector<std::byte>& state) {
  // Under another name first, so that an earlier checkpoint stays whole until this one is.
  std::filesystem::path part = file;
  part += ".part";
  std::ofstream stream(part, std::ios::binary);
  stream.write(reinterpret_cast<const char*>(head.bytes().data()), static_cast<std::streamsize>(head.size()));
  stream.write(reinterpret_cast<const char*>(state.data()), static_cast<std::streamsize>(state.size()));
  stream.close();
  std::error_code error;
  if (stream) std::filesystem::rename(part, file, error);
  if (stream && !error) return;
  const std::string reason = error ? error.message() : std::strerror(errno);
  std::filesystem::remove(part, error);
  throw std::runtime_error(fmt::format("{}: cannot write the checkpoint: {}", file.string(), reason));
}

}  // namespace

std::vector<std::string> structureOf(const Simulation& simulation) {
  std::vector<std::string> lines;
  const World& world = simulation.world();
  for (const Resident& resident : simulation.linked().residents()) {
    for (const LevelSeat& seat : resident.levels) {
      for (const ColumnLayout& layout : simulation.linked().batches()[static_cast<std::size_t>(seat.batch)].columns) {
        if (layout.ref.memory != MemoryKind::kState || layout.storage == Storage::kOnDemand) continue;
        lines.push_back(fmt::format("{} {} {} {} x {}", world.path(resident.assembly), layout.subset, layout.property,
                                    layout.objects, layout.components));
      }
    }
  }
  const ControlLoop* control = simulation.control();
  for (int i = 0; control != nullptr && i < control->robotCount(); ++i) {
    const ControlledRobot& robot = control->robot(i);
    if (robot.program != nullptr) lines.push_back(world.path(robot.port.robot()) + " control software");
  }
  return lines;
}

void saveCheckpoint(const std::filesystem::path& file, Simulation& simulation, const std::string& scenario) {
  simulation.start();
  StateArchive archive;
  simulation.archive(archive);
  const std::vector<std::string> structure = structureOf(simulation);
  ByteWriter head;
  head.raw(kMagic);
  head.u32(kVersion);
  head.text(scenario);
  head.u64(static_cast<std::uint64_t>(simulation.frame()));
  head.f64(simulation.frameLength());
  head.u64(hashLines(structure));
  head.u32(static_cast<std::uint32_t>(structure.size()));
  for (const std::string& line : structure) head.text(line);
  head.u64(hashBytes(archive.bytes()));
  head.u64(archive.bytes().size());
  writeFile(file, head, archive.bytes());
}

void loadCheckpoint(const std::filesystem::path& file, Simulation& simulation) {
  ByteSource source(file);
  const Head head = readHead(source);
  StateArchive archive(readState(source));
  checkStructure(source, head, simulation);
  simulation.start();
  std::string trouble;
  try {
    simulation.archive(archive);
    if (!archive.exhausted()) trouble = "more state was saved than is needed";
  } catch (const std::exception& problem) {
    trouble = problem.what();
  }
  if (!trouble.empty()) {
    throw std::runtime_error(fmt::format("{}: a checkpoint of {}: its programs or observers kept other state: {}",
                                         file.string(), head.scenario, trouble));
  }
}

}  // namespace murosimf
