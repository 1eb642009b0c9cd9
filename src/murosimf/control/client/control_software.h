#pragma once

/// @file What a program that controls a robot looks like when it is linked in.

#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "murosimf/control/client/robot_description.h"
#include "murosimf/control/client/robot_frames.h"
#include "murosimf/control/client/state_archive.h"

namespace murosimf::client {

/// Thrown by start() where nobody could play with such a robot: a simulation ends before it begins. All else that a
/// program throws is its own fault, and the others go on.
struct CannotStart : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// One robot's control software. Called from one thread at a time, never from two at once; different robots' programs
/// run in parallel and share nothing. Must depend on its inputs alone (no clock, no global state), so that a run can
/// be repeated bit for bit.
class ControlSoftware {
 public:
  virtual ~ControlSoftware() = default;
  /// Called once, before the first step.
  virtual void start(const RobotDescription& robot) = 0;
  /// Called once, when all robots' programs have started: as CommandFrame::camera_periods, for the time before the
  /// first step's commands. All are kCameraAsIs; nothing is changed unless told.
  virtual void startCameras(std::span<double> periods) { static_cast<void>(periods); }
  /// True of a program whose step waits for somebody outside: it gets a thread of its own.
  virtual bool waitsForOthers() const { return false; }
  /// Reads one sensor frame and fills the commands for the next period. commands.joints has its size already.
  virtual void step(const SensorFrame& sensors, CommandFrame& commands) = 0;
  /// Where somebody outside can connect to it, for people; empty: nowhere. Known before start().
  virtual std::string address() const { return ""; }
  /// What it has counted, for reports. Called between steps, after start().
  virtual std::vector<std::pair<std::string, double>> figures() const { return {}; }
  /// What the program believes after the last step.
  virtual const ControlReport& report() const = 0;
  /// Writes or reads its whole state, for checkpoints. Called between steps, after start().
  virtual void archive(StateArchive& archive) = 0;
};

}  // namespace murosimf::client
