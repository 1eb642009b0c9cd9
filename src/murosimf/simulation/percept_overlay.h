#pragma once

/// @file What the robots' cameras saw, with what their control software found in it drawn in.
///
/// A program's report holds the percepts of its last step, which may have had pictures of another camera or none; so
/// the keeper puts aside, per camera, the percepts of the step to which that camera's last picture was delivered. Of a
/// camera of level "oracle", which takes no picture, those of the last look, each kind when it arrived.

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "murosimf/simulation/simulation.h"

namespace murosimf {

/// What was found in one camera's last picture.
struct KeptPercepts {
  double time = -1;  ///< of the picture or look [s]; negative: none yet
  std::vector<client::Percept> percepts;
  const char* activity = "";  ///< of the robot, when it had seen the picture
};

/// Keeps the percepts of every camera's last picture. Register with ControlLoop::observe before the first frame.
class PerceptKeeper final : public ControlObserver {
 public:
  explicit PerceptKeeper(const ControlLoop& control);
  /// For this many cameras of each robot.
  explicit PerceptKeeper(const std::vector<std::size_t>& camera_counts);

  void onSensors(int robot, long frame) override;
  void onStep(int robot, long frame, const client::SensorFrame& sensors, const ControlledRobot& controlled,
              const client::ControlReport& report) override;
  /// What onStep() does, without the robot.
  void keep(int robot, const client::SensorFrame& sensors, const client::ControlReport& report);

  /// Of the camera's last picture. Only while no program runs: after ControlLoop::finish().
  const KeptPercepts& of(int robot, std::size_t camera) const;
  /// Activity of a robot as of its last step but one at most: may be asked on the frame thread at any time.
  const char* activity(int robot) const { return robots_[static_cast<std::size_t>(robot)].shown_activity; }

 private:
  struct Robot {
    std::vector<KeptPercepts> cameras;
    const char* last_activity = "";   // the task's
    const char* shown_activity = "";  // the frame thread's
  };
  std::vector<Robot> robots_;
};

/// Draws percepts in: balls as circles with their distance, foot points of posts, poles and robots as a bar of their
/// width with an upright on it, line points as crosses.
void drawPercepts(std::span<const client::Percept> percepts, Picture& picture);

/// What a camera delivered last, with these percepts drawn in: its picture, or a plain one of its size where it tells
/// of what it sees instead. Only while no program runs.
Picture cameraPicture(const ControlledRobot& robot, std::size_t camera, std::span<const client::Percept> percepts);

/// Writes DIRECTORY/<camera's path>.png for every camera that has taken a picture or looked: `robots.red.1.head.png`,
/// with percepts and a caption (camera, time, activity). Waits for the programs first. @returns the files, in order of
/// robots
/// @throws std::runtime_error as writePng() does.
std::vector<std::filesystem::path> writeCameraPictures(const std::filesystem::path& directory, Simulation& simulation,
                                                       const PerceptKeeper& keeper);

}  // namespace murosimf
