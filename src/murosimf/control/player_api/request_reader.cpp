#include "murosimf/control/player_api/request_reader.h"

#include <fmt/format.h>

#include <utility>

#include "murosimf/control/player_api/player_api.pb.h"
#include "murosimf/control/player_api/surroundings.h"

namespace murosimf::player_api {

void RequestReader::warn(std::string text) {
  if (warnings_->size() < kMostWarnings) {
    warnings_->push_back(std::move(text));
  } else if (warnings_->size() == kMostWarnings) {
    warnings_->emplace_back("and more requests that were ignored");
  }
}

/// @param ask  is given the joint, and tells whether the value makes sense
template <class Ask>
void RequestReader::askMotor(const std::string& name, double value, const char* what, const Ask& ask) {
  const int motor = devices_.findMotor(name);
  if (motor < 0) {
    warn(fmt::format("{} for \"{}\" ignored: the robot has no motor of this name", what, name));
  } else if (!ask(devices_.device(motor).part)) {
    warn(fmt::format("{} of {} for \"{}\" ignored: expected a number that makes sense", what, value, name));
  }
}

void RequestReader::readMotors(const ActuatorRequests& requests) {
  const auto scaled = [&](const std::string& name, double value) {
    const int motor = devices_.findMotor(name);
    return motor < 0 ? value : simulatedValue(devices_.device(motor), value);
  };
  for (const MotorPosition& m : requests.motor_positions())
    askMotor(m.name(), m.position(), "position",
             [&](int joint) { return motors_.askPosition(joint, scaled(m.name(), m.position())); });
  for (const MotorVelocity& m : requests.motor_velocities())
    askMotor(m.name(), m.velocity(), "velocity", [&](int joint) { return motors_.askVelocity(joint, m.velocity()); });
  for (const MotorForce& m : requests.motor_forces())
    askMotor(m.name(), m.force(), "force", [&](int joint) { return motors_.askTorque(joint, m.force()); });
  for (const MotorTorque& m : requests.motor_torques())
    askMotor(m.name(), m.torque(), "torque", [&](int joint) { return motors_.askTorque(joint, m.torque()); });
}

void RequestReader::readGains(const ActuatorRequests& requests) {
  for (const MotorPID& m : requests.motor_pids()) {
    askMotor(m.name(), m.pid().x(), "PID",
             [&](int joint) { return motors_.askGains(joint, m.pid().x(), m.pid().z()); });
    if (m.pid().y() != 0)
      warn(fmt::format("I = {} for \"{}\" ignored: the servos have no integral part", m.pid().y(), m.name()));
  }
}

void RequestReader::readTargets(const ActuatorRequests& requests) {
  for (const MotorCommand& m : requests.motor_commands())
    askMotor(m.name(), m.position(), "command", [&](int joint) {
      return motors_.askCommand(joint, {m.position(), m.velocity(), m.torque(), m.kp(), m.kd()});
    });
}

void RequestReader::readCameras(const ActuatorRequests& requests) {
  const auto known = [&](const std::string& name) { return devices_.findCamera(name) >= 0; };
  for (const CameraQuality& c : requests.camera_qualities())
    warn(fmt::format("quality for \"{}\" ignored: {}", c.name(),
                     known(c.name()) ? "pictures are always raw" : "the robot has no camera of this name"));
  for (const CameraExposure& c : requests.camera_exposures())
    warn(fmt::format("exposure for \"{}\" ignored: {}", c.name(),
                     known(c.name()) ? "the camera's is the scenario's" : "the robot has no camera of this name"));
}

RequestNotes RequestReader::read(std::span<const std::uint8_t> bytes, long now, std::vector<std::string>& warnings) {
  warnings_ = &warnings;
  RequestNotes notes;
  ActuatorRequests requests;
  if (!requests.ParseFromArray(bytes.data(), static_cast<int>(bytes.size()))) {
    warn(fmt::format("a message of {} bytes ignored: it is no ActuatorRequests", bytes.size()));
    return notes;
  }
  readMotors(requests);
  readGains(requests);
  readTargets(requests);
  readCameras(requests);
  for (const SensorTimeStep& s : requests.sensor_time_steps()) {
    std::string refusal = sensors_.ask(s.name(), s.timestep(), now);
    if (!refusal.empty()) warn(std::move(refusal));
  }
  if (requests.has_answers()) notes.answers = requests.answers();
  notes.wants_surroundings = requests.wants_surroundings();
  if (requests.has_team_message()) notes.team_message = clientMessage(requests.team_message());
  return notes;
}

}  // namespace murosimf::player_api
