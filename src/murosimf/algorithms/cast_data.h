#pragma once

/// @file What the ray caster's kernels read and write: plain numbers without functions, alike for every instruction
/// set.
///
/// Everything is seen from camera frame C along rays d = (x, y, 1), and told by inverse depth w = 1 / z [1/m]:
/// the point of a ray is d / w, a larger w is nearer, w = 0 is the sky. A plane n . p = e is met at w = (n . d) / e,
/// which is linear in x and y: no division, no case for rays that run along it.

#include <cstdint>

#include "murosimf/algorithms/cast_mesh_data.h"
#include "murosimf/algorithms/cast_texture_data.h"

namespace murosimf {

inline constexpr int kTileSize = 16;  ///< [px]
inline constexpr int kTilePixels = kTileSize * kTileSize;
inline constexpr int kLanesAtMost = 16;  ///< arrays that are read in packs are filled up to a multiple of this

/// What is known of the rays of one tile.
struct TileRays {
  float x_low, x_high, y_low, y_high;             ///< rectangle of slopes that holds all rays of the tile
  float x_u, x_v, y_u, y_v;                       ///< change of slopes from one pixel to the next: right (u), down (v)
  float row_low[kTileSize], row_high[kTileSize];  ///< range of y in each row
  float column_low[2], column_high[2];            ///< range of x in the left and the right half
};

/// x a + y b + c of slopes (a, b).
struct LinearForm {
  float x, y, one;
};

/// xx a^2 + xy a b + yy b^2 + x a + y b + one of a = slope x - x0, b = slope y - y0. Taken about the middle of what it
/// describes, where its terms are small, so that float is enough.
struct QuadraticForm {
  float x0, y0, xx, xy, yy, x, y, one;
};

enum class CastKind : std::int32_t { kBox, kEllipsoid, kCylinder, kCapsule, kMesh, kShadow };

/// One surface, ready to be met by rays. Fields that a kind does not name are not set.
struct CastSurface {
  CastKind kind;
  float label;        ///< all: uint16 as a float
  CastColour colour;  ///< curved ones: in full light
  // Box: a ray is inside between the last front plane and the first back plane.
  LinearForm plane[6];         ///< w of the planes, those that face the camera first
  CastColour plane_colour[3];  ///< lit, of those that face the camera
  float plane_light[3];        ///< that falls on them
  std::int32_t fronts;         ///< how many face the camera: 1 to 3
  // Ellipsoid, and side of a cylinder or capsule: w = sqrt(root) + rest where root >= 0.
  QuadraticForm root;
  LinearForm rest;
  // Ellipsoid: gradient of the surface times w = gradient_w w + gradient.
  LinearForm gradient[3];
  float gradient_w[3];
  // Cylinder, capsule: height above the middle times w, in half lengths = axis_w w + axis; the same for the two axes
  // across.
  LinearForm axis[3];
  float axis_w[3];
  LinearForm side_light;  ///< cosine between side and lamp = side_light_w + side_light / w
  float side_light_w;
  LinearForm cap;         ///< w of the cap that faces the camera
  CastColour cap_colour;  ///< lit
  float cap_light;        ///< that falls on it
  std::int32_t has_side, has_cap;
  // Ends of a capsule, as an ellipsoid's root and rest; cosine between one and the lamp = end_light_w + end_light / w.
  QuadraticForm end_root[2];
  LinearForm end_rest[2], end_light;
  float end_light_w[2];
  std::int32_t mesh;  ///< mesh: index into CastScene::meshes
  // Shadow: (offset from its middle / radius) w on the ground, and the share of light it takes there.
  LinearForm offset[2];
  float strength;
};

/// Surfaces that may appear in one row of tiles: their rectangles of slopes, front to back.
struct CastRow {
  const float *x_low, *x_high, *y_low, *y_high;  ///< filled up with empty rectangles
  const std::int32_t* surface;                   ///< index into CastScene::surfaces
  std::int32_t count;
};

/// A painted ring: offset from the centre times w, radius and half its line's width [m].
struct CastRing {
  LinearForm x, y;
  float radius, half_width;
};

/// The ground: w, and what is painted on it. Strip 0 is the carpet.
struct CastGround {
  LinearForm w;     ///< inverse depth; below 0 above the horizon
  float w_far;      ///< nothing is painted where w is smaller; > 0
  LinearForm x, y;  ///< offset from the camera's foot point times w [m]
  float height;     ///< of the camera above the ground [m]
  /// Strips: distance from the middle, across and along, times w; half sizes [m]. Arrays of strip_count, filled up.
  const float *across_x, *across_y, *across_one, *along_x, *along_y, *along_one, *half_width, *half_length;
  std::int32_t strip_count;
  const CastRing* rings;
  std::int32_t ring_count;
  CastColour carpet, surroundings, paint, sky;  ///< lit
  float light;                                  ///< that falls on the ground
  CastTexture texture;                          ///< of the carpet, none where it has no levels
  LinearForm texel_u, texel_v;                  ///< place in texels of the largest level, from 0 on, times w
  float texture_light;                          ///< factor on the picture's colours
};

struct CastScene {
  CastGround ground;
  const CastSurface* surfaces;
  const CastMeshView* meshes;
  const CastRow* rows;          ///< of tiles
  float lamp[3];                ///< unit vector towards the lamp, in C
  float ambient;                ///< share of light from everywhere
  std::int32_t has_shadows;     ///< soft patches beneath drawables
  const CastScene* lamp_scene;  ///< what throws shadows, as the lamp sees it; null: no hard shadows
  LinearForm lamp_place[3];     ///< a point as the lamp sees it, times w: place x, y and height [m]
};

/// Rows [first_row, last_row) of one picture.
struct CastJob {
  const CastScene* scene;
  const float *x, *y;  ///< slopes: [tile][row][column]
  const TileRays* tiles;
  std::int32_t tile_columns, width, height, first_row, last_row;
  std::uint8_t* rgb;
  float* depth;                     ///< null: not wanted
  std::uint16_t* label;             ///< null: not wanted
  std::int32_t* part;               ///< null: not wanted
  float* light[3];                  ///< red, green, blue before the sensor; null: not wanted
  const std::int32_t* part_of;      ///< part of what TileBuffer::surface counts from -2 on
  float gain, deviation;            ///< in bytes: 255 times those of ImageSensor
  std::uint32_t key_low, key_high;  ///< of the noise
  std::int32_t antialias, marks_lines;
};

}  // namespace murosimf
