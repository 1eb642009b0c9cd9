#pragma once

/// @file Draws lists through OpenGL 3.3: instanced meshes, paint on the ground, lines; one lamp, shadows if wanted.
///
/// Cost: one call a mesh, whatever the number of its instances; shadows draw all of them twice.

#include "murosimf/algorithms/camera_model.h"
#include "murosimf/math/transform.h"
#include "murosimf/render/draw_list.h"
#include "murosimf/render/gl/gl_meshes.h"
#include "murosimf/render/gl/gl_object.h"
#include "murosimf/render/gl/gl_program.h"
#include "murosimf/render/gl/gl_target.h"

namespace murosimf {

/// From where, and through which lens: its distortion is left out.
struct GlView {
  CameraModel camera;
  Pose X_WC;
  double near = 0.02, far = 400;  ///< what is drawn, along the optical axis [m]
};

/// Light and sky, as algorithms/ray_scene.h has them.
struct GlLight {
  Vector3 light_W{0.3, 0.2, 0.93};
  float ambient = 0.55F;
  Colour sky{0.62F, 0.68F, 0.74F};
  bool shadows = false;
  Vector3 shadow_centre_W;  ///< middle of the region with shadows
  double shadow_reach = 4;  ///< half its size [m]
};

/// The matrix from W to clip space: pixel centres at integers, as cameras have them.
GlMatrix clipFromWorld(const GlView& view);

class GlRenderer {
 public:
  /// The context must be current, here and at every call.
  GlRenderer();

  /// Draws into what is bound, of the view's size.
  void drawColours(const DrawList& list, const GlView& view, const GlLight& light);
  /// Draws numbers of instances; 0 for ground, `sky` where nothing is. Lines are left out.
  void drawLabels(const DrawList& list, const GlView& view, const GlLabelTarget& target, std::uint32_t sky);

 private:
  void drawFlat(const std::vector<LineVertex>& vertices, GLenum kind);
  void drawPaint(const DrawList& list);
  void drawLit(const DrawList& list);
  void setLight(const GlView& view, const GlLight& light, const GlMatrix& shadow_from_world) const;
  void drawShadowMap(const DrawList& list, const GlMatrix& shadow_from_world);

  GlProgram lit_meshes_, lit_flat_, label_meshes_, label_flat_, depth_meshes_;
  GlMeshes meshes_;
  GlBuffer flat_vertices_;
  GlVertexArray flat_array_;
  GlFramebuffer shadow_target_;
  GlTexture shadow_map_;
};

}  // namespace murosimf
