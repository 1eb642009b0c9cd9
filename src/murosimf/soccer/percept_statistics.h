#pragma once

/// @file How well robots see and know where they are: percepts and poses of control software against the truth.
///
/// Ball visible  The picture shows at least 12 pixels of it; its centre is their centroid, its radius that of a circle
///               of this area (a half hidden ball counts with what is seen of it).
///               A camera of level "oracle" takes no picture; its look counts as one. The ball is visible in it when
///               the look saw it, whether that was told or missed, and has its true centre and radius.
/// Match         A ball percept of that picture's camera within max(4 px, 1.5 radii) of the centre.
/// Recall        pictures with a match / pictures in which the ball is visible.
/// Precision     ball percepts that match / ball percepts; here a single pixel of the ball is enough to be right.
/// Distance      |percept's distance - true one| / true one, of matching percepts; from the robot's base, horizontally.
/// Localisation  error of position and heading, while the game is on and the robot says that it knows its pose.
///
/// Every fifth control step enters the percentiles of localisation. Pictures and control steps belong to a robot's own
/// task, so each robot has an account of its own; ask for results when no control software runs.

#include <vector>

#include "murosimf/control/control_loop.h"
#include "murosimf/linking/body_path.h"
#include "murosimf/simulation/simulation.h"
#include "murosimf/soccer/match.h"
#include "murosimf/soccer/samples.h"

namespace murosimf {

inline constexpr long kVisiblePixels = 12;
inline constexpr double kMatchPixels = 4, kMatchRadii = 1.5;
inline constexpr long kPoseStride = 5;  // control steps

/// Counts of one robot, or of all; errors are NaN where nothing was measured.
struct PerceptResult {
  ObjectId robot;  ///< invalid: all together
  long pictures = 0, pictures_with_ball = 0, ball_found = 0;
  long ball_percepts = 0, ball_percepts_right = 0;
  double recall = 0, precision = 0;             ///< NaN: no ball was visible; nothing was perceived
  double distance_error_median = 0;             ///< [1]
  long playing_steps = 0, valid_steps = 0;      ///< control steps while playing; those with a valid pose
  double valid_share = 0;                       ///< [1]
  double position_median = 0, position_90 = 0;  ///< [m]
  double heading_median = 0, heading_90 = 0;    ///< [rad]
};

/// Observes the control loop. Let it observe the simulation too: there it only takes part in checkpoints.
class PerceptStatistics final : public ControlObserver, public FrameObserver {
 public:
  /// The control loop must have been set. Without one, or without a ball in the world, less is counted.
  PerceptStatistics(const MatchSettings& match, Simulation& simulation);

  void onSensors(int robot, long frame) override;
  void onStep(int robot, long frame, const client::SensorFrame& sensors, const ControlledRobot& controlled,
              const client::ControlReport& report) override;
  void afterFrame(Simulation&) override {}
  void archive(StateArchive& archive) override;

  /// Per robot, in the order of the control loop.
  std::vector<PerceptResult> results() const;
  PerceptResult allTogether() const;
  /// Deliberate kicks that this robot of the control loop had started before its last sensor frame. Frame thread.
  std::uint32_t kicksStarted(int robot) const { return accounts_[static_cast<std::size_t>(robot)].kicks_before; }

 private:
  struct alignas(64) Account {
    BodyPath path;
    ObjectId robot;
    bool attacks_positive_x = true;
    PlanarPose truth;          // X_FB at the last sensor frame
    double ball_distance = 0;  // then [m]
    std::uint32_t kicks = 0, kicks_before = 0;
    PerceptResult counts;
    Samples distance, position, heading;
    void archive(StateArchive& archive);
  };
  /// The ball in a camera's picture, or as the lens would show what a look saw.
  struct ShownBall {
    bool shown = false, visible = false;
    double u = 0, v = 0, radius = 0;  // [px]
  };
  ShownBall ballIn(const RobotCamera& camera) const;
  ShownBall ballIn(const OracleCamera& camera) const;
  static void judge(Account& account, const ShownBall& ball, int camera, const client::ControlReport& report);
  static void checkPose(Account& account, const client::ControlReport& report);

  Handle<Pose> ball_;
  std::uint16_t ball_label_ = 0;
  double ball_radius_ = 0;
  std::vector<Account> accounts_;
};

}  // namespace murosimf
