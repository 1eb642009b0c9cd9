#pragma once

/// @file Between the structs of control/client and the messages of player_api.proto, both ways.

#include <deque>
#include <string>
#include <vector>

#include "murosimf/control/client/robot_description.h"
#include "murosimf/control/client/robot_frames.h"
#include "murosimf/control/player_api/device_book.h"

namespace murosimf::player_api {

class Surroundings;
class TeamMessage;

client::TeamMessage clientMessage(const TeamMessage& message);
void setMessage(const client::TeamMessage& message, TeamMessage& out);

/// What of a sensor frame reaches a robot by other ways than its sensors.
void writeSurroundings(const client::SensorFrame& sensors, const client::RobotDescription& robot, Surroundings& out);

/// Holds what a sensor frame points at while a client uses it.
class SurroundingsReader {
 public:
  /// Fills the same parts of a sensor frame; they point into this reader and into `from`, until the next call.
  /// @throws std::runtime_error where a camera of `from` is unknown
  void read(const Surroundings& from, const client::RobotDescription& robot, client::SensorFrame& sensors);

 private:
  std::vector<client::TeamMessage> messages_;
  std::vector<client::ToldPose> mates_;
  std::deque<std::vector<client::SeenThing>> things_;
  std::vector<client::CameraSights> sights_;
  std::vector<std::uint8_t> sole_touches_;
};

/// A robot's description in CBOR [RFC 8949], and back. @throws std::runtime_error where the bytes are none
std::string describeInCbor(const client::RobotDescription& robot);
client::RobotDescription descriptionFromCbor(const std::string& cbor);

}  // namespace murosimf::player_api
