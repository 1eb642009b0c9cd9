#pragma once

/// @file Pictures of robots' cameras through OpenGL 3.3: colour, label and depth through any lens, in one pass.
///
/// Meshes   are bent by the lens corner by corner, fine enough that edges are within some 0.1 pixels (fine_meshes.h).
///          What lies behind the camera is clipped, not folded over (gl_lens.h); what lies nearer than kNear is cut
///          off.
/// Field    by the ray of each pixel (field_tiles.h), drawn last and only where nothing stands before it: lines are
/// exact, filtered by
///          the pixel's footprint as the ray caster does. No pixel is without a colour.
/// Limits   no shadows, no noise, no anti-aliasing; a picture on the carpet is refused. Colours of round surfaces are
///          interpolated between corners. Pictures differ between drivers; the ray caster is the reference.

#include <cstdint>
#include <span>
#include <vector>

#include "murosimf/algorithms/ray_scene.h"
#include "murosimf/render/fine_meshes.h"
#include "murosimf/render/gl/gl_atlas.h"
#include "murosimf/render/gl/gl_field.h"
#include "murosimf/render/gl/gl_lens.h"
#include "murosimf/render/gl/gl_meshes.h"

namespace murosimf {

class GlCameraRenderer {
 public:
  static constexpr double kNear = 0.01, kFar = 200;  ///< what is drawn of meshes, along the optical axis [m]

  /// The context must be current, here and at every call. @throws std::invalid_argument as GlField does
  explicit GlCameraRenderer(const PaintedGround& ground);

  /// Draws one picture of an atlas that has been cleared. The scene's ground must be the one given above; hidden:
  /// owners that this camera does not draw. marks_lines: as in Picture.
  void draw(const GlLens& lens, const RayScene& scene, const Pose& X_WC, std::span<const std::uint32_t> hidden,
            GlAtlas& atlas, std::size_t picture, bool marks_lines = false);
  /// Triangles of the last picture.
  std::size_t triangles() const { return triangles_; }

 private:
  using Instances = std::vector<std::vector<MeshInstance>>;
  void gather(const GlLens& lens, const RayScene& scene, const Pose& X_WC, std::span<const std::uint32_t> hidden);
  void add(const Drawable& drawable, int fineness);
  void drawMeshes(const GlLens& lens, const RayScene& scene, const Pose& X_WC, int first_row);
  void drawField(const GlLens& lens, const RayScene& scene, const Pose& X_WC, int first_row, bool marks_lines);
  void setField(const GlProgram& program, const RayScene& scene, int first_row) const;
  void drawTiles(const std::vector<TileVertex>& tiles);

  GlProgram lens_program_, bare_program_, paint_program_;
  GlField field_;
  FineMeshes fine_;
  GlMeshes meshes_;
  Instances closed_, open_;
  FieldTiles tiles_;
  GlVertexArray tile_array_;
  GlBuffer tile_vertices_;
  std::size_t triangles_ = 0;
};

}  // namespace murosimf
