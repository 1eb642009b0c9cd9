#pragma once

/// @file Pictures of a scene by casting one ray a pixel through the camera's own lens.
///
/// Method     A ray (x, y, 1) meets every surface at an inverse depth w = 1 / z that needs no division: planes are
///            linear in x and y, ellipsoids, cylinders and capsules a root of a quadratic form. The largest w is seen.
///            Meshes: cast_mesh.h.
///            Tiles of 16 x 16 pixels keep what may appear in them, by rectangles of slopes; painted lines are filtered
///            by the pixel's footprint on the ground, so distant lines grow faint instead of flickering.
/// Same bits  for 1, 8 and 16 lanes, for g++ and clang, for any cutting into bands: only IEEE +, -, *, /, sqrt on
/// float,
///            never fused; culling only leaves out what would not have been seen.
/// Cost       640 x 480 with 170 objects: see bench/camera_benchmark.cpp. No allocation after the first picture.
/// Limits     camera above the ground (a lower one sees as from 1 mm above it) and outside every drawable; a drawable
///            that holds the camera is not drawn, nor is a closed mesh seen from within.

#include <cstdint>
#include <span>
#include <string_view>

#include "murosimf/algorithms/light/light_picture.h"
#include "murosimf/algorithms/prepared_scene.h"
#include "murosimf/algorithms/ray_scene.h"
#include "murosimf/algorithms/ray_table.h"

namespace murosimf {

/// What the image sensor does to the light: byte = 255 clamp(gain c + deviation g), g standard normal for every pixel
/// and channel, by its place and the key alone.
struct ImageSensor {
  float gain = 1.0F;
  float deviation = 0.0F;  ///< standard deviation of the noise, 1 = full scale
  std::uint64_t key = 0;   ///< from noiseKey()
};

/// The key of one picture's noise.
std::uint64_t noiseKey(std::uint64_t seed, std::string_view camera_name, std::uint64_t frame);

/// How many pixels are worked on together. The picture is the same; kWidest asks the machine.
enum class CastLanes : std::uint8_t { kWidest, kOne, kEight, kSixteen };
/// True where the machine can: 16 lanes need AVX-512.
bool isSupported(CastLanes lanes);

struct CastOptions {
  ImageSensor sensor;
  bool antialias = false;  ///< four samples where a row of a tile sees more than one thing: silhouettes, shadows' edges
  bool shadows = false;    ///< the lamp's, with hard edges, on ground and drawables; in the place of soft patches
  CastLanes lanes = CastLanes::kWidest;
  LightPicture* light = nullptr;  ///< of the picture's size: takes what would reach the sensor, besides the bytes
};

/// Puts a scene into the camera's frame, sorts it front to back, drops what the camera does not show. Overwrites work.
/// X_WC: pose of the camera (x right, y down, z forward). hidden: owners that this camera does not draw;
/// their shadows stay. shadows: as in CastOptions. For a rolling shutter, prepare and cast band by band with the pose
/// of each.
void prepareScene(const RayTable& rays, const RayScene& scene, const Pose& X_WC, std::span<const std::uint32_t> hidden,
                  bool shadows, PreparedScene& work);

/// Fills rows [first_row, last_row) of a picture that has been given its size. Several threads may share one prepared
/// scene and one picture when their rows differ; bands that start at multiples of 16 waste no work.
void castRows(const RayTable& rays, const PreparedScene& work, const CastOptions& options, int first_row, int last_row,
              Picture& picture);

/// All of it: gives the picture its size and fills it.
void castPicture(const RayTable& rays, const RayScene& scene, const Pose& X_WC, std::span<const std::uint32_t> hidden,
                 const CastOptions& options, PreparedScene& work, Picture& picture);

/// The pose X_WC of a camera at `eye` that looks at `target`, upright (row 0 of its picture on top).
Pose lookAt(const Vector3& eye_W, const Vector3& target_W);

}  // namespace murosimf
