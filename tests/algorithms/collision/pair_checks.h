#pragma once

/// @file What must hold for every pair of shapes, whatever its method.

#include <string>

#include "algorithms/collision/random_pairs.h"

namespace murosimf::collision_test {

/// Counts over the random poses of one pair of kinds.
struct PairReport {
  int poses = 0, touching = 0, swept = 0, unique = 0;  ///< swept: of those that touch
  int unseen = 0;                                      ///< overlap by more than 1e-6 m that was not found
  int phantom = 0;                                     ///< contact where a direction separates the shapes
  int unequal = 0;                                     ///< swapped arguments gave other bits
  int moving = 0;                                      ///< moved with both bodies, the contact came out otherwise
  int inside = 0;        ///< moved apart by its depth along the normal, the shapes still overlap
  int inexact = 0;       ///< the depth is not the overlap along the normal
  int too_deep = 0;      ///< depth more than max(1e-5 m, 1 %) above that of the sweep
  int other_normal = 0;  ///< normal more than 1 degree off where the sweep calls it unique
  int astray = 0;    ///< a point whose surface points, half its depth off, lie outside their shapes by more than 2e-5 m
                     ///< (iterative pairs: 1e-4 m and 3 % of the depth)
  double worst = 0;  ///< largest depth above that of the sweep [m]
  std::string first;  ///< numbers of the first poses that failed
};

/// Every `sweep_every`th pose is compared with the sweep, which takes far longer than everything else.
PairReport checkPair(CollisionKind a, CollisionKind b, int poses, int sweep_every = 1);
std::string describe(CollisionKind a, CollisionKind b, const PairReport& report);

/// Runs checkPair and reports through GoogleTest what does not hold; shares outside the sweep may be 0.1 %.
void expectPairToHold(CollisionKind a, CollisionKind b, int poses, int sweep_every = 1);

}  // namespace murosimf::collision_test
