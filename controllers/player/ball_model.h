#pragma once

/// @file Where the ball is, as one robot sees it.
///
/// A BallFilter, guarded: a sight outside the gate does not touch the estimate but founds a rival; when the next
/// sights agree with the rival (2 when the ball is not known, else 3) it takes over, with the velocity of its way.
/// So a single wrong percept never moves the ball, and a kick is followed within three pictures. Within the gate,
/// errors that stay too large (a running mean of e^T S^-1 e / 2, which is 1 when all is well) tell of a push: the
/// velocity is set free.

#include "ball_filter.h"
#include "murosimf/control/client/robot_description.h"
#include "murosimf/control/client/state_archive.h"
#include "percepts.h"

namespace murosimf::controllers {

/// The ball in the robot's frame R, with velocity.
class BallModel {
 public:
  void start(const client::RobotDescription& robot);
  void move(const PlanarPose& increment, double dt);
  void observe(const Percepts& percepts);
  /// Seen recently enough to act on: within 3 s, within 6 s when it lay still.
  bool known() const;
  double age() const { return age_; }  ///< since it was last seen [s]; 1e9 when never
  Vector3 position() const;            ///< x, y in R [m], z 0
  Vector3 velocity() const;            ///< x, y in R's axes [m/s], of the ball over the ground
  void forget();
  void archive(client::StateArchive& archive);

 private:
  /// Sights that contradict the estimate but agree with each other. Positions are kept in R.
  struct Rival {
    BallSight last;
    Point first;             ///< where its first sight was
    double since_first = 0;  ///< [s]
    double since_last = 0;   ///< [s]
    int sights = 0;          ///< 0: no rival
    void archive(client::StateArchive& archive) { archive(last, first, since_first, since_last, sights); }
  };
  void observeOutlier(const BallSight& sight);
  void takeOver();
  void agree(const BallSight& sight, double squared_error);

  BallFilter filter_;
  Rival rival_;
  double age_ = 1e9;
  double surprise_ = 1;  ///< running mean of half the squared error
};

}  // namespace murosimf::controllers
