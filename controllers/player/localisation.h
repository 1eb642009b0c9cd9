#pragma once

/// @file Where the robot stands: a few extended Kalman filters that compete (multiple-hypothesis localisation).
///
/// Each hypothesis is a PoseBelief with a weight. A sight z of a landmark that may be one of n corrects the hypothesis
/// by the nearest, if it lies within the gate and no other is almost as near, and multiplies the weight by
///     (1 - f)/n sum_i N(z; h_i, S_i) + f u,    f: share of false percepts, u: their density.
/// Points of lines correct by their distance from the nearest line of the map, and weigh alike.
/// When the best hypothesis fails to explain what is seen (doubt), every pair of landmarks seen lately proposes poses,
/// and when that does not help, one landmark with the direction of the lines. They start with a small weight and win
/// if they explain what is seen next. Unlikely ones and doubles are dropped.
/// Robust against wrong percepts, slip, being blocked, pushed or carried away, and deterministic: no random numbers.
///
/// Cost       a few microseconds per picture with 3 landmarks and 12 line points; no allocation.
/// Source     [Jensfelt & Kristensen 2001], [Roumeliotis & Bekey 2000]; gating as in [Thrun, Burgard, Fox 2005, 7.4].

#include "landmark_memory.h"
#include "line_sights.h"

namespace murosimf::controllers {

/// Self-localisation on the field in the team's own frame (+x: towards the goal attacked).
class Localisation {
 public:
  void start(const client::RobotDescription& robot);
  /// The robot was put somewhere by hand and told so. A pose far off any field is skipped.
  void place(const PlanarPose& pose);
  /// Moves by one odometry increment (pose of the new R in the old R).
  void move(const PlanarPose& increment);
  /// Corrects by landmarks and lines. Percepts that are no numbers or lie off any field are skipped.
  void observe(const Percepts& percepts);
  /// Something moved the robot in a way that odometry cannot know, a fall for example: adds uncertainty [m], [rad].
  void widen(double position_deviation, double heading_deviation);
  PlanarPose pose() const { return beliefs_[0].mean; }
  /// Standard deviations of position [m] and heading [rad] that the estimate claims: of the best hypothesis, of the
  /// others about it by their weights, and more while it fails to explain what is seen.
  double positionDeviation() const;
  double headingDeviation() const;
  void archive(client::StateArchive& archive);

 private:
  static constexpr std::size_t kCapacity = 8;

  void observeLandmark(LandmarkKind kind, const LandmarkPercept& percept, const LineSights& lines);
  void judge(PoseBelief& belief, const LandmarkSight& sight) const;
  void judge(PoseBelief& belief, const LineSights& lines) const;
  void propose(const LandmarkSight& sight, const LineSights& lines);
  void enter(const PoseProposals& proposals);
  void enter(const PoseBelief& proposal);
  /// Orders by weight, drops what is unlikely or double, keeps positions on the carpet.
  void tidy();
  /// 0 as long as at most one sight is unexplained, 1 when nothing is explained.
  double doubtShare() const;

  FieldMap map_;  ///< from start(), never changes
  LandmarkMemory memory_;
  std::array<PoseBelief, kCapacity> beliefs_{};  ///< best first
  std::size_t count_ = 1;
};

}  // namespace murosimf::controllers
