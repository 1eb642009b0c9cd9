#pragma once

/// @file Runs the control software of all robots: pictures and sensors out, commands back in, on its own clock.
///
/// At the end of a frame in which the control period ends, each robot's sensors are read, and one task per robot
/// renders the pictures taken since and steps its control software, on other threads, while physics goes on. Pictures,
/// what cameras of level "oracle" tell in their place, and scans of range sensors
/// show the world as it was at the end of the frame in which their camera was due. Commands computed from the sensor
/// frame of time t act at t + delay:
///   simulated clock   never earlier, never later: the frame waits for tasks that are not ready;
///   paced clock       late ones act late and are counted; a robot that is still busy misses its next sensor frame, and
///                     the newest of its pictures wait with it. The frame thread never waits.
/// A robot may have a period and a delay of its own. A message goes out with its sender's next sensor frame.
/// A program may choose how often its cameras take pictures (CommandFrame::camera_periods); what it chooses acts as its
/// commands do. A program that waits for somebody outside (waitsForOthers) has a thread of its own on both clocks.
/// Messages to team mates are delivered with the next sensor frame. No lock is held while a program runs.
/// A program that throws is not stepped again: its robot keeps the last command, the others go on; see faults().

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "murosimf/control/client/control_software.h"
#include "murosimf/control/pose_oracle.h"
#include "murosimf/control/program_pool.h"
#include "murosimf/control/robot_port.h"
#include "murosimf/control/snapshot_shelf.h"
#include "murosimf/modules/camera/oracle_camera.h"
#include "murosimf/modules/camera/robot_camera.h"
#include "murosimf/modules/sensing/range_sensor.h"

namespace murosimf {

/// What a robot is given to run.
struct ControlledRobot {
  RobotPort port;
  std::vector<std::unique_ptr<RobotCamera>> cameras;  ///< in the order of the description; null: that camera is off
  std::unique_ptr<client::ControlSoftware> program;   ///< null: nobody; the joints keep their positions
  std::vector<std::unique_ptr<OracleCamera>> oracles = {};  ///< as cameras, which is null where one stands here
  std::unique_ptr<PoseOracle> localisation = nullptr;       ///< null: nobody tells where robots stand
  std::vector<std::unique_ptr<RangeSensor>> ranges = {};    ///< in the order of the description
  long period = 0, delay = -1;                              ///< of its program [frames]; 0 and -1: those of the loop

  std::size_t cameraCount() const { return std::max(cameras.size(), oracles.size()); }
  /// The camera with this number, whatever its level of detail; null: it is off.
  MountedCamera* camera(std::size_t i) const;
  /// All that looks at snapshots: cameras, then range sensors.
  std::size_t eyeCount() const { return cameraCount() + ranges.size(); }
  MountedCamera* eye(std::size_t i) const { return i < cameraCount() ? camera(i) : ranges[i - cameraCount()].get(); }
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
  long period = 10, delay = 10;  ///< of programs that have none of their own [frames]
  bool paced = false;
  int threads = 0;  ///< simulated clock; 0: as many as the machine has. Paced, and where a program waits for others,
                    ///< each robot has one of its own
};

/// Counters for the report.
struct ControlCounts {
  double picture_seconds = 0, program_seconds = 0;  ///< summed over threads [s]
  long pictures = 0, steps = 0, refused_joints = 0, late_commands = 0, missed_frames = 0, failed_programs = 0;
};

/// A program that threw an exception.
struct ProgramFault {
  ObjectId robot;
  double time = 0;   ///< of the sensor frame that it failed at; 0: it did not start [s]
  std::string what;  ///< the exception's text
};

class ControlLoop {
 public:
  /// The view must live longer. Cameras' periods must not be shorter than the control period.
  /// @throws std::invalid_argument when one is, or for a period below 1 frame or a delay below 0.
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
  /// What its program believes; null when it has none. Only while no program runs: after finish().
  const client::ControlReport* report(int robot) const;

  /// Its program; null: it has none.
  const client::ControlSoftware* program(int robot) const;

  /// Where its program has asked to be put, in its team's own frame, since this was called last; nothing: it has not.
  std::optional<PlanarPose> takeBeam(int robot);
  /// True while this robot's program runs.
  bool isBusy(int robot) const;

  /// Starts the programs. Call once, before the first frame.
  void start();
  /// Puts commands into force that are due at the beginning of this frame.
  void applyCommands(long frame);
  /// Takes the pictures that are due at the end of this frame, and hands out sensor frames when a control period ends.
  void publish(long frame);
  /// Waits until no program runs. @throws what an observer threw
  void finish();
  /// Only while no program runs: after finish().
  ControlCounts counts() const;
  /// The programs that failed, in the order of robots. Only while no program runs.
  std::vector<ProgramFault> faults() const;
  /// State of ports and programs. Waits for them first.
  void archive(StateArchive& archive);

 private:
  struct Runner;
  void checkCameras(const ControlledRobot& robot) const;
  void setCameras(Runner& runner, const client::CommandFrame& commands, long frame);
  void takePictures(long frame);
  void deliverPicture(Runner& runner, std::size_t camera);
  void deliverSights(Runner& runner, std::size_t camera);
  void deliverScans(Runner& runner);
  void collect(Runner& runner, long next_frame);
  void deliverMessage(Runner& sender);
  void findDue(long frame);
  void orderPictures();
  void launch(Runner& runner, long frame);
  void tellPoses(Runner& runner, long frame);
  void runTask(Runner& runner);
  void render(Runner& runner);
  void stepProgram(Runner& runner);

  std::unique_ptr<SnapshotShelf> snapshots_;  // ends behind the cameras, which may still look at it
  std::vector<std::unique_ptr<Runner>> robots_;
  std::vector<Runner*> due_;         // those whose control period ends in this frame
  std::vector<Runner*> programmed_;  // those with a program: of a thousand robots without one none is looked at
  const SceneView& view_;
  ControlTiming timing_;
  double frame_length_;
  std::vector<ControlObserver*> observers_;
  std::unique_ptr<ProgramPool> pool_;  // ends before what its tasks use
};

}  // namespace murosimf
