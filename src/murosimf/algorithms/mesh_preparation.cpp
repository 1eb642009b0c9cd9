// Meshes' part of scene_preparation.h. The forms' coefficients: cast_mesh_data.h.
#include <algorithm>
#include <cmath>

#include "murosimf/algorithms/scene_preparation.h"

namespace murosimf {
namespace {

void set(const Vector3& v, float (&out)[3]) {
  for (int i = 0; i < 3; ++i) out[i] = static_cast<float>(v[i]);
}

/// What both kinds of view have in common. X_VS: pose of the mesh in the axes of camera or lamp.
CastMeshView viewOf(const TriangleMesh& mesh, const Pose& X_VS, const Vector3& lamp_V) {
  CastMeshView v{};
  v.mesh = mesh.cast();
  const Rotation3& r = X_VS.rotation;
  for (int i = 0; i < 3; ++i) {
    set({r.x[i], r.y[i], r.z[i]}, v.row[i]);
    v.offset[i] = static_cast<float>(X_VS.translation[i]);
  }
  set(applyTransposed(r, lamp_V), v.lamp);
  v.slack = static_cast<float>(2e-5 * (norm(X_VS.translation) + norm(mesh.halfSize())));
  return v;
}

}  // namespace

CastMeshView meshFromCamera(const TriangleMesh& mesh, const Pose& X_CS, const Vector3& lamp_C) {
  CastMeshView v = viewOf(mesh, X_CS, lamp_C);
  v.perspective = 1, v.facing = -1.0F, v.sink = 1.0F;
  const Vector3& p_C = X_CS.translation;
  const bool ahead = p_C.z > 0.1 * norm(p_C);
  v.middle[0] = ahead ? static_cast<float>(p_C.x / p_C.z) : 0.0F;
  v.middle[1] = ahead ? static_cast<float>(p_C.y / p_C.z) : 0.0F;
  const Rotation3& r = X_CS.rotation;
  const Vector3 m = applyTransposed(r, p_C);
  const Vector3 ray[3] = {applyTransposed(r, Vector3{1, 0, 0}), applyTransposed(r, Vector3{0, 1, 0}),
                          applyTransposed(r, Vector3{v.middle[0], v.middle[1], 1})};
  for (int k = 0; k < 3; ++k) set(cross(ray[k], m), v.edge[k]), set(ray[k], v.area[k]), set(ray[k], v.top[k]);
  set(m, v.bottom);
  return v;
}

CastMeshView meshFromLamp(const TriangleMesh& mesh, const Pose& X_LS) {
  CastMeshView v = viewOf(mesh, X_LS, {0, 0, 1});
  v.facing = 1.0F, v.lift = 1.0F;
  const Vector3& p_L = X_LS.translation;
  v.middle[0] = static_cast<float>(p_L.x), v.middle[1] = static_cast<float>(p_L.y);
  const Rotation3& r = X_LS.rotation;
  const Vector3 across[2] = {applyTransposed(r, Vector3{1, 0, 0}), applyTransposed(r, Vector3{0, 1, 0})};
  const Vector3 up = applyTransposed(r, Vector3{0, 0, 1});
  for (int k = 0; k < 2; ++k) set(cross(across[k], up), v.edge[k]), set(across[k] * -1.0, v.top[k]);
  set(up, v.area[2]), set(up * p_L.z, v.top[2]), set(up, v.bottom);
  return v;
}

}  // namespace murosimf
