#pragma once

/// @file Where the robot stands: a few extended Kalman filters that compete (multiple-hypothesis localisation).
///
/// Each hypothesis is a PoseBelief with a weight. A sight z of a landmark that may be one of n corrects the hypothesis
/// by the nearest, if it lies within the gate and no other is almost as near, and multiplies the weight by
///     (1 - f)/n sum_i N(z; h_i, S_i) + f u,    f: share of false percepts, u: their density.
/// Points of lines correct by their distance from the nearest line of the map, and weigh alike.
/// When the best hypothesis fails to explain what is seen (doubt), every pair of landmarks seen lately proposes poses;
/// they start with a small weight and win if they explain what is seen next. Unlikely ones and doubles are dropped.
/// Robust against wrong percepts, slip, being blocked, pushed or carried away, and deterministic: no random numbers.
///
/// Cost       about 10 microseconds per picture with 3 landmarks and 15 line points; no allocation.
/// Source     [Jensfelt & Kristensen 2001], [Roumeliotis & Bekey 2000]; gating as in [Thrun, Burgard, Fox 2005, 7.4].

#include "landmark_memory.h"

namespace murosimf::controllers {

/// A point of a line, prepared for comparison with the map.
struct LineSight {
  Point p_R;
  double distance = 0;      ///< from the robot [m]
  SinCos<double> normal{};  ///< of the direction across the line, in R
};

/// Self-localisation on the field in the team's own frame (+x: towards the goal attacked).
class Localisation {
 public:
  void start(const client::RobotDescription& robot);
  /// The robot was put somewhere by hand and told so.
  void place(const PlanarPose& pose);
  /// Moves by one odometry increment (pose of the new R in the old R).
  void move(const PlanarPose& increment);
  /// Corrects by landmarks and lines. Percepts that are no numbers or lie off any field are skipped.
  void observe(const Percepts& percepts);
  /// Something moved the robot in a way that odometry cannot know, a fall for example: adds uncertainty [m], [rad].
  void widen(double position_deviation, double heading_deviation);
  PlanarPose pose() const { return beliefs_[0].mean; }
  /// Standard deviations of position [m] and heading [rad] that the estimate claims, other hypotheses included.
  double positionDeviation() const;
  double headingDeviation() const;
  void archive(client::StateArchive& archive);

 private:
  static constexpr std::size_t kCapacity = 8;
  static constexpr std::size_t kLineCapacity = 12;

  void observeLandmark(LandmarkKind kind, const LandmarkPercept& percept);
  void judge(PoseBelief& belief, const LandmarkSight& sight) const;
  void observeLines(const std::vector<LinePercept>& percepts);
  void judge(PoseBelief& belief, std::span<const LineSight> lines) const;
  void propose(const LandmarkSight& sight);
  void enter(const PoseBelief& proposal);
  /// Orders by weight, drops what is unlikely or double, keeps positions on the carpet.
  void tidy();

  FieldMap map_;  ///< from start(), never changes
  LandmarkMemory memory_;
  std::array<PoseBelief, kCapacity> beliefs_{};  ///< best first
  std::size_t count_ = 1;
};

}  // namespace murosimf::controllers
