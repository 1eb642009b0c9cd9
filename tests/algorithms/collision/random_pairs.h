#pragma once

/// @file Random pairs of shapes that touch, and an independent measure of how deep.
///
/// Sizes like parts of robots: 0.02 to 0.3 m. The pairs stand up to 10 m from the origin and overlap by 1e-5 to 1e-2 m
/// along some random direction; along the best one by no more. Every fourth pair is aligned: axes parallel within
/// 1e-2, 1e-5, 1e-9 rad or exactly, as feet on floors and boxes on boxes are.

#include <string>
#include <vector>

#include "murosimf/algorithms/collision/detect_contact.h"
#include "murosimf/math/random.h"

namespace murosimf::collision_test {

struct Dice {
  RandomStream stream;
  std::uint64_t step = 0;
  explicit Dice(std::uint64_t number) : stream{21, "collision_test", number} {}
  double uniform(double low, double high) { return stream.uniform(step++, low, high); }
  int below(int count) { return static_cast<int>(stream.bits(step++) % static_cast<std::uint64_t>(count)); }
  Vector3 direction() {
    const double z = uniform(-1, 1), angle = uniform(-kPi, kPi), s = sqrt(1 - z * z);
    return {s * cos(angle), s * sin(angle), z};
  }
  Vector3 inBox(double size) { return {uniform(-size, size), uniform(-size, size), uniform(-size, size)}; }
  Rotation3 rotation() {
    const Vector3 axis = direction();  // first: compilers differ in the order of operands
    return orthonormalized(rotationExp(axis * uniform(0, 3.1)));
  }
  Pose pose() { return {rotation(), inBox(10)}; }
};

struct Pair {
  CollisionShape a, b;
  Pose X_WA, X_WB;
  bool aligned = false;
};

std::string nameOf(CollisionKind kind);
/// The pairs that do not need a search over directions.
bool isClosedForm(CollisionKind a, CollisionKind b);
CollisionShape randomShape(CollisionKind kind, Dice& dice);
/// A plane, if any, must be a.
Pair randomPair(CollisionKind a, CollisionKind b, Dice& dice);

/// How far the shape reaches from its frame's origin along the unit vector n_S, by formulas of its own: for hulls over
/// all vertices. Infinite for a plane but along z.
double reach(const CollisionShape& shape, const Vector3& n_S);
/// Overlap along a unit vector from B to A, world.
double overlapAlong(const Pair& pair, const Vector3& n_W);

/// How far a point lies outside a shape [m], by 642 directions: never more than the truth.
double distanceOutside(const CollisionShape& shape, const Pose& X_WS, const Vector3& p_W);

/// What a sweep over directions finds.
struct Sweep {
  double depth = 0;  ///< least overlap [m]; an upper bound of the true one
  Vector3 normal;
  bool unique = false;  ///< no other direction is nearly as good: 1 degree away the overlap has grown by 3e-6 m,
                        ///< farther away by 1.5 % more, and other minima are deeper by 5 % and 2e-5 m. Two boxes,
                        ///< which prefer faces by 1 %: 1.5 % at 1 degree too
};
/// 642 directions, all face normals and products of edges; the best ones refined by shrinking random steps.
Sweep sweepDirections(const Pair& pair, Dice& dice);

}  // namespace murosimf::collision_test
