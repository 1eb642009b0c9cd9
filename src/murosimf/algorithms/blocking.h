#pragma once

/// @file Robots that move by prescription do not walk through one another nor through posts.
///
/// In the plane a robot is an upright disc with a last and a wanted next position. Where two discs would overlap at
/// the wanted positions, the part of each displacement that brings it nearer to the other beyond contact is taken
/// away. n from j to i at the last positions, g >= 0 the gap, a_i = -n.d_i and a_j = n.d_j the approaches:
///     excess = a_i + a_j - g;   d_i += n excess a_i+ / (a_i+ + a_j+),   d_j -= n excess a_j+ / (a_i+ + a_j+),  a+ =
///     max(a, 0)
/// so a standing robot is not pushed, a fleeing one not held, and motion along the other stays. The linearised gap is
/// never larger than the true one: no overlap is left. Several contacts: sweeps in the order of names; who then still
/// is in the way stands still. Discs that overlap already (a teleport, a step that was longer than foreseen) part at up
/// to 0.5 m/s: who comes nearer goes back, half each when neither does, a post never. Discs that touch nothing keep
/// their displacement bit by bit. Limits: a displacement must be smaller than the sum of radii (no disc is met in
/// mid-path).

#include <cstdint>
#include <span>
#include <vector>

#include "murosimf/algorithms/neighbour_list.h"

namespace murosimf {

struct BlockingDisc {
  std::uint64_t name = 0;  ///< hashName() of the robot or post: order of treatment
  bool fixed = false;      ///< a post: keeps its displacement (0)
  double radius = 0;       ///< [m]
  double x = 0, y = 0;     ///< last position [m]
  double dx = 0, dy = 0;   ///< in: wanted displacement in this update; out: allowed one [m]
};

class BlockingRule {
 public:
  struct Settings {
    int sweeps = 16;
    double separation_speed = 0.5;  ///< [m/s] of two discs relative to one another
  };

  BlockingRule() = default;
  explicit BlockingRule(const Settings& settings) : settings_(settings) {}
  void reserve(int discs);
  /// Corrects the displacements of one update of length dt [s]. The order of discs does not matter.
  /// Cost: a few operations a disc (neighbour_list.h), then a few ns per pair that is near.
  void apply(std::span<BlockingDisc> discs, double dt);

 private:
  struct Pair {
    int first, second;  // in the order of names
  };
  void findPairs(std::span<const BlockingDisc> discs);
  void stopTheRest(std::span<BlockingDisc> discs) const;

  Settings settings_;
  double margin_ = 0;  // [m] that a separation may move a disc in this update
  NeighbourList near_;
  std::vector<PlaneDisc> circles_;  // of what each disc can reach
  std::vector<Pair> pairs_;
};

}  // namespace murosimf
