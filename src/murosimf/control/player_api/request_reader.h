#pragma once

/// @file Obeys the requests of a client: motors, sensors, and what goes beyond the original API.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "murosimf/control/client/robot_frames.h"
#include "murosimf/control/player_api/device_book.h"
#include "murosimf/control/player_api/motor_table.h"
#include "murosimf/control/player_api/sensor_schedule.h"

namespace murosimf::player_api {

class ActuatorRequests;

/// What a message of requests said besides the requests.
struct RequestNotes {
  std::optional<long> answers;  ///< time of the measurements that it answers [ms]
  bool wants_surroundings = false;
  std::optional<client::TeamMessage> team_message;
};

class RequestReader {
 public:
  RequestReader(const DeviceBook& devices, MotorTable& motors, SensorSchedule& sensors)
      : devices_(devices), motors_(motors), sensors_(sensors) {}

  /// @param warnings  gets one text for each request that was not obeyed, at most kMostWarnings
  RequestNotes read(std::span<const std::uint8_t> bytes, long now, std::vector<std::string>& warnings);

  static constexpr std::size_t kMostWarnings = 100;  ///< a message; the client is told that there were more

 private:
  void readMotors(const ActuatorRequests& requests);
  void readGains(const ActuatorRequests& requests);
  void readTargets(const ActuatorRequests& requests);
  void readCameras(const ActuatorRequests& requests);
  void warn(std::string text);
  template <class Ask>
  void askMotor(const std::string& name, double value, const char* what, const Ask& ask);

  const DeviceBook& devices_;
  MotorTable& motors_;
  SensorSchedule& sensors_;
  std::vector<std::string>* warnings_ = nullptr;
};

}  // namespace murosimf::player_api
