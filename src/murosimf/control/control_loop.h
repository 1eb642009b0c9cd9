#pragma once

/// @file Runs the control software of all robots: pictures and sensors out, commands back in, on its own clock.
///
/// At the end of a frame in which the control period ends, each robot's sensors are read and, where a camera is due, a
/// snapshot of the world is taken. One task per robot then renders its pictures and steps its control software, on
/// other threads, while physics goes on. Commands computed from the sensor frame of time t act at t + delay:
///   simulated clock   never earlier, never later: the frame waits for tasks that are not ready;
///   paced clock       late ones act late and are counted; a robot that is still busy misses its next sensor frame.
/// Messages to team mates are delivered with the next sensor frame. No lock is held while a program runs.

#include <atomic>
#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "murosimf/control/client/control_software.h"
#include "murosimf/control/robot_port.h"
#include "murosimf/modules/camera/robot_camera.h"

namespace murosimf {

/// What a robot is given to run.
struct ControlledRobot {
  RobotPort port;
  std::vector<std::unique_ptr<RobotCamera>> cameras;  ///< in the order of the description; null: that camera is off
  std::unique_ptr<client::ControlSoftware> program;   ///< null: nobody; the joints keep their positions
};

/// Somebody who compares what control software believes with the truth. Index: the robot's in ControlLoop.
class ControlObserver {
 public:
  virtual ~ControlObserver() = default;
  /// Sensors of this robot have been read at the end of `frame`; the world is at rest. Frame thread.
  virtual void onSensors(int robot, long frame) = 0;
  /// Its program has stepped; pictures of this step are those whose cameras were due. The robot's task: touch only
  /// what belongs to this robot.
  virtual void onStep(int robot, long frame, const client::SensorFrame& sensors, const ControlledRobot& controlled,
                      const client::ControlReport& report) = 0;
};

struct ControlTiming {
  long period = 10, delay = 10;  ///< [frames]
  bool paced = false;
  int threads = 0;  ///< 0: as many as the machine has
};

/// Counters for the report.
struct ControlCounts {
  double picture_seconds = 0, program_seconds = 0;  ///< summed over threads [s]
  long pictures = 0, steps = 0, refused_joints = 0, late_commands = 0, missed_frames = 0;
};

class ControlLoop {
 public:
  ControlLoop(std::vector<ControlledRobot> robots, const SceneView& view, const ControlTiming& timing,
              double frame_length);
  ~ControlLoop();

  int robotCount() const { return static_cast<int>(robots_.size()); }
  const ControlledRobot& robot(int index) const;
  /// The robot with this path's object; -1 when it is not controlled here.
  int indexOf(ObjectId robot) const;
  /// Observers are called in the order in which they were added; add them before the first frame.
  void observe(ControlObserver* observer) { observers_.push_back(observer); }
  void setGame(int robot, const client::GameInfo& game);
  const client::ControlReport* report(int robot) const;

  /// Starts the programs. Call once, before the first frame.
  void start();
  /// Puts commands into force that are due at the beginning of this frame.
  void applyCommands(long frame);
  /// Hands out sensor frames when a control period ends with this frame.
  void publish(long frame);
  /// Waits until no program runs.
  void finish();
  ControlCounts counts() const;
  /// State of ports and programs. Waits for them first.
  void archive(StateArchive& archive);

 private:
  struct Runner;
  struct Pool;
  void launch(Runner& runner, long frame);
  void runTask(Runner& runner, long frame);
  void collectMessages();

  std::vector<std::unique_ptr<Runner>> robots_;
  const SceneView& view_;
  ControlTiming timing_;
  double frame_length_;
  std::unique_ptr<Pool> pool_;
  std::vector<RayScene> snapshots_;  // two: one may still be looked at
  std::size_t next_snapshot_ = 0;
  std::vector<ControlObserver*> observers_;
};

}  // namespace murosimf
