#pragma once

/// @file Parts of prepareScene(): surfaces and ground as seen from a camera, and which rows of tiles may show them.

#include "murosimf/algorithms/prepared_scene.h"
#include "murosimf/algorithms/ray_scene.h"
#include "murosimf/algorithms/ray_table.h"

namespace murosimf {

/// A camera in the world, in the forms that surfaces need.
struct CameraView {
  Pose X_WC;
  double height;   ///< above the ground [m]; at least 1 mm
  Vector3 lamp_C;  ///< unit vector
  double ambient;
};
CameraView viewOf(const RayScene& scene, const Pose& X_WC);

/// A form of slopes (x, y) from its coefficients (of x, of y, constant).
LinearForm formOf(const Vector3& v);
/// Light on a surface whose normal has this cosine with the lamp's direction.
float lightOf(const CameraView& view, double cosine, double factor = 1.0);
/// A colour in the light that falls on a surface whose normal has this cosine with the lamp's direction.
CastColour litColour(const CameraView& view, const Colour& colour, double cosine, double factor = 1.0);

/// A mesh as rays meet it, whose pose in the camera's frame is X_CS.
CastMeshView meshFromCamera(const TriangleMesh& mesh, const Pose& X_CS, const Vector3& lamp_C);

/// The same for the lamp's rays, pose in the lamp's frame.
CastMeshView meshFromLamp(const TriangleMesh& mesh, const Pose& X_LS);

/// Appends a drawable to work.surfaces and work.extents, unless it lies behind the camera or holds it.
void addSurface(const CameraView& view, const Drawable& drawable, PreparedScene& work);
/// The same for its soft shadow on the ground; none when it stands higher than 0.2 m.
void addShadow(const CameraView& view, const Drawable& drawable, PreparedScene& work);
/// Overwrites everything that hard shadows need: work.casters and what belongs to them, work.lamp_scene.
void setCasters(const CameraView& view, const RayScene& scene, PreparedScene& work);
/// Overwrites work.cast.ground, work.strips and work.rings.
void setGround(const CameraView& view, const RayScene& scene, PreparedScene& work);
/// Sorts work.extents front to back and lists for every row of tiles those that it may show. Overwrites work.rows.
void sortIntoRows(const RayTable& rays, PreparedScene& work);

}  // namespace murosimf
