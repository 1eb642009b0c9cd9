#include "murosimf/algorithms/pixel_motion.h"

#include <limits>
#include <stdexcept>

namespace murosimf {
namespace {

/// From the camera's frame now to its frame before, for each part: the drawables, then the ground, then the sky.
std::vector<Pose> waysBack(const RayScene& scene, const Pose& X_WC, std::span<const Pose> before,
                           const Pose& X_WC_before) {
  const Pose X_BW = inverse(X_WC_before);
  std::vector<Pose> ways;
  for (std::size_t i = 0; i < before.size(); ++i)
    ways.push_back(X_BW * before[i] * inverse(scene.drawables[i].X_WS) * X_WC);
  ways.push_back(X_BW * X_WC);
  ways.push_back({ways.back().rotation, {}});
  return ways;
}

}  // namespace

void findMotion(const RayTable& rays, const RayScene& scene, const Pose& X_WC, std::span<const Pose> before,
                const Pose& X_WC_before, Picture& picture) {
  const std::size_t pixels = static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
  if (before.size() != scene.drawables.size() || picture.part.size() != pixels || picture.depth.size() != pixels)
    throw std::invalid_argument("motion: expected a pose for every drawable, and a picture with depth and part");
  constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
  const std::vector<Pose> ways = waysBack(scene, X_WC, before, X_WC_before);
  const double farthest = validRadius(rays.camera());  // once: it is a search
  picture.motion.assign(pixels, {kNone, kNone});
  for (int v = 0; v < picture.height; ++v)
    for (int u = 0; u < picture.width; ++u) {
      const std::size_t i = picture.index(u, v);
      const std::int32_t part = picture.part[i];
      const bool sky = part == kSkyPart;
      const std::size_t way = part >= 0 ? static_cast<std::size_t>(part) : before.size() + (sky ? 1 : 0);
      const RaySlopes ray = rays.ray(u, v);
      const Vector3 p_C = Vector3{ray.x, ray.y, 1} * (sky ? 1.0 : static_cast<double>(picture.depth[i]));
      const Vector3 was_B = ways[way] * p_C;
      if (!(was_B.z > 0)) continue;
      const RaySlopes before_ray{was_B.x / was_B.z, was_B.y / was_B.z};
      if (before_ray.x * before_ray.x + before_ray.y * before_ray.y > farthest * farthest) continue;
      const ImagePoint was = project(rays.camera(), before_ray);
      picture.motion[i] = {static_cast<float>(u - was.u), static_cast<float>(v - was.v)};
    }
}

}  // namespace murosimf
