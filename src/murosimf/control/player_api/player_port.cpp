#include "murosimf/control/player_api/player_port.h"

#include <fmt/format.h>
#include <google/protobuf/stubs/common.h>

#include <chrono>
#include <cmath>
#include <limits>

#include "murosimf/control/player_api/measurement_writer.h"
#include "murosimf/control/player_api/player_api.pb.h"
#include "murosimf/control/player_api/surroundings.h"

namespace murosimf::player_api {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kMostSentBytes = 32 << 20;

double secondsNow() { return std::chrono::duration<double>(Clock::now().time_since_epoch()).count(); }
Clock::time_point after(double seconds) {
  return Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}
std::uint64_t unixMilliseconds() {
  const auto since = std::chrono::system_clock::now().time_since_epoch();
  return static_cast<std::uint64_t>(std::chrono::duration_cast<std::chrono::milliseconds>(since).count());
}

/// Eight bytes, the last one 0.
std::string greeting(const char* word) { return std::string(word) + '\0'; }

std::vector<PictureSize> pictureSizes(const client::RobotDescription& robot) {
  std::vector<PictureSize> sizes;
  for (const client::CameraDescription& camera : robot.cameras) sizes.push_back({camera.width, camera.height});
  return sizes;
}

}  // namespace

/// What is known when the robot is.
struct PlayerPort::Parts {
  DeviceBook devices;
  MotorTable motors;
  SensorSchedule sensors;
  RequestReader reader;
  SensorMeasurements out;  // kept, with the memory of its pictures
  Parts(const client::RobotDescription& robot, long period, double rendering_quota)
      : devices(robot.devices),
        motors(robot.joints),
        sensors(devices, pictureSizes(robot), static_cast<int>(period), rendering_quota),
        reader(devices, motors, sensors) {}
};

int usualPort(const client::RobotDescription& robot) { return (robot.team == "red" ? 10000 : 10020) + robot.number; }

PlayerPort::PlayerPort(std::shared_ptr<FrameServer> server, const PlayerPortSettings& settings)
    : server_(std::move(server)),
      settings_(settings),
      open_(std::make_shared<std::atomic<bool>>(true)),
      budget_(settings.delay),
      network_(settings.network_quota) {
  google::protobuf::SetLogHandler(nullptr);  // what is wrong with a client's bytes the client is told, nobody else
}

PlayerPort::~PlayerPort() {
  *open_ = false;
  if (channel_ != nullptr) channel_->disconnect();
}

void PlayerPort::start(const client::RobotDescription& robot) {
  robot_ = robot;
  const double period = robot.control_period * 1000;
  period_ = std::lround(period);
  if (period_ < 1 || std::abs(period - static_cast<double>(period_)) > 1e-6)
    throw client::CannotStart(fmt::format(
        "the player API counts whole milliseconds, simulation.control_period is {} ms; expected 8 ms or the like",
        period));
  parts_ = std::make_unique<Parts>(robot_, period_, settings_.rendering_quota);
  listen();
}

void PlayerPort::listen() {
  ChannelLimits limits;
  limits.most_sent_bytes = kMostSentBytes;
  channel_ = std::make_shared<FrameChannel>(limits);
  FramePort port;
  port.host = settings_.host;
  port.port = settings_.port;
  port.allowed = settings_.allowed;
  port.backlog = 1;
  port.welcome = greeting("Welcome"), port.refusal = greeting("Refused");
  port.free_channel = [channel = channel_, open = open_]() -> std::shared_ptr<FrameChannel> {
    return *open && !channel->isConnected() ? channel : nullptr;
  };
  try {
    port_ = server_->listen(std::move(port));
  } catch (const std::exception& problem) {
    throw client::CannotStart(problem.what());
  }
}

/// Requests that come before the first step count as if they had come a period before it. A client that asks for
/// surroundings is told at once what robot it has, and may ask again.
void PlayerPort::awaitClient() {
  if (!channel_->waitForClient(after(settings_.connect_wait))) return;
  const double patience = settings_.delay.patience + settings_.delay.budget;
  if (!channel_->waitForFrame(after(patience))) return;
  obey(*channel_->receive(), 0);
  if (!wants_surroundings_) return;
  connection_ = channel_->connection();
  beginMessage(0);
  introduce();
  channel_->send(written());
  if (channel_->waitForFrame(after(patience))) obey(*channel_->receive(), 0);
}

void PlayerPort::startCameras(std::span<double> periods) {
  if (settings_.lock_step) awaitClient();
  parts_->sensors.camerasChanged();
  tellCameras(periods);
}

/// All cameras that the client has not turned on are off.
void PlayerPort::tellCameras(std::span<double> periods) const {
  std::fill(periods.begin(), periods.end(), 0.0);
  for (int i = 0; i < parts_->devices.count(); ++i) {
    if (parts_->devices.isCamera(i))
      periods[static_cast<std::size_t>(parts_->devices.device(i).part)] =
          static_cast<double>(parts_->sensors.period(i)) * 1e-3;
  }
}

void PlayerPort::step(const client::SensorFrame& sensors, client::CommandFrame& commands) {
  const long time = std::lround(sensors.time * 1000);
  if (!settings_.lock_step) obeyAll(time);
  heedReferee(sensors.game);
  sendMeasurements(sensors, time);
  if (settings_.lock_step) awaitAnswer(time, time + period_);
  parts_->motors.fill(sensors.joints, sensors.game.penalised || sensors.game.sent_off, commands.joints);
  if (parts_->sensors.camerasChanged()) tellCameras(commands.camera_periods);
  commands.message = team_message_.value_or(client::TeamMessage{});
  team_message_.reset();
}

void PlayerPort::obeyAll(long now) {
  for (std::size_t i = 0; i < channel_->limits().most_received; ++i) {
    const std::optional<FrameBytes> frame = channel_->receive();
    if (!frame) return;
    obey(*frame, now);
  }
}

void PlayerPort::obey(const FrameBytes& frame, long now) {
  if (sent_off_) return;
  RequestNotes notes = parts_->reader.read(frame, now, warnings_);
  wants_surroundings_ = wants_surroundings_ || notes.wants_surroundings;
  if (notes.team_message) team_message_ = notes.team_message;
  if (notes.answers) answered_ = *notes.answers;
}

/// @param asked  time of the measurements that were sent, @param now  from when on requests act [ms]
void PlayerPort::awaitAnswer(long asked, long now) {
  if (!channel_->isConnected()) return;
  const double begun = secondsNow();
  const Clock::time_point until = after(budget_.allowance(begun));
  bool answered = false;
  while (!answered && channel_->waitForFrame(until)) answered = takeAnswer(asked, now);
  const double ended = secondsNow();
  if (answered) {
    budget_.answered(ended, ended - begun);
  } else if (channel_->isConnected() && !budget_.isLost()) {
    budget_.missed(ended, ended - begun);
  }
}

/// @returns whether it was the answer that is waited for: the next message, unless the client says what it answers
bool PlayerPort::takeAnswer(long asked, long now) {
  answered_.reset();
  if (const std::optional<FrameBytes> frame = channel_->receive()) obey(*frame, now);
  return !answered_ || *answered_ >= asked;
}

void PlayerPort::heedReferee(const client::GameInfo& game) {
  if (game.sent_off && !sent_off_) parts_->sensors.turnAllOff();
  sent_off_ = game.sent_off;
}

/// A message without measurements.
void PlayerPort::beginMessage(long now) {
  SensorMeasurements& out = parts_->out;
  out.Clear();
  out.set_time(static_cast<std::uint32_t>(now));
  out.set_real_time(unixMilliseconds());
}

void PlayerPort::addMessage(bool error, const std::string& text) {
  Message& message = *parts_->out.add_messages();
  message.set_message_type(error ? Message::ERROR_MESSAGE : Message::WARNING_MESSAGE);
  message.set_text(text);
}

void PlayerPort::measure(const client::SensorFrame& sensors, long now) {
  beginMessage(now);
  for (const std::string& warning : warnings_) addMessage(false, warning);
  warning_count_ += static_cast<long>(warnings_.size());
  warnings_.clear();
  SensorMeasurements& out = parts_->out;
  if (!sent_off_) writeMeasurements(parts_->devices, parts_->sensors, sensors, now, wants_surroundings_, out);
  if (!wants_surroundings_) return;
  writeSurroundings(sensors, robot_, *out.mutable_surroundings());
  if (!described_) introduce();
}

void PlayerPort::introduce() {
  parts_->out.mutable_surroundings()->mutable_description()->set_cbor(describeInCbor(robot_));
  described_ = true;
}

/// The message as it leaves.
FrameBytes PlayerPort::written() {
  FrameBytes bytes = channel_->spare();  // a message with pictures has a megabyte, and is made 20 times a second
  bytes.resize(parts_->out.ByteSizeLong());
  parts_->out.SerializeToArray(bytes.data(), static_cast<int>(bytes.size()));
  return bytes;
}

void PlayerPort::sendMeasurements(const client::SensorFrame& sensors, long time) {
  const long connection = channel_->connection();
  if (!channel_->isConnected()) return warnings_.clear();
  described_ = described_ && connection == connection_;
  connection_ = connection;
  measure(sensors, time);
  const double second = robot_.paced ? secondsNow() : sensors.time;
  if (!network_.allows(second, parts_->out.ByteSizeLong())) {
    beginMessage(time);
    addMessage(true, fmt::format("{:g} MB/s is all that may be sent to a robot, more was asked for", network_.quota()));
  }
  FrameBytes bytes = written();
  network_.count(second, bytes.size());
  channel_->send(std::move(bytes));
}

std::string PlayerPort::address() const {
  return settings_.port == 0 ? settings_.host : fmt::format("{}:{}", settings_.host, settings_.port);
}

std::vector<std::pair<std::string, double>> PlayerPort::figures() const {
  const PlayerPortCounts c = counts();
  return {{"connections", static_cast<double>(c.channel.connections)},
          {"messages_sent", static_cast<double>(c.channel.sent)},
          {"bytes_sent", static_cast<double>(c.channel.bytes_sent)},
          {"messages_dropped", static_cast<double>(c.channel.dropped)},
          {"messages_received", static_cast<double>(c.channel.received)},
          {"bytes_received", static_cast<double>(c.channel.bytes_received)},
          {"missed_answers", static_cast<double>(c.missed_answers)},
          {"warnings", static_cast<double>(c.warnings)}};
}

PlayerPortCounts PlayerPort::counts() const {
  return {channel_ == nullptr ? ChannelCounts{} : channel_->counts(), budget_.misses(), warning_count_};
}

void PlayerPort::archive(client::StateArchive& archive) { archive(parts_->motors, parts_->sensors, sent_off_); }

}  // namespace murosimf::player_api
