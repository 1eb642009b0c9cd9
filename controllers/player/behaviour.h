#pragma once

/// @file The player's decisions: who goes to the ball, what the others do, what happens around kick-off.
///
/// No script and no memory but a few timers: every step the most urgent of these holds
///   fallen                        leave the body to get up
///   not playing or penalised      stand
///   opponents' kick-off           wait until the ball moves, 10 s at most
///   a runner on a course          go along it (CourseRun)
///   kick under way                watch the ball
///   nobody knows the ball         search: sweep the head, then turn, then walk home
///   first to reach the ball       approach, line up, kick (BallApproach)
///   otherwise                     keep the place of one's role (positions.h)

#include "ball_approach.h"
#include "course_run.h"
#include "positions.h"
#include "situation.h"
#include "team_ball.h"

namespace murosimf::controllers {

/// Decision of one step and what team mates should know of it.
struct Play {
  MotionRequest motion;
  HeadRequest head;
  double cost_to_ball = 1e9;  ///< time until a kick [s]; 1e9 for a player that leaves the ball to others
  const char* activity = "";
};

class Behaviour {
 public:
  void start(const client::RobotDescription& robot);
  Play step(const Situation& now, bool head_glances);
  /// The robot or the ball was put elsewhere by hand.
  void restart();
  void archive(client::StateArchive& archive);

 private:
  /// The ball as far as anybody on the team knows.
  struct BallPlace {
    bool known = false;
    Point p_F;
  };

  bool runs(const Situation& now) const { return now.role == Role::kRunner && course_.there(); }
  void dropPlay();
  void updateKickoff(const Situation& now);
  static BallPlace ballPlace(const Situation& now);
  double ownCost(const Situation& now, const BallPlace& ball) const;
  bool goesToBall(const Situation& now, const BallPlace& ball);
  Decision decide(const Situation& now, const BallPlace& ball);
  Decision search(const Situation& now);
  Decision play(const Situation& now, const BallPlace& ball);
  void judgeKick(const Situation& now);
  bool leavesBallToOpponent(const Situation& now);
  Decision attack(const Situation& now, const BallPlace& ball);
  Decision keepPlace(const Situation& now, const Point& place_F, const Point& facing_F, const char* activity);
  HeadRequest headRequest(const Situation& now, HeadRequest::Kind kind, bool head_glances);
  Vector3 landmark(const Situation& now) const;

  Pitch pitch_;
  BallApproach approach_;
  CourseRun course_;
  client::GamePhase phase_ = client::GamePhase::kReady;  ///< of the step before
  bool waits_ = false;                                   ///< for the opponents' kick-off
  double waited_ = 0;                                    ///< [s]
  bool waits_saw_ball_ = false;
  Point waits_ball_R_;      ///< the ball when the wait began
  bool attacks_ = false;    ///< went to the ball in the step before
  bool at_place_ = false;   ///< stands where its role wants it
  double searched_ = 0;     ///< since the ball was known [s]
  bool kicked_ = false;     ///< in the step before
  Point kick_place_F_;      ///< of the ball at the start of the kick
  int blocked_kicks_ = 0;   ///< in a row
  double left_for_ = 0;     ///< the ball has been left to an opponent [s]
  double last_side_ = 1;    ///< where the ball was last: +1 left, -1 right
  bool last_near_ = false;  ///< the ball was at the feet when it was last seen
  int landmark_ = 0;
  double cost_ = 1e9;  ///< told to team mates
};

}  // namespace murosimf::controllers
