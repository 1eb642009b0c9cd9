#include "murosimf/control/player_api/remote_robot.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <stdexcept>

#include "murosimf/control/player_api/device_book.h"
#include "murosimf/control/player_api/player_api.pb.h"
#include "murosimf/control/player_api/surroundings.h"
#include "murosimf/control/wire/frame_client.h"

namespace murosimf::player_api {

namespace {

using client::DeviceDescription;
using client::DeviceKind;

constexpr std::size_t kLargestAnswer = 64 << 20;  // [bytes]

/// Makes sensor frames of measurements; what they point at lies here.
class FrameBuilder {
 public:
  explicit FrameBuilder(client::RobotDescription robot)
      : robot_(std::move(robot)),
        devices_(robot_.devices),
        joints_(robot_.joints.size()),
        imus_(std::max<std::size_t>(robot_.imus.size(), 1)),
        pressures_(robot_.soles.size()),
        forces_(robot_.force_sensors.size()),
        touches_(robot_.touch_sensors.size()) {}

  const client::RobotDescription& robot() const { return robot_; }
  const DeviceBook& devices() const { return devices_; }

  client::SensorFrame build(const SensorMeasurements& m) {
    client::SensorFrame frame;
    readJoints(m);
    readImus(m);
    readForces(m);
    readPictures(m);
    frame.joints = joints_;
    frame.imus = imus_;
    frame.angular_velocity = imus_[0].angular_velocity, frame.specific_force = imus_[0].specific_force;
    frame.sole_pressures = pressures_, frame.forces = forces_, frame.touches = touches_;
    frame.pictures = pictures_;
    surroundings_.read(m.surroundings(), robot_, frame);
    return frame;
  }

 private:
  /// The device of a measurement. @throws std::runtime_error where the robot has none of this name and kind
  const DeviceDescription& deviceOf(const std::string& name, DeviceKind kind) const {
    const int index = devices_.find(name);
    if (index < 0 || devices_.device(index).kind != kind)
      throw std::runtime_error(fmt::format("measurement of \"{}\", which the robot does not have", name));
    return devices_.device(index);
  }
  template <class Measurement>
  murosimf::Vector3 vectorOf(const Measurement& m, const DeviceDescription& device) const {
    return {simulatedValue(device, m.value().x()), simulatedValue(device, m.value().y()),
            simulatedValue(device, m.value().z())};
  }
  void readJoints(const SensorMeasurements& m) {
    for (const PositionSensorMeasurement& s : m.position_sensors()) {
      const DeviceDescription& device = deviceOf(s.name(), DeviceKind::kPositionSensor);
      joints_[index(device)] = {simulatedValue(device, s.value()), s.velocity(), s.torque()};
    }
  }
  void readImus(const SensorMeasurements& m) {
    for (const AccelerometerMeasurement& s : m.accelerometers()) {
      const DeviceDescription& device = deviceOf(s.name(), DeviceKind::kAccelerometer);
      imus_[index(device)].specific_force = vectorOf(s, device);
    }
    for (const GyroMeasurement& s : m.gyros()) {
      const DeviceDescription& device = deviceOf(s.name(), DeviceKind::kGyro);
      imus_[index(device)].angular_velocity = vectorOf(s, device);
    }
  }
  void readForces(const SensorMeasurements& m) {
    for (const ForceMeasurement& s : m.forces()) {
      const DeviceDescription& device = deviceOf(s.name(), DeviceKind::kForce);
      if (device.corner >= 0)
        pressures_[index(device)][static_cast<std::size_t>(device.corner)] = simulatedValue(device, s.value());
    }
    for (const Force3DMeasurement& s : m.force3ds()) {
      const DeviceDescription& device = deviceOf(s.name(), DeviceKind::kForce3d);
      forces_[index(device)] = vectorOf(s, device);
    }
    for (const BumperMeasurement& s : m.bumpers())
      touches_[index(deviceOf(s.name(), DeviceKind::kBumper))] = s.value() ? 1 : 0;
  }
  void readPictures(const SensorMeasurements& m) {
    pictures_.clear();
    for (const CameraMeasurement& c : m.cameras()) {
      const DeviceDescription& device = deviceOf(c.name(), DeviceKind::kCamera);
      const std::string& image = c.image();
      if (image.size() != std::size_t{c.width()} * c.height() * 3)
        throw std::runtime_error(
            fmt::format("picture of {} x {} pixels in {} bytes", c.width(), c.height(), image.size()));
      std::vector<std::uint8_t>& bytes = images_[index(device)];
      bytes.resize(image.size());
      for (std::size_t i = 0; i < bytes.size(); i += 3) {
        for (std::size_t k = 0; k < 3; ++k) bytes[i + k] = static_cast<std::uint8_t>(image[i + 2 - k]);
      }
      pictures_.push_back({device.part, c.time(), static_cast<int>(c.width()), static_cast<int>(c.height()), bytes,
                           client::PixelFormat::kRgb});
    }
  }
  static std::size_t index(const DeviceDescription& device) { return static_cast<std::size_t>(device.part); }

  client::RobotDescription robot_;
  DeviceBook devices_;
  std::vector<client::JointReading> joints_;
  std::vector<client::ImuReading> imus_;
  std::vector<std::array<double, 4>> pressures_;
  std::vector<murosimf::Vector3> forces_;
  std::vector<std::uint8_t> touches_;
  std::vector<client::CameraPicture> pictures_;
  std::map<std::size_t, std::vector<std::uint8_t>> images_;  // of each camera
  SurroundingsReader surroundings_;
};

/// A command in the words of the original API where it has them: a position with gains, or else all at once.
void addCommand(const std::string& motor, const client::JointCommand& c, ActuatorRequests& out) {
  if (c.velocity == 0 && c.torque == 0 && c.kp > 0) {
    MotorPosition& position = *out.add_motor_positions();
    position.set_name(motor);
    position.set_position(c.position);
    MotorPID& gains = *out.add_motor_pids();
    gains.set_name(motor);
    gains.mutable_pid()->set_x(c.kp), gains.mutable_pid()->set_z(c.kd);
    return;
  }
  MotorCommand& command = *out.add_motor_commands();
  command.set_name(motor);
  command.set_position(c.position), command.set_velocity(c.velocity), command.set_torque(c.torque);
  command.set_kp(c.kp), command.set_kd(c.kd);
}

void addCommands(const FrameBuilder& frames, const client::CommandFrame& commands, ActuatorRequests& out) {
  for (int i = 0; i < frames.devices().count(); ++i) {
    const DeviceDescription& device = frames.devices().device(i);
    const auto joint = static_cast<std::size_t>(device.part);
    if (device.kind != DeviceKind::kMotor || joint >= commands.joints.size()) continue;
    client::JointCommand command = commands.joints[joint];
    if (device.scale != 1 || device.offset != 0) command.position = deviceValue(device, command.position);
    addCommand(device.name, command, out);
  }
  if (commands.message.number != 0) setMessage(commands.message, *out.mutable_team_message());
}

void addTimeStep(const std::string& device, double milliseconds, ActuatorRequests& out) {
  SensorTimeStep& step = *out.add_sensor_time_steps();
  step.set_name(device);
  step.set_timestep(static_cast<std::uint32_t>(std::lround(std::max(milliseconds, 0.0))));
}

/// @param periods  of cameras [s]; kCameraAsIs: nothing is asked
void addCameraPeriods(const FrameBuilder& frames, const std::vector<double>& periods, ActuatorRequests& out) {
  for (int i = 0; i < frames.devices().count(); ++i) {
    const DeviceDescription& device = frames.devices().device(i);
    const auto camera = static_cast<std::size_t>(device.part);
    if (device.kind != DeviceKind::kCamera || camera >= periods.size() || periods[camera] < 0) continue;
    addTimeStep(device.name, periods[camera] * 1000, out);
  }
}

/// One connection, from the first requests to the last measurements.
class Session {
 public:
  Session(client::ControlSoftware& program, const RemoteRobotSettings& settings,
          const std::function<void(const std::string&)>& warn)
      : program_(program), settings_(settings), warn_(warn), client_(settings.host, settings.port, settings.patience) {}

  RemoteRun run() {
    beWelcome();
    ActuatorRequests opening;
    opening.set_wants_surroundings(true);
    send(opening);
    while (receive()) {
      if (frames_ == nullptr && measured_.surroundings().has_description())
        begin();
      else
        answer();
    }
    return run_;
  }

 private:
  void beWelcome() {
    std::array<std::uint8_t, 8> word{};
    if (!client_.readRaw(word.data(), word.size())) throw std::runtime_error("the server closed the connection");
    const std::string text(word.begin(), word.end());
    if (text == std::string("Refused") + '\0') throw std::runtime_error("the server refuses this host");
    if (text != std::string("Welcome") + '\0')
      throw std::runtime_error("this is no player API: it does not welcome us");
  }

  void send(const ActuatorRequests& requests) {
    bytes_.resize(requests.ByteSizeLong());
    requests.SerializeToArray(bytes_.data(), static_cast<int>(bytes_.size()));
    client_.send(bytes_);
  }

  bool receive() {
    if (!client_.receive(bytes_, kLargestAnswer)) return false;
    if (!measured_.ParseFromArray(bytes_.data(), static_cast<int>(bytes_.size())))
      throw std::runtime_error(fmt::format("a message of {} bytes that is no SensorMeasurements", bytes_.size()));
    for (const Message& message : measured_.messages()) {
      warn_(message.text());
      ++run_.warnings;
    }
    return true;
  }

  /// The robot is known now: starts the program and turns on what the robot has.
  void begin() {
    frames_ = std::make_unique<FrameBuilder>(descriptionFromCbor(measured_.surroundings().description().cbor()));
    const client::RobotDescription& robot = frames_->robot();
    run_.team = robot.team, run_.number = robot.number;
    program_.start(robot);
    std::vector<double> periods;
    for (const client::CameraDescription& camera : robot.cameras)
      periods.push_back(settings_.pictures ? camera.period : 0);
    std::vector<double> chosen(periods.size(), client::kCameraAsIs);
    program_.startCameras(chosen);
    for (std::size_t i = 0; i < periods.size(); ++i) {
      if (chosen[i] >= 0) periods[i] = chosen[i];
    }
    ActuatorRequests requests;
    for (int i = 0; i < frames_->devices().count(); ++i) {
      const DeviceDescription& device = frames_->devices().device(i);
      if (device.kind != DeviceKind::kMotor && device.kind != DeviceKind::kCamera)
        addTimeStep(device.name, robot.control_period * 1000, requests);
    }
    addCameraPeriods(*frames_, periods, requests);
    requests.set_answers(measured_.time());
    send(requests);
  }

  /// The answer to a message; without commands as long as not all joints have been measured.
  void answer() {
    ActuatorRequests requests;
    requests.set_answers(measured_.time());
    if (frames_ != nullptr && measured_.position_sensors_size() > 0) {
      const client::SensorFrame sensors = frames_->build(measured_);
      if (run_.steps++ == 0) first_time_ = sensors.time;
      run_.seconds = sensors.time - first_time_;
      commands_.joints.resize(frames_->robot().joints.size());
      commands_.message = {};
      commands_.camera_periods.assign(frames_->robot().cameras.size(), client::kCameraAsIs);
      program_.step(sensors, commands_);
      addCommands(*frames_, commands_, requests);
      addCameraPeriods(*frames_, commands_.camera_periods, requests);
    }
    send(requests);
  }

  client::ControlSoftware& program_;
  const RemoteRobotSettings& settings_;
  const std::function<void(const std::string&)>& warn_;
  FrameClient client_;
  std::unique_ptr<FrameBuilder> frames_;
  SensorMeasurements measured_;
  FrameBytes bytes_;
  client::CommandFrame commands_;
  RemoteRun run_;
  double first_time_ = 0;
};

}  // namespace

RemoteRun runRemotely(client::ControlSoftware& program, const RemoteRobotSettings& settings,
                      const std::function<void(const std::string&)>& warn) {
  return Session(program, settings, warn).run();
}

}  // namespace murosimf::player_api
