#pragma once

/// @file Renderers of `body_inertia`: where a robot's mass is.

#include "murosimf/render/body_places.h"
#include "murosimf/robot/mass_properties.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

/// A body's mass, with the axes in which its inertia is diagonal.
struct PrincipalMass {
  double mass = 0;
  Pose X_BC;           ///< centre of mass, principal axes
  Vector3 half_edges;  ///< of the homogeneous box of this mass and inertia [m]
};

/// From the ten numbers of a body, by Jacobi's rotations [Golub & Van Loan 2013, 8.5].
/// Box: I_x = m (b^2 + c^2) / 3 with half edges a, b, c, so that a^2 = 3 (I_y + I_z - I_x) / (2 m).
PrincipalMass principalMass(const RigidInertia<double>& inertia);

/// Centres of mass of all bodies, and of the robot: the large one, with its projection onto the ground.
class CentreOfMassRenderer final : public PropertyRenderer {
 public:
  explicit CentreOfMassRenderer(const RenderedObject& object);
  void draw(const RenderMoment& now, DrawList& list) override;

 private:
  BodyPlaces places_;
  std::vector<PrincipalMass> bodies_;
};

/// Of every body the homogeneous box of its mass and inertia.
class InertiaRenderer final : public PropertyRenderer {
 public:
  explicit InertiaRenderer(const RenderedObject& object);
  void draw(const RenderMoment& now, DrawList& list) override;

 private:
  BodyPlaces places_;
  std::vector<PrincipalMass> bodies_;
};

}  // namespace murosimf
