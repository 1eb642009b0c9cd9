#include "murosimf/algorithms/scene_preparation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "murosimf/algorithms/slope_rectangle.h"

namespace murosimf {
namespace {

constexpr double kNearest = 1e-4;  ///< what is nearer to the camera's plane counts as this near [m]

/// A surface's own frame, in units of its half sizes: there the camera stands at o and a ray runs along M d.
struct UnitFrame {
  Pose X_CS;
  Vector3 half_size;
  Vector3 row[3];  ///< of M = diag(1 / half_size) R_SC
  Vector3 o;
};

// Half sizes of zero would make infinite forms; a micrometre is as good as nothing to a camera.
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

// Each prepareShape() fills the fields of its kind; false when the shape holds the camera. A plane at side * 1 of axis
// i faces the camera when the camera stands beyond it. One through the camera would be met at any w: it is moved by
// 1e-9.
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
      const double cosine = side * dot(axis[i], view.lamp_C);
      s.plane_colour[s.fronts] = litColour(view, drawable.colour, cosine);
      s.plane_light[s.fronts] = lightOf(view, cosine);
      s.plane[s.fronts++] = plane;
    }
  }
  return s.fronts > 0;
}

// w = (sqrt(root) - o . M d) / c; both terms are divided by c beforehand. The normal is M^T (o + t M d).
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

// The side is an ellipse in two dimensions; inside the endless cylinder only a cap can be seen.
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
    s.cap_light = lightOf(view, side * dot(r.z, view.lamp_C));
  }
  return s.has_side || s.has_cap;
}

// The sides of a cylinder without caps, and a sphere at each end.
bool prepareCapsule(const CameraView& view, const Drawable& drawable, const UnitFrame& f, CastSurface& s) {
  prepareCylinder(view, drawable, f, s);
  s.kind = CastKind::kCapsule;
  const double radius = f.half_size.x;
  s.end_light = formOf(view.lamp_C * (1.0 / radius));
  for (int k = 0; k < 2; ++k) {
    const Vector3 middle = f.X_CS * Vector3{0, 0, k == 0 ? f.half_size.z : -f.half_size.z},
                  o = middle * (-1.0 / radius);
    const double c = squaredNorm(o) - 1.0;
    if (c < 1e-9) return false;
    const Vector3 row[3] = {{1.0 / radius, 0, 0}, {0, 1.0 / radius, 0}, {0, 0, 1.0 / radius}};
    s.end_root[k] = rootOf(row, o, middle, 1.0 / (c * c));
    s.end_rest[k] = formOf(o * (-1.0 / (c * radius)));
    s.end_light_w[k] = static_cast<float>(dot(view.lamp_C, o));
  }
  return s.has_side || std::fabs(f.o.z) > 1.0;
}

bool prepare(const CameraView& view, const Drawable& drawable, const UnitFrame& frame, PreparedScene& work,
             CastSurface& s) {
  if (drawable.mesh) {
    s.kind = CastKind::kMesh, s.mesh = static_cast<std::int32_t>(work.meshes.size());
    work.meshes.push_back(meshFromCamera(*drawable.mesh, frame.X_CS, view.lamp_C));
    return true;
  }
  switch (drawable.shape.kind) {
    case ShapeKind::kBox:
      return prepareBox(view, drawable, frame, s);
    case ShapeKind::kEllipsoid:
      return prepareEllipsoid(frame, s);
    case ShapeKind::kCylinder:
      return prepareCylinder(view, drawable, frame, s);
    case ShapeKind::kCapsule:
      return prepareCapsule(view, drawable, frame, s);
    case ShapeKind::kConvex:
      break;
  }
  return false;
}

}  // namespace

LinearForm formOf(const Vector3& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

float lightOf(const CameraView& view, double cosine, double factor) {
  return static_cast<float>(factor * (view.ambient + (1.0 - view.ambient) * std::max(cosine, 0.0)));
}

CastColour litColour(const CameraView& view, const Colour& colour, double cosine, double factor) {
  const float light = lightOf(view, cosine, factor);
  return {colour.red * light, colour.green * light, colour.blue * light};
}

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
  const Shape outline = outlineOf(drawable);
  const SlopeRectangle seen = rectangleOf(outline, frame.X_CS);
  if (seen.isEmpty()) return;
  CastSurface s{};
  if (!prepare(view, drawable, frame, work, s)) return;
  s.label = drawable.label;
  s.colour = {drawable.colour.red, drawable.colour.green, drawable.colour.blue};
  const double nearest = frame.X_CS.translation.z - boundingRadius(outline);
  work.extents.push_back({seen.x_low, seen.x_high, seen.y_low, seen.y_high,
                          static_cast<float>(1.0 / std::max(nearest, kNearest)),
                          static_cast<std::int32_t>(work.surfaces.size())});
  work.surfaces.push_back(s);
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
  work.cast.surfaces = work.surfaces.data(), work.cast.meshes = work.meshes.data();
  work.cast.rows = work.rows.data();
}

}  // namespace murosimf
