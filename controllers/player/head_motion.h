#pragma once

/// @file Where the head looks: sweeps in search of the ball, follows it, glances at landmarks in between.
///
/// Pan and tilt point the head camera's axis at a point. With z the height of the point over the tilt axis, r its
/// distance along the ground, D = |(r, z)| and e the height of the camera over the tilt axis:
/// tilt = atan2(-z, r) + asin(e / D), positive downwards.

#include "ks21.h"
#include "murosimf/control/client/state_archive.h"
#include "plane.h"
#include "posture.h"

namespace murosimf::controllers {

struct HeadRequest {
  enum class Kind : std::uint8_t {
    kSearch,        ///< sweep far and near
    kWatchBall,     ///< nothing but the ball
    kBallAndField,  ///< the ball, with a glance at `landmark` now and then
    kLookAround,    ///< sweep at the height of landmarks: the ball can wait
    kAhead,         ///< straight ahead: the body needs its head still
  };
  Kind kind = Kind::kSearch;
  Vector3 ball;      ///< in R [m]
  Vector3 landmark;  ///< in R [m], used where has_landmark
  bool has_landmark = false;
};

struct HeadAngles {
  double pan = 0, tilt = 0;  ///< [rad], tilt positive downwards
};

/// Angles that point the head camera at p_R, within the joints' ranges.
HeadAngles lookAt(const Posture& posture, const Vector3& p_R);

class HeadMotion {
 public:
  /// Advances by dt [s]. @return angles to command; they change by 3 rad/s at most, so that pictures stay sharp.
  HeadAngles step(double dt, const HeadRequest& request, const Posture& posture);
  /// True while the head looks at a landmark instead of the ball.
  bool glancing() const { return glance_left_ > 0; }
  void archive(client::StateArchive& archive);

 private:
  HeadAngles searchTarget(const HeadRequest& request);
  HeadAngles watchTarget(double dt, const HeadRequest& request, const Posture& posture);

  HeadAngles commanded_;
  std::size_t sweep_ = 0;   ///< corner of the sweep that the head moves to
  double watched_ = 0;      ///< since the last glance [s]
  double glance_left_ = 0;  ///< of the present glance [s]
};

}  // namespace murosimf::controllers
