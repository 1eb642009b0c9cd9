#pragma once

/// @file Who makes the pictures of a camera, exchangeable camera by camera: the ray caster, or somebody else by name.
///
/// A maker turns a snapshot of the world into colours, and where they are wanted labels and depths. What follows
/// (picture modules, latency, formats) is the camera's and the same for all makers. To add one: write a PictureMaker,
/// and give its kind, by the name that scenarios call it, to who builds the cameras.

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "murosimf/algorithms/light/shutter.h"
#include "murosimf/algorithms/ray_caster.h"

namespace murosimf {

/// What a camera wants of all its pictures.
struct PictureWish {
  std::shared_ptr<const RayTable> rays;
  std::vector<std::uint32_t> hidden;  ///< owners of drawables that it does not show
  bool antialias = false, shadows = false, depth = false;
  Shutter shutter;
  ImageSensor sensor;                    ///< its key changes from picture to picture
  bool light = false;                    ///< wants the light too, and none of the sensor
  std::size_t most = 1;                  ///< pictures that are ordered and not fetched yet, at the same time
  CastLanes lanes = CastLanes::kWidest;  ///< of a maker that casts rays
};

/// One picture: of this snapshot, from here.
struct PictureOrder {
  const RayScene* scene = nullptr;
  MovingCamera place;
  std::uint64_t key = 0;  ///< of its noise
};

/// What draws, where that depends on the machine: "OpenGL 4.5: llvmpipe", and what is to be said of it.
struct PictureDrawer {
  std::string name, warning;
};

/// Makes the pictures of one camera. What a picture shows depends on its wish and its order alone.
class PictureMaker {
 public:
  PictureMaker() = default;
  PictureMaker(const PictureMaker&) = delete;
  PictureMaker& operator=(const PictureMaker&) = delete;
  virtual ~PictureMaker() = default;

  /// Frame thread. The scene stays as it is until settle() has returned or, of a prompt maker, fetch().
  virtual void order(const PictureOrder& order) = 0;
  /// Frame thread, when all cameras have ordered: what they share may go to work.
  virtual void start() {}
  /// Any thread: returns when the scenes of all orders are needed no longer. Of a prompt maker: at once.
  virtual void settle() {}
  /// Waits for the oldest picture that was ordered. Overwrites both; light is only made where it was wished for.
  virtual void fetch(Picture& picture, LightPicture& light) = 0;
  /// It makes pictures within fetch(), which is to be called at once.
  virtual bool isPrompt() const = 0;
  virtual PictureDrawer drawer() const = 0;
};

/// What a kind of maker can do besides colours, labels and depths through any lens.
struct PictureAbilities {
  bool antialias = false, shadows = false, shutter = false;
  bool texture = false;  ///< a picture on the carpet
  bool sensor = false;   ///< the sensor's work where no light is wished for; without it light is, for gain and noise
};

struct PictureMakerKind {
  std::string name;  ///< as scenarios call it
  PictureAbilities can;
  std::string missing;  ///< why this program has none, and what to do about it; empty: it has
  /// For cameras above this ground. @throws std::exception saying what this machine lacks
  std::function<std::unique_ptr<PictureMaker>(const PictureWish&, const PaintedGround&)> make;
};

/// By name. No map is without the ray caster.
using PictureMakers = std::map<std::string, std::shared_ptr<const PictureMakerKind>, std::less<>>;

/// "ray_caster": one ray a pixel (ray_caster.h), all abilities, prompt.
const std::shared_ptr<const PictureMakerKind>& rayCasterKind();
/// It alone.
PictureMakers rayCasterAlone();

}  // namespace murosimf
