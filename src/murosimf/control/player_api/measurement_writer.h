#pragma once

/// @file Writes the measurements that a client has asked for.

#include <map>
#include <string>
#include <vector>

#include "murosimf/control/client/robot_frames.h"
#include "murosimf/control/player_api/device_book.h"
#include "murosimf/control/player_api/sensor_schedule.h"

namespace murosimf::player_api {

class SensorMeasurements;

/// Adds what is due at `now` [ms], in the order of the robot's devices. @param extended  with our own fields
void writeMeasurements(const DeviceBook& devices, const SensorSchedule& schedule, const client::SensorFrame& sensors,
                       long now, bool extended, SensorMeasurements& out);

}  // namespace murosimf::player_api
