#pragma once

/// @file Private to ControlLoop: what it keeps of one robot.

#include <array>
#include <atomic>
#include <exception>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "murosimf/control/command_queue.h"
#include "murosimf/control/control_loop.h"

namespace murosimf {

inline constexpr long kNoSnapshot = -1;

/// One picture that was taken but not rendered yet.
struct Exposure {
  long snapshot = kNoSnapshot, frame = 0;
  MovingCamera place;
};

/// One robot with everything that its task touches. While `busy`, what stands in the second part is the task's.
struct ControlLoop::Runner {
  int index = 0;
  long period = 0, delay = 0;              // [frames]
  client::GameInfo game;                   // placed stays true until a sensor frame has told it
  std::vector<client::TeamMessage> inbox;  // one place a robot: the last message since the last sensor frame; none
                                           // without a program: a thousand robots' would be a million
  client::TeamMessage outbox;              // of the last answer, until it is delivered
  std::vector<Exposure> waiting;           // one place a camera or range sensor
  CommandQueue pending;
  bool beams = false;  // its program asks to be put to `beam`
  PlanarPose beam;
  bool answered = false;  // the last task's commands have not been collected yet
  bool failed = false;
  long refused_joints = 0, late_commands = 0, missed_frames = 0;
  std::atomic<bool> busy{false};

  ControlledRobot controlled;
  long asked = 0;  // frame of the last sensor frame
  client::SensorFrame sensors;
  std::vector<Exposure> exposures;  // of this sensor frame, one place a camera or range sensor
  std::vector<client::TeamMessage> messages;
  std::vector<client::CameraPicture> pictures;
  std::vector<std::array<std::vector<client::SeenThing>, kSightKinds>> things;  // of each camera
  std::vector<client::CameraSights> sights;
  std::vector<client::RangeScan> scans;
  std::vector<client::ToldPose> mate_poses;
  client::CommandFrame commands;
  std::optional<std::string> fault;  // what the program threw
  std::exception_ptr observer_fault;
  ControlCounts counts;

  /// @param robot  with its period and delay
  Runner(int i, int robots, ControlledRobot robot)
      : index(i),
        period(robot.period),
        delay(robot.delay),
        inbox(static_cast<std::size_t>(robot.program == nullptr ? 0 : robots)),
        waiting(robot.eyeCount()),
        pending(static_cast<int>(delay / period) + 2, robot.port.emptyCommands()),
        controlled(std::move(robot)),
        exposures(waiting.size()),
        things(waiting.size()),
        commands(controlled.port.emptyCommands()) {
    messages.reserve(inbox.size());
    pictures.reserve(waiting.size());
    sights.reserve(waiting.size() * kSightKinds);
    scans.reserve(controlled.ranges.size());
    mate_poses.reserve(inbox.size());
  }
  bool runs() const { return controlled.program != nullptr && !failed; }
  const std::string& team() const { return controlled.port.description().team; }
};

}  // namespace murosimf
