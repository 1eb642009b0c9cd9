#include "murosimf/simulation/recorder.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace murosimf {

namespace {

constexpr std::size_t kBufferSize = std::size_t{1} << 20;

}  // namespace

Recorder::Recorder(const std::filesystem::path& file, const Simulation& simulation, const std::string& scenario,
                   std::uint64_t seed)
    : file_(file), header_(describeState(simulation.world(), simulation.linked())) {
  stream_.reset(std::fopen(file.c_str(), "wb"));
  if (stream_ == nullptr) {
    throw std::runtime_error(fmt::format("{}: cannot write the recording: {}", file.string(), std::strerror(errno)));
  }
  header_.scenario = scenario;
  header_.seed = seed;
  last_.resize(header_.numberCount());
  now_.resize(header_.numberCount());
  bytes_.reserve(2 * kBufferSize);
}

Recorder::~Recorder() { finish(); }

void Recorder::begin(const Simulation& simulation) {
  begun_ = true;
  header_.first_frame = simulation.frame() - 1;
  writeHeader();
}

void Recorder::writeHeader() {
  bytes_.raw(kRecordingMagic);
  bytes_.u32(kRecordingVersion);
  bytes_.text(header_.scenario);
  bytes_.u64(header_.seed);
  bytes_.f64(header_.frame_length);
  bytes_.u64(static_cast<std::uint64_t>(header_.first_frame));
  bytes_.u32(static_cast<std::uint32_t>(header_.groups.size()));
  for (const RecordedGroup& group : header_.groups) {
    bytes_.text(group.assembly);
    bytes_.text(group.subset);
    bytes_.u32(static_cast<std::uint32_t>(group.members.size()));
    for (const std::string& member : group.members) bytes_.text(member);
  }
  bytes_.u32(static_cast<std::uint32_t>(header_.columns.size()));
  for (const RecordedColumn& column : header_.columns) {
    bytes_.u32(column.group);
    bytes_.text(column.property);
    bytes_.text(column.unit);
    bytes_.u32(column.components);
  }
}

void Recorder::afterFrame(Simulation& simulation) {
  if (stream_ == nullptr) return;
  if (!begun_) begin(simulation);
  const long frame = simulation.frame() - 1;
  std::size_t i = 0;
  const LinkedWorld& linked = simulation.linked();
  for (const Resident& resident : linked.residents()) {
    linked.visitAllLevels(resident, [&](const ColumnLayout&, int, int, double value) {
      now_[i++] = __builtin_bit_cast(std::uint64_t, value);
    });
  }
  writeInterventions(simulation, frame);
  writeFrame(frame);
  if (bytes_.size() >= kBufferSize) flush();
}

void Recorder::writeInterventions(const Simulation& simulation, long frame) {
  for (const InterventionQueue::Logged& applied : simulation.interventions().applied()) {
    const Intervention& act = applied.intervention;
    bytes_.u8('I');
    bytes_.u64(static_cast<std::uint64_t>(frame));
    bytes_.u8(static_cast<std::uint8_t>(act.kind));
    bytes_.text(simulation.world().path(act.object));
    for (const double x : {act.pose.x, act.pose.y, act.pose.heading, act.height, act.velocity.x, act.velocity.y,
                           act.velocity.z, static_cast<double>(act.level)}) {
      bytes_.f64(x);
    }
  }
}

void Recorder::writeFrame(long frame) {
  bytes_.u8('F');
  bytes_.u64(static_cast<std::uint64_t>(frame));
  const std::size_t count_place = bytes_.size();
  bytes_.u32(0);
  std::uint32_t changed = 0;
  for (std::uint32_t c = 0; c < header_.columns.size(); ++c) changed += writeColumn(c) ? 1U : 0U;
  bytes_.setU32(count_place, changed);
  last_.swap(now_);
  ++frames_;
}

/// Adds the numbers of a column that changed; nothing when none did.
bool Recorder::writeColumn(std::uint32_t column) {
  const std::size_t first = header_.columns[column].first, size = header_.sizeOf(header_.columns[column]);
  const std::uint64_t *now = now_.data() + first, *last = last_.data() + first;
  if (std::memcmp(now, last, size * sizeof(std::uint64_t)) == 0) return false;
  bytes_.u32(column);
  for (std::size_t byte = 0; byte < size; byte += 8) {
    unsigned mask = 0;
    for (std::size_t i = byte; i < size && i < byte + 8; ++i) mask |= (now[i] != last[i] ? 1U : 0U) << (i - byte);
    bytes_.u8(static_cast<std::uint8_t>(mask));
  }
  for (std::size_t i = 0; i < size; ++i) {
    if (now[i] != last[i]) bytes_.u64(now[i]);
  }
  return true;
}

void Recorder::flush() {
  if (stream_ != nullptr && error_.empty() &&
      std::fwrite(bytes_.bytes().data(), 1, bytes_.size(), stream_.get()) != bytes_.size()) {
    error_ = fmt::format("{}: the recording is not complete: {}", file_.string(), std::strerror(errno));
  }
  bytes_.clear();
}

std::string Recorder::finish() {
  if (stream_ == nullptr) return error_;
  if (!begun_) writeHeader();
  bytes_.u8('E');
  bytes_.u64(frames_);
  flush();
  if (std::fclose(stream_.release()) != 0 && error_.empty()) {
    error_ = fmt::format("{}: the recording is not complete: {}", file_.string(), std::strerror(errno));
  }
  return error_;
}

}  // namespace murosimf
