#include "murosimf/render/gl/gl_renderer.h"

#include <cstddef>

#include "murosimf/algorithms/ray_caster.h"
#include "murosimf/render/gl/gl_shaders.h"

namespace murosimf {

namespace {

constexpr int kShadowSize = 2048;  // pixels of the shadow map, each way

std::array<float, 3> toFloats(const Vector3& p) {
  return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
}

/// rows[i] . p_C, with p_C = R_WC^T (p_W - p_WC), as a matrix of W.
GlMatrix seenFrom(const Pose& X_WC, const std::array<std::array<double, 4>, 4>& clip_from_camera) {
  const Pose X_CW = inverse(X_WC);
  GlMatrix matrix{};
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& row = clip_from_camera[i];
    for (int k = 0; k < 3; ++k) {
      const Vector3& column = k == 0 ? X_CW.rotation.x : k == 1 ? X_CW.rotation.y : X_CW.rotation.z;
      matrix[4 * i + static_cast<std::size_t>(k)] =
          static_cast<float>(row[0] * column.x + row[1] * column.y + row[2] * column.z);
    }
    const Vector3& p = X_CW.translation;
    matrix[4 * i + 3] = static_cast<float>(row[0] * p.x + row[1] * p.y + row[2] * p.z + row[3]);
  }
  return matrix;
}

/// Parallel light: what lies within `reach` of the centre fills the map.
GlMatrix shadowFromWorld(const GlLight& light) {
  const Vector3 d = normalized(light.light_W);
  const double reach = light.shadow_reach;
  const Pose X_WL = lookAt(light.shadow_centre_W + d * (2 * reach), light.shadow_centre_W);
  return seenFrom(X_WL, {{{1 / reach, 0, 0, 0}, {0, 1 / reach, 0, 0}, {0, 0, 0.5 / reach, -1}, {0, 0, 0, 1}}});
}

}  // namespace

GlMatrix clipFromWorld(const GlView& view) {
  const CameraModel& c = view.camera;
  const double w = c.width, h = c.height, n = view.near, f = view.far;
  // x_clip / z = 2 (u + 1/2) / w - 1 with u = fx x/z + fx skew y/z + cx; rows grow downwards in pictures, not in
  // OpenGL.
  return seenFrom(view.X_WC, {{{2 * c.fx / w, 2 * c.fx * c.skew / w, (2 * c.cx + 1) / w - 1, 0},
                               {0, -2 * c.fy / h, 1 - (2 * c.cy + 1) / h, 0},
                               {0, 0, (f + n) / (f - n), -2 * f * n / (f - n)},
                               {0, 0, 1, 0}}});
}

GlRenderer::GlRenderer()
    : lit_meshes_(kMeshVertexShader, kLitFragmentShader),
      lit_flat_(kFlatVertexShader, kLitFragmentShader),
      label_meshes_(kMeshVertexShader, kLabelFragmentShader),
      label_flat_(kFlatVertexShader, kLabelFragmentShader),
      depth_meshes_(kMeshVertexShader, kEmptyFragmentShader) {
  glBindTexture(GL_TEXTURE_2D, shadow_map_.name());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, kShadowSize, kShadowSize, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT,
               nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  GLint bound = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
  glBindFramebuffer(GL_FRAMEBUFFER, shadow_target_.name());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, shadow_map_.name(), 0);
  glDrawBuffer(GL_NONE);
  glReadBuffer(GL_NONE);
  glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(bound));
  glBindVertexArray(flat_array_.name());
  glBindBuffer(GL_ARRAY_BUFFER, flat_vertices_.name());
  pointFloats(0, 3, sizeof(LineVertex), offsetof(LineVertex, p_W));
  pointFloats(1, 4, sizeof(LineVertex), offsetof(LineVertex, tint));
}

void GlRenderer::drawFlat(const std::vector<LineVertex>& vertices, GLenum kind) {
  if (vertices.empty()) return;
  glBindVertexArray(flat_array_.name());
  fillBuffer(GL_ARRAY_BUFFER, flat_vertices_, vertices, GL_STREAM_DRAW);
  glDrawArrays(kind, 0, static_cast<GLsizei>(vertices.size()));
}

/// Paint over paint, as far as the horizon.
void GlRenderer::drawPaint(const DrawList& list) {
  glDepthFunc(GL_ALWAYS);
  glEnable(GL_DEPTH_CLAMP);
  drawFlat(list.painted(), GL_TRIANGLES);
  glDisable(GL_DEPTH_CLAMP);
  glDepthFunc(GL_LESS);
}

void GlRenderer::drawShadowMap(const DrawList& list, const GlMatrix& shadow_from_world) {
  GLint bound = 0, viewport[4];
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
  glGetIntegerv(GL_VIEWPORT, viewport);
  glBindFramebuffer(GL_FRAMEBUFFER, shadow_target_.name());
  glViewport(0, 0, kShadowSize, kShadowSize);
  glClear(GL_DEPTH_BUFFER_BIT);
  glEnable(GL_POLYGON_OFFSET_FILL);  // else a surface would shade itself
  glPolygonOffset(2, 4);
  depth_meshes_.use();
  depth_meshes_.set("clip_from_world", shadow_from_world);
  meshes_.draw(list.solid());
  glDisable(GL_POLYGON_OFFSET_FILL);
  glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(bound));
  glViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
}

void GlRenderer::setLight(const GlView& view, const GlLight& light, const GlMatrix& shadow_from_world) const {
  const GlMatrix clip = clipFromWorld(view);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, shadow_map_.name());
  for (const GlProgram* program : {&lit_flat_, &lit_meshes_}) {
    program->use();
    program->set("clip_from_world", clip);
    program->set("shadow_from_world", shadow_from_world);
    program->set("shadow_map", 0);
    program->set("shadows", light.shadows ? 1 : 0);
    program->set("light", toFloats(normalized(light.light_W)));
    program->set("ambient", light.ambient);
  }
}

/// What is clear comes last and hides nothing.
void GlRenderer::drawLit(const DrawList& list) {
  lit_flat_.use();
  drawPaint(list);
  lit_meshes_.use();
  meshes_.draw(list.solid());
  lit_flat_.use();
  lit_flat_.set("ambient", 1.0F);
  drawFlat(list.lines(), GL_LINES);
  lit_meshes_.use();
  glDepthMask(GL_FALSE);
  meshes_.draw(list.clearTinted());
  glDepthMask(GL_TRUE);
}

void GlRenderer::drawColours(const DrawList& list, const GlView& view, const GlLight& light) {
  meshes_.upload(list.meshes());
  glEnable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  glDepthMask(GL_TRUE);
  glDepthFunc(GL_LESS);
  const GlMatrix shadow = shadowFromWorld(light);
  if (light.shadows) drawShadowMap(list, shadow);
  glClearColor(light.sky.red, light.sky.green, light.sky.blue, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  setLight(view, light, shadow);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  drawLit(list);
  glDisable(GL_BLEND);
}

void GlRenderer::drawLabels(const DrawList& list, const GlView& view, const GlLabelTarget& target, std::uint32_t sky) {
  meshes_.upload(list.meshes());
  target.bind();
  glEnable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  glDepthMask(GL_TRUE);
  const std::array<GLuint, 4> nothing{sky, 0, 0, 0};
  glClearBufferuiv(GL_COLOR, 0, nothing.data());
  glClear(GL_DEPTH_BUFFER_BIT);
  const GlMatrix clip = clipFromWorld(view);
  label_flat_.use();
  label_flat_.set("clip_from_world", clip);
  drawPaint(list);
  label_meshes_.use();
  label_meshes_.set("clip_from_world", clip);
  meshes_.draw(list.solid());
  meshes_.draw(list.clearTinted());
}

}  // namespace murosimf
