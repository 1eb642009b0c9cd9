#pragma once

/// @file With which of its shapes a robot touches other robots, balls and posts.
///
/// Model      feet_only         the shapes of bodies that have a sole: it walks, kicks and is tripped over, and passes
///                              through everything else
///            bounding_spheres  every shape by the smallest sphere about its centre that holds it: cheap, found without
///                              a search, and touches too early
///            primitives        every shape as it is
///            Without one of them a robot touches nothing but the ground, which has modules of its own.
/// Phase      kPrescribe; the pair phase does the work (robot_pairs.h).
/// Adds       contact_detail.
/// Errors     feet_only: a robot without soles.
/// Cost       docs/collisions.md compares them.

#include "murosimf/linking/fixed_value.h"

namespace murosimf {

/// Values of contact_detail.
enum class ContactDetail { kFeet, kBoundingSpheres, kPrimitives };
inline constexpr int kContactDetails = 3;

class ShapeDetection : public BlockModule {
 public:
  void declare(Declaration& declaration) const override;
  void link(Links& links) override;
  void initialise(const BlockMemory& block) const override { value_.initialise(block); }
  void adopt(const BlockMemory& one) const override { value_.adopt(one); }
  void step(const BlockMemory&, const StepTime&) const override {}

 protected:
  explicit ShapeDetection(ContactDetail detail);

 private:
  ContactDetail detail_;
  FixedValue<double> value_;
};

class FeetOnly final : public ShapeDetection {
 public:
  FeetOnly() : ShapeDetection(ContactDetail::kFeet) {}
};
class BoundingSpheres final : public ShapeDetection {
 public:
  BoundingSpheres() : ShapeDetection(ContactDetail::kBoundingSpheres) {}
};
class Primitives final : public ShapeDetection {
 public:
  Primitives() : ShapeDetection(ContactDetail::kPrimitives) {}
};

}  // namespace murosimf
