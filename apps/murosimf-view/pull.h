#pragma once

/// @file A person's hand: a damped spring between a body and the mouse, as strong as the body's owner is heavy.
///
///     f = m (w^2 (target - p) - 2 w v),  w = 8 rad/s: critically damped, and the same pull for light and heavy things;
///     |f| <= 20 m g
/// m: mass of the whole object; p, v: place and velocity of the point that was taken hold of, v from its last two
/// places.

#include <optional>
#include <string>

#include "murosimf/simulation/frame_history.h"

namespace murosimf {

class Pull {
 public:
  /// Takes hold of a robot's body on a row, or of a free body, at a place in W.
  Pull(Simulation& simulation, ObjectId object, int row, const Vector3& p_W);

  Vector3 target_W;  ///< where the mouse is
  /// Asks for the push of the next frame.
  void request(Simulation& simulation, FrameHistory& history);
  /// Where it holds the body now.
  Vector3 place(Simulation& simulation) const;
  /// Why something does not feel a pull: it never moves, or its motion is prescribed. Empty where it does.
  static std::string refusal(Simulation& simulation, ObjectId object);

 private:
  ObjectId object_;
  int row_;
  double mass_;
  Vector3 p_B_;
  std::optional<Vector3> last_W_;
};

}  // namespace murosimf
