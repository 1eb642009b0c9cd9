#include "murosimf/algorithms/scene_preparation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "murosimf/algorithms/slope_rectangle.h"

namespace murosimf {
namespace {

constexpr double kNearest = 1e-4;      ///< what is nearer to the camera's plane counts as this near [m]
constexpr double kShadowHeight = 0.2;  ///< drawables higher above the ground cast no patch [m]
constexpr double kShadowStrength = 0.7;

LinearForm formOf(const Vector3& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

CastColour litColour(const CameraView& view, const Colour& colour, double cosine, double factor = 1.0) {
  const auto light = static_cast<float>(factor * (view.ambient + (1.0 - view.ambient) * std::max(cosine, 0.0)));
  return {colour.red * light, colour.green * light, colour.blue * light};
}

/// A surface's own frame, in units of its half sizes: there the camera stands at o and a ray runs along M d.
struct UnitFrame {
  Pose X_CS;
  Vector3 half_size;
  Vector3 row[3];  ///< of M = diag(1 / half_size) R_SC
  Vector3 o;
};

UnitFrame unitFrameOf(const CameraView& view, const Drawable& drawable) {
  UnitFrame f;
  f.X_CS = inverse(view.X_WC) * drawable.X_WS;
  const Vector3& h = drawable.shape.half_size;
  f.half_size = {std::max(h.x, 1e-6), std::max(h.y, 1e-6), std::max(h.z, 1e-6)};
  const Rotation3& r = f.X_CS.rotation;
  f.row[0] = r.x * (1.0 / f.half_size.x), f.row[1] = r.y * (1.0 / f.half_size.y),
  f.row[2] = r.z * (1.0 / f.half_size.z);
  const Vector3& p = f.X_CS.translation;
  f.o = {-dot(f.row[0], p), -dot(f.row[1], p), -dot(f.row[2], p)};
  return f;
}

/// |M d|^2 - |o x M d|^2 of rays d, times `factor`, about the slopes of `middle`. Rows of M and o as given: a
/// cylinder's side has two dimensions, its third row and third component are zero.
QuadraticForm rootOf(const Vector3 (&row)[3], const Vector3& o, const Vector3& middle, double factor) {
  const bool ahead = middle.z > 0.1 * norm(middle);
  const double x0 = ahead ? static_cast<float>(middle.x / middle.z) : 0.0;
  const double y0 = ahead ? static_cast<float>(middle.y / middle.z) : 0.0;
  const Vector3 dx{row[0].x, row[1].x, row[2].x}, dy{row[0].y, row[1].y, row[2].y};
  const Vector3 d0{row[0].x * x0 + row[0].y * y0 + row[0].z, row[1].x * x0 + row[1].y * y0 + row[1].z,
                   row[2].x * x0 + row[2].y * y0 + row[2].z};
  const Vector3 cx = cross(o, dx), cy = cross(o, dy), c0 = cross(o, d0);
  const auto term = [&](const Vector3& a, const Vector3& b, const Vector3& ca, const Vector3& cb, double times) {
    return static_cast<float>(times * factor * (dot(a, b) - dot(ca, cb)));
  };
  return {static_cast<float>(x0),  static_cast<float>(y0),  term(dx, dx, cx, cx, 1), term(dx, dy, cx, cy, 2),
          term(dy, dy, cy, cy, 1), term(dx, d0, cx, c0, 2), term(dy, d0, cy, c0, 2), term(d0, d0, c0, c0, 1)};
}

bool prepareBox(const CameraView& view, const Drawable& drawable, const UnitFrame& f, CastSurface& s) {
  s.kind = CastKind::kBox, s.fronts = 0;
  const Rotation3& r = f.X_CS.rotation;
  const Vector3 axis[3] = {r.x, r.y, r.z};
  int backs = 6;
  for (int i = 0; i < 3; ++i) {
    for (const double side : {1.0, -1.0}) {
      const bool front = side * f.o[i] > 1.0 + 1e-9;
      const double gap = front ? side - f.o[i] : side * std::max(side * (side - f.o[i]), 1e-9);
      const LinearForm plane = formOf(f.row[i] * (1.0 / gap));
      if (!front) {
        s.plane[--backs] = plane;
        continue;
      }
      s.plane_colour[s.fronts] = litColour(view, drawable.colour, side * dot(axis[i], view.lamp_C));
      s.plane[s.fronts++] = plane;
    }
  }
  return s.fronts > 0;
}

bool prepareEllipsoid(const UnitFrame& f, CastSurface& s) {
  s.kind = CastKind::kEllipsoid;
  const double c = squaredNorm(f.o) - 1.0;
  if (c < 1e-9) return false;
  s.root = rootOf(f.row, f.o, f.X_CS.translation, 1.0 / (c * c));
  const Vector3 outward = f.row[0] * f.o.x + f.row[1] * f.o.y + f.row[2] * f.o.z;  // M^T o
  s.rest = formOf(outward * (-1.0 / c));
  for (int i = 0; i < 3; ++i) {
    s.gradient[i] = formOf(f.row[0] * f.row[0][i] + f.row[1] * f.row[1][i] + f.row[2] * f.row[2][i]);  // M^T M
    s.gradient_w[i] = static_cast<float>(outward[i]);
  }
  return true;
}

bool prepareCylinder(const CameraView& view, const Drawable& drawable, const UnitFrame& f, CastSurface& s) {
  s.kind = CastKind::kCylinder;
  const double c = f.o.x * f.o.x + f.o.y * f.o.y - 1.0;
  s.has_side = c > 1e-9;
  s.has_cap = std::fabs(f.o.z) > 1.0 + 1e-9;
  const Vector3 flat[3] = {f.row[0], f.row[1], {0, 0, 0}};
  if (s.has_side) {
    s.root = rootOf(flat, {f.o.x, f.o.y, 0}, f.X_CS.translation, 1.0 / (c * c));
    s.rest = formOf((f.row[0] * f.o.x + f.row[1] * f.o.y) * (-1.0 / c));
  }
  const Rotation3& r = f.X_CS.rotation;
  const double lamp_x = dot(r.x, view.lamp_C), lamp_y = dot(r.y, view.lamp_C);
  s.side_light = formOf(f.row[0] * lamp_x + f.row[1] * lamp_y);
  s.side_light_w = static_cast<float>(lamp_x * f.o.x + lamp_y * f.o.y);
  for (int i = 0; i < 3; ++i) s.axis[i] = formOf(f.row[i]), s.axis_w[i] = static_cast<float>(f.o[i]);
  if (s.has_cap) {
    const double side = f.o.z > 0.0 ? 1.0 : -1.0;
    s.cap = formOf(f.row[2] * (1.0 / (side - f.o.z)));
    s.cap_colour = litColour(view, drawable.colour, side * dot(r.z, view.lamp_C));
  }
  return s.has_side || s.has_cap;
}

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

/// Half of the drawable's extent along z of W [m].
double heightRange(const Drawable& drawable) {
  const Vector3& h = drawable.shape.half_size;
  const Rotation3& r = drawable.X_WS.rotation;
  const double x = std::fabs(r.x.z) * h.x, y = std::fabs(r.y.z) * h.y, z = std::fabs(r.z.z) * h.z;
  if (drawable.shape.kind == ShapeKind::kBox) return x + y + z;
  const double across = std::sqrt(x * x + y * y);
  return drawable.shape.kind == ShapeKind::kCylinder ? across + z : std::sqrt(across * across + z * z);
}

/// An ellipse on the ground, L L^T with L = [xx 0; yx yy] [m]: points b + L e, |e| <= 1.
struct Patch {
  double xx, yx, yy;
};
/// A little larger than the drawable seen from above, the more the higher it hangs.
Patch patchBeneath(const Drawable& drawable, double gap) {
  const Vector3& h = drawable.shape.half_size;
  const Rotation3& r = drawable.X_WS.rotation;
  const Vector3 axis[3] = {r.x * h.x, r.y * h.y, r.z * h.z};
  const double spread = 0.03 + 0.5 * gap;
  double xx = spread * spread, xy = 0.0, yy = spread * spread;
  for (const Vector3& a : axis) xx += 5.0 * a.x * a.x, xy += 5.0 * a.x * a.y, yy += 5.0 * a.y * a.y;
  const double first = std::sqrt(xx), cross_term = xy / first;
  return {first, cross_term, std::sqrt(yy - cross_term * cross_term)};
}

}  // namespace

CameraView viewOf(const RayScene& scene, const Pose& X_WC) {
  CameraView view;
  view.X_WC = X_WC;
  view.height = std::max(X_WC.translation.z, 1e-3);
  view.lamp_C = normalized(applyTransposed(X_WC.rotation, scene.light_W));
  view.ambient = std::clamp(static_cast<double>(scene.ambient), 0.0, 1.0);
  return view;
}

void addSurface(const CameraView& view, const Drawable& drawable, PreparedScene& work) {
  const UnitFrame frame = unitFrameOf(view, drawable);
  const SlopeRectangle seen = rectangleOf(drawable.shape, frame.X_CS);
  if (seen.isEmpty()) return;
  CastSurface s{};
  const bool visible = drawable.shape.kind == ShapeKind::kBox         ? prepareBox(view, drawable, frame, s)
                       : drawable.shape.kind == ShapeKind::kEllipsoid ? prepareEllipsoid(frame, s)
                                                                      : prepareCylinder(view, drawable, frame, s);
  if (!visible) return;
  s.label = drawable.label;
  s.colour = {drawable.colour.red, drawable.colour.green, drawable.colour.blue};
  const double nearest = frame.X_CS.translation.z - boundingRadius(drawable.shape);
  work.extents.push_back({seen.x_low, seen.x_high, seen.y_low, seen.y_high,
                          static_cast<float>(1.0 / std::max(nearest, kNearest)),
                          static_cast<std::int32_t>(work.surfaces.size())});
  work.surfaces.push_back(s);
}

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
  g.sky = {scene.sky.red, scene.sky.green, scene.sky.blue};
}

void sortIntoRows(const RayTable& rays, PreparedScene& work) {
  using Extent = PreparedScene::Extent;
  std::sort(work.extents.begin(), work.extents.end(), [](const Extent& a, const Extent& b) {
    return a.nearest != b.nearest ? a.nearest > b.nearest : a.surface < b.surface;
  });
  work.row_x_low.clear(), work.row_x_high.clear(), work.row_y_low.clear(), work.row_y_high.clear();
  work.row_surface.clear();
  const auto append = [&](const Extent& e) {
    work.row_x_low.push_back(e.x_low), work.row_x_high.push_back(e.x_high);
    work.row_y_low.push_back(e.y_low), work.row_y_high.push_back(e.y_high);
    work.row_surface.push_back(e.surface);
  };
  constexpr float kHuge = std::numeric_limits<float>::max();
  constexpr Extent kEmpty{kHuge, -kHuge, kHuge, -kHuge, 0.0F, 0};
  work.rows.resize(static_cast<std::size_t>(rays.tileRows()));
  for (std::size_t row = 0; row < work.rows.size(); ++row) {
    const SlopeRectangle& here = rays.rowRectangles()[row];
    const std::size_t begin = work.row_surface.size();
    for (const Extent& e : work.extents)
      if (e.y_low <= here.y_high && e.y_high >= here.y_low && e.x_low <= here.x_high && e.x_high >= here.x_low)
        append(e);
    work.rows[row].count = static_cast<std::int32_t>(work.row_surface.size() - begin);
    while (work.row_surface.size() % kLanesAtMost != 0) append(kEmpty);
  }
  std::size_t begin = 0;
  for (CastRow& row : work.rows) {
    row.x_low = work.row_x_low.data() + begin, row.x_high = work.row_x_high.data() + begin;
    row.y_low = work.row_y_low.data() + begin, row.y_high = work.row_y_high.data() + begin;
    row.surface = work.row_surface.data() + begin;
    begin += (static_cast<std::size_t>(row.count) + kLanesAtMost - 1) / kLanesAtMost * kLanesAtMost;
  }
  work.cast.surfaces = work.surfaces.data(), work.cast.rows = work.rows.data();
}

}  // namespace murosimf
