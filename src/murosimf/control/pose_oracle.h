#pragma once

/// @file Level of detail "oracle" of localisation: a robot is told where it and its team mates stand, with errors.
///
/// Of the truth (x, y, heading) in the team's own frame, g_i numbers of (seed, robot, whose pose, tick):
///   x' = x + x_bias + position_noise g_1,  y' = y + y_bias + position_noise g_2,
///   heading' = heading + heading_bias + heading_noise g_3
/// Nothing is told where u < miss, and in outages (random_events.h). x, y: below the base's origin.

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/control/client/robot_frames.h"
#include "murosimf/math/state_archive.h"
#include "murosimf/modules/camera/scene_view.h"
#include "murosimf/modules/camera/sight_errors.h"

namespace murosimf {

struct PoseErrors {
  double position_noise = 0, heading_noise = 0;     ///< standard deviations [m], [rad]
  double x_bias = 0, y_bias = 0, heading_bias = 0;  ///< [m], [m], [rad]
  double miss = 0;                                  ///< probability
  double delay = 0;                                 ///< [s]
  double outage_rate = 0, outage_length = 1;        ///< [1/s], [s]
};
const std::vector<ErrorParameter<PoseErrors>>& poseParameters();

/// As parameters are called: own_miss, mate_miss.
inline constexpr std::array<std::string_view, 2> kPoseKindNames{"own", "mate"};

struct PoseOracleSettings {
  double period = 0;                 ///< between two poses told [s], rounded to frames; 0: with every sensor frame
  double phase = 0;                  ///< [s]
  std::array<PoseErrors, 2> errors;  ///< of the own pose, of mates' poses
};

/// A robot whose pose is told.
struct ToldRobot {
  ObjectId object;
  int number = 0;
};

class PoseOracle {
 public:
  /// @param robots  the robot itself, then its mates
  /// @param control_period  [frames]
  PoseOracle(std::vector<ToldRobot> robots, bool attacks_positive_x, const PoseOracleSettings& settings,
             std::uint64_t seed, std::string_view robot, long control_period, double frame_length);

  /// The poses that have arrived by the end of this frame, as the robots; not valid where none has. Call once at the
  /// end of each control period; frame thread.
  std::span<const client::ToldPose> tell(const SceneView& view, long frame);
  void archive(StateArchive& archive);

 private:
  struct Told {  // on its way
    client::ToldPose pose;
    long frame = 0;
    void archive(StateArchive& archive) { archive(pose.number, pose.valid, pose.time, pose.pose, pose.X_FB, frame); }
  };
  bool isDue(long frame) const;
  client::ToldPose read(const SceneView& view, std::size_t robot, long frame) const;

  std::vector<ToldRobot> robots_;
  bool attacks_positive_x_;
  PoseOracleSettings settings_;
  std::uint64_t seed_;
  std::string name_;
  long control_period_;
  double frame_length_;
  std::vector<std::vector<Told>> waiting_;  // of each robot, in the order of time
  std::vector<client::ToldPose> told_;
};

}  // namespace murosimf
