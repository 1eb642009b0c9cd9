#include "murosimf/algorithms/ray_caster.h"

#include <algorithm>
#include <cmath>

#include "murosimf/algorithms/label_boxes.h"
#include "murosimf/algorithms/ray_caster_kernel.h"
#include "murosimf/algorithms/scene_preparation.h"
#include "murosimf/math/random.h"

namespace murosimf {

// The kernels of the two instruction sets: ray_caster_v3.cpp, ray_caster_v4.cpp.
inline namespace isa_v3 {
void castTilesInLanes(const CastJob& job);
}
namespace isa_v4 {
void castTilesInLanes(const CastJob& job);
}

namespace {

using CastFunction = void (*)(const CastJob&);

CastFunction castFunction(CastLanes lanes) {
  if (lanes == CastLanes::kWidest) lanes = isSupported(CastLanes::kSixteen) ? CastLanes::kSixteen : CastLanes::kEight;
  if (lanes == CastLanes::kSixteen) return isa_v4::castTilesInLanes;
  return lanes == CastLanes::kEight ? isa_v3::castTilesInLanes : castTiles<float>;
}

}  // namespace

std::uint64_t noiseKey(std::uint64_t seed, std::string_view camera_name, std::uint64_t frame) {
  constexpr std::uint64_t kPixelNoise = 0x70697865;  // stream of its own
  return RandomStream(seed, camera_name, kPixelNoise).bits(frame);
}

bool isSupported(CastLanes lanes) {
  if (lanes != CastLanes::kSixteen) return true;
  return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
         __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
}

void prepareScene(const RayTable& rays, const RayScene& scene, const Pose& X_WC, std::span<const std::uint32_t> hidden,
                  bool shadows, PreparedScene& work) {
  const CameraView view = viewOf(scene, X_WC);
  work.surfaces.clear(), work.meshes.clear(), work.extents.clear();
  work.cast.has_shadows = 0;
  work.part_of = {kSkyPart, kGroundPart};
  for (const Drawable& drawable : scene.drawables) {
    if (std::find(hidden.begin(), hidden.end(), drawable.owner) == hidden.end()) addSurface(view, drawable, work);
    if (scene.ground_shadows && !shadows) addShadow(view, drawable, work);
    work.part_of.resize(2 + work.surfaces.size(), static_cast<std::int32_t>(&drawable - scene.drawables.data()));
  }
  setGround(view, scene, work);
  for (int i = 0; i < 3; ++i) work.cast.lamp[i] = static_cast<float>(view.lamp_C[i]);
  work.cast.ambient = static_cast<float>(view.ambient);
  sortIntoRows(rays, work);
  work.cast.lamp_scene = nullptr;
  if (shadows) setCasters(view, scene, work);
}

void castRows(const RayTable& rays, const PreparedScene& work, const CastOptions& options, int first_row, int last_row,
              Picture& picture) {
  CastJob job;
  job.scene = &work.cast;
  job.x = rays.x(), job.y = rays.y(), job.tiles = rays.tiles();
  job.tile_columns = rays.tileColumns();
  job.width = rays.camera().width, job.height = rays.camera().height;
  job.first_row = std::max(first_row, 0), job.last_row = std::min(last_row, job.height);
  job.rgb = picture.rgb.data();
  job.depth = picture.depth.empty() ? nullptr : picture.depth.data();
  job.label = picture.label.empty() ? nullptr : picture.label.data();
  job.part = picture.part.empty() ? nullptr : picture.part.data(), job.part_of = work.part_of.data();
  for (std::size_t i = 0; i < 3; ++i) job.light[i] = options.light ? options.light->plane[i].data() : nullptr;
  job.marks_lines = picture.marks_lines;
  job.gain = 255.0F * options.sensor.gain, job.deviation = 255.0F * options.sensor.deviation;
  job.key_low = static_cast<std::uint32_t>(options.sensor.key);
  job.key_high = static_cast<std::uint32_t>(options.sensor.key >> 32);
  job.antialias = options.antialias;
  castFunction(options.lanes)(job);
}

void castPicture(const RayTable& rays, const RayScene& scene, const Pose& X_WC, std::span<const std::uint32_t> hidden,
                 const CastOptions& options, PreparedScene& work, Picture& picture) {
  picture.resize(rays.camera().width, rays.camera().height);
  prepareScene(rays, scene, X_WC, hidden, options.shadows, work);
  castRows(rays, work, options, 0, picture.height, picture);
  if (picture.has_boxes) findBoxes(picture);
}

Pose lookAt(const Vector3& eye_W, const Vector3& target_W) {
  const Vector3 forward = normalized(target_W - eye_W);
  const bool steep = std::fabs(forward.z) > 0.999999;  // no upright direction is left: row 0 then lies towards +x
  const Vector3 up = steep ? Vector3{1, 0, 0} : Vector3{0, 0, 1};
  const Vector3 right = normalized(cross(forward, up));
  return {{right, cross(forward, right), forward}, eye_W};
}

}  // namespace murosimf
