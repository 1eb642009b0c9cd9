#include "murosimf/algorithms/light/shutter.h"

#include <algorithm>

#include "murosimf/algorithms/label_boxes.h"
#include "murosimf/algorithms/light/light_filters.h"

namespace murosimf {

namespace {

constexpr int kBand = 16;  // rows that are cast together: those of a tile

Pose moved(const Pose& X, const SpatialMotion<double>& V, double t) {
  return {rotationExp(V.w * t) * X.rotation, X.translation + V.v * t};
}

/// One picture of moments that differ from band to band.
class Gathering {
 public:
  Gathering(const RayTable& rays, const RayScene& scene, const MovingCamera& camera,
            std::span<const std::uint32_t> hidden, const CastOptions& options, ShutterWork& work, Picture& picture)
      : rays_(rays),
        scene_(scene),
        camera_(camera),
        hidden_(hidden),
        options_(options),
        work_(work),
        picture_(picture) {
    work_.scene = scene;
  }
  /// Rows [first, last) as they are t after the snapshot.
  void cast(int first, int last, double t) {
    for (std::size_t i = 0; i < scene_.motions.size(); ++i)
      work_.scene.drawables[i].X_WS = moved(scene_.drawables[i].X_WS, scene_.motions[i], t);
    prepareScene(rays_, work_.scene, moved(camera_.X_WC, camera_.V_WC, t), hidden_, options_.shadows, work_.prepared);
    castRows(rays_, work_.prepared, options_, first, last, picture_);
  }

 private:
  const RayTable& rays_;
  const RayScene& scene_;
  const MovingCamera& camera_;
  std::span<const std::uint32_t> hidden_;
  const CastOptions& options_;
  ShutterWork& work_;
  Picture& picture_;
};

}  // namespace

void castThroughShutter(const RayTable& rays, const RayScene& scene, const MovingCamera& camera,
                        std::span<const std::uint32_t> hidden, const CastOptions& options, const Shutter& shutter,
                        ShutterWork& work, Picture& picture, LightPicture& light) {
  const int height = rays.camera().height, samples = shutter.exposure > 0 ? std::max(shutter.samples, 1) : 1;
  const int band = shutter.readout > 0 ? kBand : height;
  picture.resize(rays.camera().width, height);
  light.resize(picture.width, height);
  work.sample.resize(picture.width, height);
  CastOptions casting = options;
  casting.sensor = {};
  casting.light = samples > 1 ? &work.sample : &light;
  Gathering gathering(rays, scene, camera, hidden, casting, work, picture);
  for (std::vector<float>& plane : light.plane) std::fill(plane.begin(), plane.end(), 0.0F);
  for (int k = 0; k < samples; ++k) {
    const double before_end = shutter.exposure * (1 - (k + 0.5) / samples);
    for (int first = 0; first < height; first += band) {
      const int last = std::min(first + band, height);
      const double middle = 0.5 * (first + last - 1) / std::max(height - 1, 1);
      gathering.cast(first, last, -shutter.readout * (1 - middle) - before_end);
    }
    if (samples > 1) addLight(light, work.sample, 1.0F / static_cast<float>(samples));
  }
  if (picture.has_boxes) findBoxes(picture);
}

}  // namespace murosimf
