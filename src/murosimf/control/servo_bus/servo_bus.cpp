#include "murosimf/control/servo_bus/servo_bus.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/eventfd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <set>
#include <stdexcept>

namespace murosimf::servo_bus {

namespace {

constexpr double kBudget = 1, kBudgetWindow = 25;  // [s]
constexpr double kReturnDelayUnit = 2e-6;          // [s]
constexpr int kLargestId = 252;

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

void require(bool holds, const std::string& complaint) {
  if (!holds) throw std::invalid_argument("servo_bus: " + complaint);
}

void requireRange(std::string_view key, double value, double least, double most) {
  require(value >= least && value <= most,
          fmt::format("{} is {}, expected {} to {}", key, value, least, most));  // false for NaN as well
}

std::string filledIn(std::string text, const std::string& mark, const std::string& value) {
  for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at + value.size())) {
    text.replace(at, mark.size(), value);
  }
  return text;
}

}  // namespace

/// Asks the thread to let a step have the registers, and has them.
class ServoBus::Turn {
 public:
  explicit Turn(ServoBus& bus) : bus_(bus) {
    bus_.step_asks_ = true;
    lock = std::unique_lock(bus_.mutex_);
  }
  ~Turn() {
    bus_.step_asks_ = false;
    bus_.step_asks_.notify_all();
  }
  Turn(const Turn&) = delete;
  Turn& operator=(const Turn&) = delete;
  std::unique_lock<std::mutex> lock;

 private:
  ServoBus& bus_;
};

ServoBus::ServoBus(ServoBusSettings settings) : settings_(std::move(settings)) {
  checkSettings();
  report_.activity = "servo bus";
}

void ServoBus::checkSettings() const {
  const ServoBusSettings& s = settings_;
  require(!s.link.empty(), "link is missing, expected the path of a link to the terminal: \"/tmp/murosimf/red.1\"");
  require(!s.servos.empty() || !s.imus.empty(), "there is no servo, expected at least one");
  requireRange("baud_rate [1/s]", s.baud_rate, 0, 1e7);
  requireRange("return_delay [s]", s.return_delay, 0, 254 * kReturnDelayUnit);
  requireRange("supply_voltage [V]", s.supply_voltage, 1, 60);
  requireRange("temperature [deg C]", s.temperature, 0, 255);
  requireRange("overload_time [s]", s.overload_time, 0, 1e6);
  requireRange("patience [s]", s.patience, 0, 1);
  std::set<int> ids;
  std::set<std::string> joints;
  const auto checkId = [&](int id, const std::string& what) {
    require(id >= 0 && id <= kLargestId, fmt::format("{} has id {}, expected 0 to {}", what, id, kLargestId));
    require(ids.insert(id).second, fmt::format("{} has id {}, which another device has already", what, id));
  };
  for (const ServoSettings& servo : s.servos) {
    const std::string what = fmt::format("servo of joint \"{}\"", servo.joint);
    checkId(servo.id, what);
    require(joints.insert(servo.joint).second, fmt::format("joint \"{}\" has two servos, expected one", servo.joint));
    require(servo.direction == 1 || servo.direction == -1,
            fmt::format("{} has direction {}, expected 1 or -1", what, servo.direction));
    require(std::isfinite(servo.zero), fmt::format("{} has zero {}, expected an angle [rad]", what, servo.zero));
    require(servo.model != "IMU", what + " has model \"IMU\", which drives nothing");
    tableOf(servo.model, s.protocol);
  }
  for (const ImuSettings& imu : s.imus) checkId(imu.id, fmt::format("imu \"{}\"", imu.imu));
  if (!s.imus.empty()) tableOf("IMU", s.protocol);
}

ServoBus::~ServoBus() {
  ends_ = true;
  if (alarm_.isOpen()) ::eventfd_write(alarm_.number(), 1);
  if (thread_.joinable()) thread_.join();
}

void ServoBus::connect(const client::RobotDescription& robot) {
  const auto delay = static_cast<std::uint8_t>(std::lround(settings_.return_delay / kReturnDelayUnit));
  std::vector<Device> devices;
  std::vector<std::string> names;
  for (const client::JointDescription& joint : robot.joints) names.push_back(joint.name);
  for (const ServoSettings& servo : settings_.servos) {
    const auto found = std::find(names.begin(), names.end(), servo.joint);
    require(found != names.end(), fmt::format("robot \"{}\" has no joint \"{}\", expected one of {}", robot.model,
                                              servo.joint, fmt::join(names, ", ")));
    const ControlTable table = tableOf(servo.model, settings_.protocol);
    actuators_.push_back(
        {Servo(servo, settings_, table), devices.size(), static_cast<std::size_t>(found - names.begin())});
    devices.emplace_back(table, static_cast<std::uint8_t>(servo.id), delay);
  }
  for (const ImuSettings& imu : settings_.imus) {
    const auto found = std::find(robot.imus.begin(), robot.imus.end(), imu.imu);
    require(imu.imu.empty() || found != robot.imus.end(),
            fmt::format("robot \"{}\" has no imu \"{}\", expected one of {}", robot.model, imu.imu,
                        fmt::join(robot.imus, ", ")));
    const std::size_t number = imu.imu.empty() ? 0 : static_cast<std::size_t>(found - robot.imus.begin());
    boards_.push_back({{}, devices.size(), number});
    devices.emplace_back(tableOf("IMU", settings_.protocol), static_cast<std::uint8_t>(imu.id), delay);
  }
  bus_ = std::make_unique<Bus>(settings_.protocol, std::move(devices));
}

void ServoBus::start(const client::RobotDescription& robot) {
  period_ = robot.control_period;
  const std::string link = filledIn(settings_.link, "{team}", robot.team);
  try {
    connect(robot);
    terminal_ = std::make_unique<PseudoTerminal>(filledIn(link, "{number}", std::to_string(robot.number)));
    alarm_.reset(checkedCall(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK), "eventfd"));
  } catch (const std::exception& problem) {
    throw client::CannotStart(problem.what());
  }
  thread_ = std::thread([this] { serve(); });
}

void ServoBus::sense(const client::SensorFrame& sensors, double dt) {
  for (Actuator& a : actuators_) {
    if (a.joint < sensors.joints.size())
      a.servo.sense(bus_->devices()[a.device], sensors.joints[a.joint], sensors.time, dt);
  }
  for (Board& board : boards_) {
    const client::ImuReading reading = board.number < sensors.imus.size()
                                           ? sensors.imus[board.number]
                                           : client::ImuReading{sensors.angular_velocity, sensors.specific_force};
    board.imu.sense(bus_->devices()[board.device], reading, dt);
  }
}

void ServoBus::step(const client::SensorFrame& sensors, client::CommandFrame& commands) {
  const double dt = stepped_ ? sensors.time - last_time_ : period_;
  last_time_ = sensors.time;
  const bool first = !std::exchange(stepped_, true);
  {
    Turn turn(*this);
    sense(sensors, dt);
  }
  if (first) {
    open_ = true;
    ::eventfd_write(alarm_.number(), 1);
  }
  if (settings_.lock_step) {
    std::unique_lock lock(mutex_);
    waitForGoals(sensors.time, lock);
  }
  Turn turn(*this);
  goals_taken_ = goalWrites();
  for (Actuator& a : actuators_) {
    if (a.joint < commands.joints.size())
      commands.joints[a.joint] = a.servo.command(bus_->devices()[a.device], period_);
  }
}

std::uint64_t ServoBus::goalWrites() const {
  std::uint64_t sum = 0;
  for (const Device& device : bus_->devices()) sum += device.goalWrites();
  return sum;
}

void ServoBus::waitForGoals(double t, std::unique_lock<std::mutex>& lock) {
  while (!vain_.empty() && vain_.front().first <= t - kBudgetWindow) vain_.pop_front();
  double spent = 0;
  for (const auto& [when, length] : vain_) spent += length;
  const double most = std::min(settings_.patience, kBudget - spent);
  const double start = now();
  const auto written = [&] { return goalWrites() != goals_taken_; };
  const auto patience = std::chrono::duration<double>(std::max(most, 0.0));
  if (goals_written_.wait_for(lock, patience, written)) return;
  ++counts_.missed_steps;
  if (most > 0) vain_.emplace_back(t, now() - start);
}

std::string ServoBus::address() const { return settings_.link; }

std::vector<std::pair<std::string, double>> ServoBus::figures() const {
  const ServoBusCounts c = counts();
  return {{"packets", static_cast<double>(c.packets)},
          {"damaged_packets", static_cast<double>(c.damaged)},
          {"lost_bytes", static_cast<double>(c.lost_bytes)},
          {"missed_steps", static_cast<double>(c.missed_steps)}};
}

ServoBusCounts ServoBus::counts() const {
  const std::lock_guard lock(mutex_);
  return counts_;
}

void ServoBus::archive(StateArchive& archive) {
  Turn turn(*this);
  for (Device& device : bus_->devices()) device.archive(archive);
  for (Actuator& a : actuators_) a.servo.archive(archive);
  for (Board& board : boards_) board.imu.archive(archive);
  archive(last_time_, stepped_, goals_taken_);
  if (archive.loading() && stepped_ && !open_.exchange(true)) ::eventfd_write(alarm_.number(), 1);
}

std::unique_ptr<client::ControlSoftware> makeServoBus(const ServoBusSettings& settings) {
  return std::make_unique<ServoBus>(settings);
}

}  // namespace murosimf::servo_bus
