#pragma once

/// @file The way to the ball and the kick: go behind it, line up, stop, kick.
///
/// With the ball at b, the direction to play psi and the kicking foot's side s (+1 left), the kick pose is
/// b - Rz(psi) (x, s y) with heading psi, where (x, y) is the middle of the KickZone; s follows the ball's side in R.
/// The robot first goes to a point behind the kick pose, around the ball if need be, then straight to it, slowly, and
/// stops as soon as the ball lies in the kick zone and the heading promises enough.

#include "body_motion.h"
#include "head_motion.h"
#include "shot_choice.h"
#include "situation.h"
#include "walk_path.h"

namespace murosimf::controllers {

/// What the behaviour wants of the body and the head.
struct Decision {
  MotionRequest motion;
  HeadRequest::Kind head = HeadRequest::Kind::kBallAndField;
  const char* activity = "";
};

class BallApproach {
 public:
  /// Forgets the foot and the time spent; for a new ball or after a kick.
  void restart();
  /// Steps aside for a while: the ball cannot be played now.
  void giveWay();
  /// Decides for this step. The ball must be known.
  Decision step(const Situation& now, const Pitch& pitch);
  /// Estimated time to the kick from here [s].
  static double cost(const Situation& now, const Pitch& pitch);
  void archive(client::StateArchive& archive);

 private:
  enum class Stage : std::uint8_t { kGoBehind, kLineUp, kStop };

  void chooseDirection(const Situation& now, const Pitch& pitch);
  void chooseFoot(const Point& ball_R);
  PlanarPose kickPose(const Point& ball_R, double back) const;
  bool ballInZone(const Point& ball_R, double margin_x, double margin_y) const;
  bool worthKicking(const Situation& now) const;
  Decision goBehind(const Situation& now);
  Decision lineUp(const Situation& now);
  Decision stopAndKick(const Situation& now);
  Decision stepAside(const Situation& now) const;
  bool gaveUp(const Situation& now);

  ShotChoice shot_;  ///< computed anew in every step, so not archived
  Stage stage_ = Stage::kGoBehind;
  int foot_ = kRight;
  bool foot_chosen_ = false;
  double direction_R_ = 0;   ///< psi, in R [rad]
  double best_value_ = 0;    ///< of the chosen direction
  double time_near_ = 0;     ///< spent within reach of the ball [s]: makes the robot less choosy
  double retreat_left_ = 0;  ///< of stepping aside from a ball that another robot keeps from being reached [s]
};

}  // namespace murosimf::controllers
