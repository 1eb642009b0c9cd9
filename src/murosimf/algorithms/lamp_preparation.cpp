// The lamp's part of scene_preparation.h: drawables as its parallel rays meet them.
//
// Frame L stands at the camera, its z axis points towards the lamp. Over a place (x, y) the surface that the lamp sees
// has a height h, as a camera's ray sees one at an inverse depth w:
//   plane      n . (p - c) = s                  h = (s + n . c - n_x x - n_y y) / n_z
//   ellipsoid  |M (p - c)| = 1, m = M e_z       h = c_z - (o . m) / m.m + sqrt(m.m - |o x m|^2) / m.m,
//              o = M (x - c_x, y - c_y, 0)
#include <algorithm>
#include <cmath>

#include "murosimf/algorithms/scene_preparation.h"

namespace murosimf {
namespace {

/// Half sizes in the three axes of L, and the rows of M.
struct LampFrame {
  Pose X_LS;
  Vector3 half_size, row[3];
};

LampFrame frameOf(const Pose& X_LS, const Vector3& half_size) {
  LampFrame f;
  f.X_LS = X_LS;
  f.half_size = {std::max(half_size.x, 1e-6), std::max(half_size.y, 1e-6), std::max(half_size.z, 1e-6)};
  const Rotation3& r = X_LS.rotation;
  f.row[0] = r.x * (1.0 / f.half_size.x), f.row[1] = r.y * (1.0 / f.half_size.y),
  f.row[2] = r.z * (1.0 / f.half_size.z);
  return f;
}

/// Height of the plane n . (p - c) = s. One along the rays is tilted by a millionth.
LinearForm planeOf(const Vector3& n, const Vector3& c, double s) {
  const double least = 1e-6 * norm(n), n_z = std::fabs(n.z) > least ? n.z : std::copysign(least, n.z);
  return formOf(Vector3{-n.x, -n.y, s + dot(n, c)} * (1.0 / n_z));
}

/// Root and rest of an ellipsoid; of a cylinder's side, whose third row is zero. False where the rays run along it.
bool setRoot(const Vector3 (&row)[3], const Vector3& c, QuadraticForm& root, LinearForm& rest) {
  const Vector3 a{row[0].x, row[1].x, row[2].x}, b{row[0].y, row[1].y, row[2].y}, m{row[0].z, row[1].z, row[2].z};
  const double mm = squaredNorm(m);
  if (mm < 1e-9 * (squaredNorm(row[0]) + squaredNorm(row[1]))) return false;
  const Vector3 am = cross(a, m), bm = cross(b, m);
  const double factor = -1.0 / (mm * mm), x = -dot(a, m) / mm, y = -dot(b, m) / mm;
  root = {static_cast<float>(c.x),
          static_cast<float>(c.y),
          static_cast<float>(factor * squaredNorm(am)),
          static_cast<float>(2.0 * factor * dot(am, bm)),
          static_cast<float>(factor * squaredNorm(bm)),
          0.0F,
          0.0F,
          static_cast<float>(1.0 / mm)};
  rest = formOf({x, y, c.z - x * c.x - y * c.y});
  return true;
}

void prepareBox(const LampFrame& f, CastSurface& s) {
  s.kind = CastKind::kBox, s.fronts = 0;
  int backs = 6;
  for (const Vector3& n : f.row) {
    for (const double side : {1.0, -1.0}) {
      const LinearForm plane = planeOf(n, f.X_LS.translation, side);
      (side > 0) != std::signbit(n.z) ? s.plane[s.fronts++] = plane : s.plane[--backs] = plane;
    }
  }
}

void prepareSide(const LampFrame& f, CastSurface& s) {
  const Vector3 flat[3] = {f.row[0], f.row[1], {0, 0, 0}};
  const Vector3& c = f.X_LS.translation;
  s.has_side = setRoot(flat, c, s.root, s.rest);
  for (int i = 0; i < 3; ++i) {
    s.axis_w[i] = static_cast<float>(f.row[i].z);
    s.axis[i] = formOf({f.row[i].x, f.row[i].y, -dot(f.row[i], c)});
  }
}

void prepareCylinder(const LampFrame& f, CastSurface& s) {
  s.kind = CastKind::kCylinder;
  prepareSide(f, s);
  s.has_cap = 1;
  s.cap = planeOf(f.row[2], f.X_LS.translation, std::copysign(1.0, f.row[2].z));
}

void prepareCapsule(const LampFrame& f, CastSurface& s) {
  s.kind = CastKind::kCapsule;
  prepareSide(f, s);
  const double radius = f.half_size.x;
  const Vector3 row[3] = {{1.0 / radius, 0, 0}, {0, 1.0 / radius, 0}, {0, 0, 1.0 / radius}};
  for (int k = 0; k < 2; ++k)
    setRoot(row, f.X_LS * Vector3{0, 0, k == 0 ? f.half_size.z : -f.half_size.z}, s.end_root[k], s.end_rest[k]);
}

/// Half of a shape's extent along an axis of L, given by that component of the three axes of S.
double reachOf(const Shape& shape, double x, double y, double z) {
  const Vector3& h = shape.half_size;
  x = std::fabs(x) * h.x, y = std::fabs(y) * h.y, z = std::fabs(z) * h.z;
  switch (shape.kind) {
    case ShapeKind::kEllipsoid:
      return std::sqrt(x * x + y * y + z * z);
    case ShapeKind::kCylinder:
      return std::sqrt(x * x + y * y) + z;
    case ShapeKind::kCapsule:
      return h.x + z;
    case ShapeKind::kBox:
    case ShapeKind::kConvex:
      break;
  }
  return x + y + z;
}

void addExtent(const Shape& outline, const Pose& X_LS, PreparedScene& work) {
  const Rotation3& r = X_LS.rotation;
  const Vector3& p = X_LS.translation;
  const double x = reachOf(outline, r.x.x, r.y.x, r.z.x) + 1e-4, y = reachOf(outline, r.x.y, r.y.y, r.z.y) + 1e-4;
  work.caster_x_low.push_back(static_cast<float>(p.x - x)), work.caster_x_high.push_back(static_cast<float>(p.x + x));
  work.caster_y_low.push_back(static_cast<float>(p.y - y)), work.caster_y_high.push_back(static_cast<float>(p.y + y));
  work.caster_surface.push_back(static_cast<std::int32_t>(work.casters.size()));
}

/// Axes of L in C: z towards the lamp.
Rotation3 lampAxes(const Vector3& lamp_C) {
  const Vector3 across = std::fabs(lamp_C.x) < 0.7 ? Vector3{1, 0, 0} : Vector3{0, 1, 0};
  const Vector3 x = normalized(cross(across, lamp_C));
  return {x, cross(lamp_C, x), lamp_C};
}

void addCaster(const Drawable& drawable, const Pose& X_LS, PreparedScene& work) {
  const Shape outline = outlineOf(drawable);
  const LampFrame frame = frameOf(X_LS, outline.half_size);
  CastSurface s{};
  if (drawable.mesh) {
    s.kind = CastKind::kMesh, s.mesh = static_cast<std::int32_t>(work.caster_meshes.size());
    work.caster_meshes.push_back(meshFromLamp(*drawable.mesh, X_LS));
  } else if (outline.kind == ShapeKind::kBox) {
    prepareBox(frame, s);
  } else if (outline.kind == ShapeKind::kCylinder) {
    prepareCylinder(frame, s);
  } else if (outline.kind == ShapeKind::kCapsule) {
    prepareCapsule(frame, s);
  } else {
    s.kind = CastKind::kEllipsoid;
    setRoot(frame.row, X_LS.translation, s.root, s.rest);
  }
  addExtent(outline, X_LS, work);
  work.casters.push_back(s);
}

}  // namespace

void setCasters(const CameraView& view, const RayScene& scene, PreparedScene& work) {
  work.casters.clear(), work.caster_meshes.clear(), work.caster_surface.clear();
  work.caster_x_low.clear(), work.caster_x_high.clear(), work.caster_y_low.clear(), work.caster_y_high.clear();
  const Rotation3 R_CL = lampAxes(view.lamp_C);
  const Pose X_LW = inverse(view.X_WC * Pose{R_CL, {}});
  for (const Drawable& d : scene.drawables)
    if (d.mesh || d.shape.kind != ShapeKind::kConvex) addCaster(d, X_LW * d.X_WS, work);
  const auto count = static_cast<std::int32_t>(work.casters.size());
  while (work.caster_surface.size() % kLanesAtMost != 0) {
    work.caster_x_low.push_back(1.0F), work.caster_x_high.push_back(-1.0F);
    work.caster_y_low.push_back(1.0F), work.caster_y_high.push_back(-1.0F);
    work.caster_surface.push_back(0);
  }
  work.caster_row.assign(1, {work.caster_x_low.data(), work.caster_x_high.data(), work.caster_y_low.data(),
                             work.caster_y_high.data(), work.caster_surface.data(), count});
  work.lamp_scene.assign(1, work.cast);
  CastScene& lamp = work.lamp_scene.front();
  lamp.surfaces = work.casters.data(), lamp.meshes = work.caster_meshes.data(), lamp.rows = work.caster_row.data();
  work.cast.lamp_place[0] = formOf(R_CL.x), work.cast.lamp_place[1] = formOf(R_CL.y);
  work.cast.lamp_place[2] = formOf(R_CL.z);
  work.cast.lamp_scene = work.lamp_scene.data();
}

}  // namespace murosimf
