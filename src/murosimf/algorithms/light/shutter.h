#pragma once

/// @file How a sensor gathers light over time: rolling shutters and motion blur, along the motion of camera and things.
///
/// Row v of H is exposed from T_v - exposure to T_v,
///     T_v = T - readout (1 - v / (H - 1)),
/// T the moment of the snapshot, which is the end of the last row. Within that time camera and drawables move straight
/// on and turn evenly, as they do at T: what they did otherwise some milliseconds ago is left out. Blur is the mean of
/// `samples` moments, evenly spread; a rolling picture is cast in bands of 16 rows, each at its own time.
/// Cost: one picture a sample, and the scene's preparation once a band.

#include <span>

#include "murosimf/algorithms/light/light_picture.h"
#include "murosimf/algorithms/ray_caster.h"

namespace murosimf {

struct Shutter {
  double readout = 0;   ///< from the first row's end to the last one's [s]; 0: all rows at once
  double exposure = 0;  ///< [s]; 0: a moment
  int samples = 8;      ///< of blur; one where exposure is 0
  /// Middle of the exposure of the middle row, before T [s].
  double age() const { return 0.5 * (readout + exposure); }
};

/// Memory that is used again.
struct ShutterWork {
  RayScene scene;
  PreparedScene prepared;
  LightPicture sample;
};

/// A camera and how it moves at T: twist (w; v) of its frame's origin, world axes.
struct MovingCamera {
  Pose X_WC;
  SpatialMotion<double> V_WC;
};

/// Gathers the light of a picture; scene.motions tells how drawables move. Overwrites picture, whose depths and labels
/// are those of each row's last sample, and light. The sensor of `options` is not asked.
void castThroughShutter(const RayTable& rays, const RayScene& scene, const MovingCamera& camera,
                        std::span<const std::uint32_t> hidden, const CastOptions& options, const Shutter& shutter,
                        ShutterWork& work, Picture& picture, LightPicture& light);

}  // namespace murosimf
