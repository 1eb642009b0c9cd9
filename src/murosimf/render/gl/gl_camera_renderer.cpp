#include "murosimf/render/gl/gl_camera_renderer.h"

#include <algorithm>

#include "murosimf/render/gl/gl_camera_shaders.h"

namespace murosimf {

namespace {

GlMatrix matrixOf(const Pose& X) {
  const Rotation3& R = X.rotation;
  GlMatrix matrix{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto k = static_cast<int>(i);
    matrix[4 * i] = static_cast<float>(R.x[k]), matrix[4 * i + 1] = static_cast<float>(R.y[k]);
    matrix[4 * i + 2] = static_cast<float>(R.z[k]), matrix[4 * i + 3] = static_cast<float>(X.translation[k]);
  }
  matrix[15] = 1;
  return matrix;
}

std::array<float, 3> threeOf(const Vector3& p) {
  return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
}
std::array<float, 3> threeOf(const Colour& c, double light = 1) {
  const auto factor = static_cast<float>(light);
  return {c.red * factor, c.green * factor, c.blue * factor};
}

std::vector<MeshInstance>& listOf(std::vector<std::vector<MeshInstance>>& lists, int number) {
  const auto place = static_cast<std::size_t>(number);
  if (lists.size() <= place) lists.resize(place + 1);
  return lists[place];
}

}  // namespace

GlCameraRenderer::GlCameraRenderer(const PaintedGround& ground)
    : lens_program_(kLensVertexShader, kLensFragmentShader),
      bare_program_(kFieldVertexShader, kBareFragmentShader),
      paint_program_(kFieldVertexShader, kPaintFragmentShader),
      field_(ground) {
  glBindVertexArray(tile_array_.name());
  glBindBuffer(GL_ARRAY_BUFFER, tile_vertices_.name());
  pointFloats(0, 3, sizeof(TileVertex), 0);
}

void GlCameraRenderer::add(const Drawable& drawable, int fineness) {
  MeshInstance instance{};
  const Rotation3& R = drawable.X_WS.rotation;
  for (int i = 0; i < 3; ++i)
    instance.X_WM[static_cast<std::size_t>(i)] = {static_cast<float>(R.x[i]), static_cast<float>(R.y[i]),
                                                  static_cast<float>(R.z[i]),
                                                  static_cast<float>(drawable.X_WS.translation[i])};
  instance.id = drawable.label;
  for (const FineMeshes::Part& part : fine_.parts(drawable, fineness)) {
    instance.tint = Tint(part.colour.value_or(drawable.colour));
    listOf(part.closed ? closed_ : open_, part.number).push_back(instance);
    triangles_ += fine_.library()[part.number].indices.size() / 3;
  }
}

void GlCameraRenderer::gather(const GlLens& lens, const RayScene& scene, const Pose& X_WC,
                              std::span<const std::uint32_t> hidden) {
  for (Instances* lists : {&closed_, &open_})
    for (auto& list : *lists) list.clear();
  triangles_ = 0;
  for (const Drawable& d : scene.drawables) {
    if (d.owner != 0 && std::find(hidden.begin(), hidden.end(), d.owner) != hidden.end()) continue;
    const Vector3 centre_C = applyInverse(X_WC, d.X_WS.translation);
    const double radius = boundingRadius(outlineOf(d));
    if (lens.misses(centre_C, radius)) continue;
    const double distance = max(kNear, norm(centre_C) - radius);
    add(d, FineMeshes::finenessFor(radius, distance / lens.density()));
  }
  meshes_.upload(fine_.library());
}

void GlCameraRenderer::drawMeshes(const GlLens& lens, const RayScene& scene, const Pose& X_WC, int first_row) {
  glEnable(GL_CLIP_DISTANCE0);
  glFrontFace(GL_CW);  // rows grow downwards, and row 0 is OpenGL's lowest
  lens_program_.use();
  lens.set(lens_program_);
  lens_program_.set("rays", 0);
  lens_program_.set("corner", std::array<float, 3>{0, static_cast<float>(first_row), 0});
  lens_program_.set("camera_from_world", matrixOf(inverse(X_WC)));
  lens_program_.set("light", threeOf(normalized(scene.light_W)));
  lens_program_.set("ambient", scene.ambient);
  constexpr double kRange = kFar - kNear;
  lens_program_.set("clip_z", std::array<float, 2>{static_cast<float>((kFar + kNear) / kRange),
                                                   static_cast<float>(-2 * kFar * kNear / kRange)});
  glEnable(GL_CULL_FACE);
  meshes_.draw(closed_);
  glDisable(GL_CULL_FACE);
  meshes_.draw(open_);
  glFrontFace(GL_CCW);
  glDisable(GL_CLIP_DISTANCE0);
}

void GlCameraRenderer::setField(const GlProgram& program, const RayScene& scene, int first_row) const {
  const PaintedGround& ground = scene.ground;
  const double cosine = max(0.0, normalized(scene.light_W).z);
  const double light = ground.brightness * (scene.ambient + (1 - scene.ambient) * cosine);
  program.use();
  program.set("rays", 0);
  program.set("corner", std::array<float, 3>{0, static_cast<float>(first_row), 0});
  program.set("carpet", threeOf(ground.carpet, light));
  program.set("surroundings", threeOf(ground.surroundings, light));
  program.set("paint", threeOf(ground.paint, light));
}

void GlCameraRenderer::drawTiles(const std::vector<TileVertex>& tiles) {
  if (tiles.empty()) return;
  glBindVertexArray(tile_array_.name());
  fillBuffer(GL_ARRAY_BUFFER, tile_vertices_, tiles, GL_STREAM_DRAW);
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(tiles.size()));
}

void GlCameraRenderer::drawField(const GlLens& lens, const RayScene& scene, const Pose& X_WC, int first_row,
                                 bool marks_lines) {
  Pose eye = X_WC;
  eye.translation.z = max(eye.translation.z, 1e-3);
  sortTiles(lens.table(), scene.ground, field_.marked(), eye, tiles_);
  setField(bare_program_, scene, first_row);
  const Rotation3& R = eye.rotation;
  bare_program_.set("inverse_depth", threeOf(Vector3{R.x.z, R.y.z, R.z.z} * (-1 / eye.translation.z)));
  drawTiles(tiles_.bare);
  setField(paint_program_, scene, first_row);
  field_.set(paint_program_, eye.translation);
  paint_program_.set("world_from_camera", matrixOf(eye));
  paint_program_.set("sky", threeOf(scene.sky));
  paint_program_.set("line_label", marks_lines ? int{kLineLabel} : -1);
  paint_program_.set("sky_label", int{kSkyLabel});
  drawTiles(tiles_.painted);
}

void GlCameraRenderer::draw(const GlLens& lens, const RayScene& scene, const Pose& X_WC,
                            std::span<const std::uint32_t> hidden, GlAtlas& atlas, std::size_t picture,
                            bool marks_lines) {
  gather(lens, scene, X_WC, hidden);
  const int first_row = atlas.bind(picture);
  glEnable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  glDepthMask(GL_TRUE);
  glDepthFunc(GL_LEQUAL);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, lens.rays());
  drawMeshes(lens, scene, X_WC, first_row);
  glDepthMask(GL_FALSE);
  drawField(lens, scene, X_WC, first_row, marks_lines);
  glDepthMask(GL_TRUE);
}

}  // namespace murosimf
