#pragma once

/// @file Mass, centre of mass and inertia of a rigid body, and the checks that a real body passes.

#include <string>

#include "murosimf/algorithms/shape.h"
#include "murosimf/math/transform.h"

namespace murosimf {

/// A symmetric 3x3 matrix, here an inertia [kg m^2].
struct SymmetricMatrix {
  double xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;
  friend bool operator==(const SymmetricMatrix&, const SymmetricMatrix&) = default;
};

/// C is the centre of mass, with the axes of B.
struct MassProperties {
  double mass = 0;          ///< [kg]
  Vector3 p_BC_B{};         ///< centre of mass [m]
  SymmetricMatrix I_C_B{};  ///< inertia about C, components in B [kg m^2]: xy is the entry of the matrix, -sum m x y
  friend bool operator==(const MassProperties&, const MassProperties&) = default;
};

/// Homogeneous box of these edges [m] about its centre.
MassProperties boxMass(double mass, const Vector3& edges, const Vector3& centre);

/// The same body seen from frame A: turned and moved by X_AB.
MassProperties moved(const Pose& X_AB, const MassProperties& body);

/// Two bodies in the same frame, welded: masses add, inertias meet at the common centre of mass (parallel axes).
MassProperties welded(const MassProperties& a, const MassProperties& b);

/// Principal moments A <= B <= C, by Jacobi's rotations [Golub & Van Loan 2013, 8.5].
Vector3 principalMoments(const SymmetricMatrix& inertia);

/// What keeps this from being a real body, with numbers, or "" when nothing does: mass > 0, finite numbers, inertia
/// positive definite, A + B >= C (up to 1e-6 C, for rounded digits).
std::string massProblem(const MassProperties& body);

}  // namespace murosimf
