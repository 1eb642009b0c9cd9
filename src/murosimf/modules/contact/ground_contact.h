#pragma once

/// @file A robot's own contact with the ground z = 0.
///
/// Model      algorithms/ground_contact.h for every shape that collides; constants of the pair of its surface and the
///            ground's ("turf") in the world's surface_table, or those of ground_terms. Each point carries the pair's
///            stiffness over the number of points on which its shape rests: 4 of a box, 3 of a cylinder, 2 of a
///            capsule, 1 of an ellipsoid, as many of a convex hull as are below the ground (algorithms/ground_hull.h).
///            ground_contact          law and friction that the table says
///            paper_contact           `paper` and viscous friction [Friedmann 2007, 3.3.2]
///            smooth_contact          `smooth` and viscous friction; the default of simplified dynamics
///            hunt_crossley_contact   `hunt_crossley` and Coulomb friction; the default of multibody dynamics
///            Wheels and castors, whatever the law, have friction of their own (algorithms/ground_wheel.h): their
///            wheel_friction, wheel_stick_speed and wheel_creepage; one point carries the stiffness of the pair.
/// Phase      kEvaluate, before the dynamics.
/// Adds to    body_force; in steps that look ahead contact_touch, with contact_inertia where it is 1; sole_response of
///            the soles whose rectangle is the lower face of a box of their body, or next to which a hull of it has
///            vertices (sole_shares.h); touch_response of touch sensors.
/// Errors     a surface that has no pair with the ground; shapes on no row.
/// Cost       30 operations a shape in the air, 70 a point that touches; 10 a vertex of a hull that is near.
/// Exchange   with one another.

#include <optional>

#include "murosimf/linking/module.h"
#include "murosimf/modules/contact/ground_contact_kernel.h"
#include "murosimf/modules/contact/sole_shares.h"

namespace murosimf {

class GroundContact : public BlockModule {
 public:
  GroundContact() = default;
  void declare(Declaration& declaration) const override;
  void link(Links& links) override;
  void step(const BlockMemory& block, const StepTime& time) const override { kernel_(arguments_, block, time); }

 protected:
  GroundContact(NormalLaw normal, FrictionLaw friction) : laws_({normal, friction}) {}

 private:
  struct Laws {
    NormalLaw normal;
    FrictionLaw friction;
  };
  std::optional<Laws> laws_;
  void addShape(const PlacedShape& s, const SurfacePair& pair, const std::vector<SolePlace>& soles);
  void addWheel(const WheelPlace& place, int number, GroundShape& shape) const;
  void addVertices(const PlacedShape& s, const std::vector<SolePlace>& soles, GroundShape& shape);

  std::vector<GroundShape> shapes_;
  // Of each hull, what shapes_ point to.
  std::vector<std::vector<GroundPoint>> vertices_;
  std::vector<SoleShares> shares_;
  GroundContactArguments arguments_;
  KernelSet<GroundContactArguments>::Kernel kernel_ = nullptr;
};

class PaperContact final : public GroundContact {
 public:
  PaperContact() : GroundContact(NormalLaw::kPaper, FrictionLaw::kViscous) {}
};
class SmoothContact final : public GroundContact {
 public:
  SmoothContact() : GroundContact(NormalLaw::kSmooth, FrictionLaw::kViscous) {}
};
class HuntCrossleyContact final : public GroundContact {
 public:
  HuntCrossleyContact() : GroundContact(NormalLaw::kHuntCrossley, FrictionLaw::kCoulomb) {}
};

}  // namespace murosimf
