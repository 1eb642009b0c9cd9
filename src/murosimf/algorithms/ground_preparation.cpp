// The ground's part of scene_preparation.h: plane, strips, rings, shadows.
#include <algorithm>
#include <cmath>

#include "murosimf/algorithms/scene_preparation.h"
#include "murosimf/algorithms/slope_rectangle.h"

namespace murosimf {
namespace {

constexpr double kShadowHeight = 0.2;  ///< drawables higher above the ground cast no patch [m]
constexpr double kShadowStrength = 0.7;

/// Offset in the ground from a point, times w, scaled: direction . (X - point) w.
LinearForm groundForm(const CameraView& view, double along_x, double along_y, double point_x, double point_y) {
  const Rotation3& r = view.X_WC.rotation;
  const Vector3 world_x{r.x.x, r.y.x, r.z.x}, world_y{r.x.y, r.y.y, r.z.y}, world_z{r.x.z, r.y.z, r.z.z};
  const Vector3& eye = view.X_WC.translation;
  const double offset = along_x * (eye.x - point_x) + along_y * (eye.y - point_y);
  return formOf(world_x * along_x + world_y * along_y - world_z * (offset / view.height));
}

/// One strip's part of the eight arrays in work.strips.
struct Strip {
  double x, y, along_x, along_y, half_width, half_length;
};
Strip stripOf(const PaintedLine& line) {
  const double dx = line.b_x - line.a_x, dy = line.b_y - line.a_y, length = std::sqrt(dx * dx + dy * dy);
  const bool point = length < 1e-9;
  return {0.5 * (line.a_x + line.b_x),
          0.5 * (line.a_y + line.b_y),
          point ? 1.0 : dx / length,
          point ? 0.0 : dy / length,
          0.5 * line.width,
          0.5 * length};
}

void setStrips(const CameraView& view, const PaintedGround& ground, PreparedScene& work) {
  CastGround& g = work.cast.ground;
  const std::size_t count = 1 + ground.lines.size();
  const std::size_t filled = (count + kLanesAtMost - 1) / kLanesAtMost * kLanesAtMost;
  work.strips.assign(8 * filled, 0.0F);
  float* array[8];
  for (std::size_t k = 0; k < 8; ++k) array[k] = work.strips.data() + k * filled;
  double farthest = 0.0;
  for (std::size_t k = 0; k < count; ++k) {
    const Strip s = k == 0 ? Strip{0, 0, 1, 0, ground.half_width, ground.half_length} : stripOf(ground.lines[k - 1]);
    const LinearForm across = groundForm(view, -s.along_y, s.along_x, s.x, s.y);
    const LinearForm along = groundForm(view, s.along_x, s.along_y, s.x, s.y);
    const float value[8] = {across.x,
                            across.y,
                            across.one,
                            along.x,
                            along.y,
                            along.one,
                            static_cast<float>(s.half_width),
                            static_cast<float>(s.half_length)};
    for (std::size_t i = 0; i < 8; ++i) array[i][k] = value[i];
    const Vector3 offset = view.X_WC.translation - Vector3{s.x, s.y, 0};
    farthest = std::max(farthest, norm(offset) + s.half_width + s.half_length);
  }
  for (const PaintedCircle& c : ground.circles)
    farthest = std::max(farthest, norm(view.X_WC.translation - Vector3{c.x, c.y, 0}) + c.radius + c.width);
  g.w_far = static_cast<float>(1.0 / (1.25 * farthest + 1.0));
  g.across_x = array[0], g.across_y = array[1], g.across_one = array[2];
  g.along_x = array[3], g.along_y = array[4], g.along_one = array[5];
  g.half_width = array[6], g.half_length = array[7];
  g.strip_count = static_cast<std::int32_t>(count);
}

/// Places in the picture count whole repeats from beyond the carpet, so that none is below 0.
void setTexture(const CameraView& view, const PaintedGround& ground, CastGround& g) {
  g.texture = {};
  if (!ground.texture) return;
  g.texture = ground.texture->cast();
  const bool once = ground.texture_size <= 0.0;
  const double length = once ? 2.0 * ground.half_length : ground.texture_size;
  const double width = once ? 2.0 * ground.half_width : ground.texture_size;
  const double x_low = once ? -ground.half_length : -std::ceil(ground.half_length / length + 1.0) * length;
  const double y_high = once ? ground.half_width : std::ceil(ground.half_width / width + 1.0) * width;
  const double side = ground.texture->side(0);
  g.texel_u = groundForm(view, side / length, 0.0, x_low, 0.0);
  g.texel_v = groundForm(view, 0.0, -side / width, 0.0, y_high);
}

/// Half of the drawable's extent along z of W [m].
double heightRange(const Drawable& drawable) {
  const Shape outline = outlineOf(drawable);
  const Vector3& h = outline.half_size;
  const Rotation3& r = drawable.X_WS.rotation;
  const double x = std::fabs(r.x.z) * h.x, y = std::fabs(r.y.z) * h.y, z = std::fabs(r.z.z) * h.z;
  if (outline.kind == ShapeKind::kBox) return x + y + z;
  if (outline.kind == ShapeKind::kCapsule) return h.x + z;
  const double across = std::sqrt(x * x + y * y);
  return outline.kind == ShapeKind::kCylinder ? across + z : std::sqrt(across * across + z * z);
}

/// An ellipse on the ground, L L^T with L = [xx 0; yx yy] [m]: points b + L e, |e| <= 1.
struct Patch {
  double xx, yx, yy;
};
/// A little larger than the drawable seen from above, the more the higher it hangs.
Patch patchBeneath(const Drawable& drawable, double gap) {
  const Shape outline = outlineOf(drawable);
  const bool rounded = outline.kind == ShapeKind::kCapsule;
  const Vector3 h = outline.half_size + Vector3{0, 0, rounded ? outline.half_size.x : 0.0};
  const Rotation3& r = drawable.X_WS.rotation;
  const Vector3 axis[3] = {r.x * h.x, r.y * h.y, r.z * h.z};
  const double spread = 0.03 + 0.5 * gap;
  double xx = spread * spread, xy = 0.0, yy = spread * spread;
  for (const Vector3& a : axis) xx += 5.0 * a.x * a.x, xy += 5.0 * a.x * a.y, yy += 5.0 * a.y * a.y;
  const double first = std::sqrt(xx), cross_term = xy / first;
  return {first, cross_term, std::sqrt(yy - cross_term * cross_term)};
}

}  // namespace

void addShadow(const CameraView& view, const Drawable& drawable, PreparedScene& work) {
  const Vector3 lamp_W = view.X_WC.rotation * view.lamp_C;
  const Vector3& p_W = drawable.X_WS.translation;
  const double half_height = heightRange(drawable), gap = std::max(p_W.z - half_height, 0.0);
  if (gap > kShadowHeight || p_W.z < -half_height || lamp_W.z < 0.1) return;
  const Patch patch = patchBeneath(drawable, gap);
  const double drop = gap + std::min(half_height, 0.1);  // the patch of a post lies at its foot
  const Vector3 middle_W{p_W.x - lamp_W.x / lamp_W.z * drop, p_W.y - lamp_W.y / lamp_W.z * drop, 0.0};
  const Rotation3& R_WC = view.X_WC.rotation;
  const SlopeRectangle seen =
      rectangleOfEllipse(applyInverse(view.X_WC, middle_W), applyTransposed(R_WC, Vector3{patch.xx, patch.yx, 0.0}),
                         applyTransposed(R_WC, Vector3{0.0, patch.yy, 0.0}));
  if (seen.isEmpty()) return;
  CastSurface s{};
  s.kind = CastKind::kShadow;
  s.offset[0] = groundForm(view, 1.0 / patch.xx, 0.0, middle_W.x, middle_W.y);
  s.offset[1] = groundForm(view, -patch.yx / (patch.xx * patch.yy), 1.0 / patch.yy, middle_W.x, middle_W.y);
  s.strength = static_cast<float>((1.0 - view.ambient) * kShadowStrength * (1.0 - gap / kShadowHeight));
  work.cast.has_shadows = 1;
  work.extents.push_back(
      {seen.x_low, seen.x_high, seen.y_low, seen.y_high, 0.0F, static_cast<std::int32_t>(work.surfaces.size())});
  work.surfaces.push_back(s);
}

void setGround(const CameraView& view, const RayScene& scene, PreparedScene& work) {
  CastGround& g = work.cast.ground;
  const Rotation3& r = view.X_WC.rotation;
  g.w = formOf(Vector3{r.x.z, r.y.z, r.z.z} * (-1.0 / view.height));
  g.x = formOf({r.x.x, r.y.x, r.z.x}), g.y = formOf({r.x.y, r.y.y, r.z.y});
  g.height = static_cast<float>(view.height);
  setStrips(view, scene.ground, work);
  work.rings.clear();
  for (const PaintedCircle& c : scene.ground.circles)
    work.rings.push_back({groundForm(view, 1, 0, c.x, c.y), groundForm(view, 0, 1, c.x, c.y),
                          static_cast<float>(c.radius), static_cast<float>(0.5 * c.width)});
  g.rings = work.rings.data(), g.ring_count = static_cast<std::int32_t>(work.rings.size());
  const double cosine = (view.X_WC.rotation * view.lamp_C).z, factor = scene.ground.brightness;
  g.carpet = litColour(view, scene.ground.carpet, cosine, factor);
  g.surroundings = litColour(view, scene.ground.surroundings, cosine, factor);
  g.paint = litColour(view, scene.ground.paint, cosine, factor);
  g.light = lightOf(view, cosine), g.texture_light = lightOf(view, cosine, factor);
  setTexture(view, scene.ground, g);
  g.sky = {scene.sky.red, scene.sky.green, scene.sky.blue};
}

}  // namespace murosimf
