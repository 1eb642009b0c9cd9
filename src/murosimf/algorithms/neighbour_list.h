#pragma once

/// @file Which of many discs overlap, frame after frame: pairs that may soon are listed, and listed anew only when that
/// does not hold any more [Verlet 1967].
///
/// Every disc is listed within a wider one. As long as all discs lie within those, whatever overlaps is on the list, so
/// what find() tells is what neighbour_grid.h would. No state therefore. Cost: a few operations a disc, and those of
/// the grid whenever some disc has moved or grown by the margin.

#include "murosimf/algorithms/neighbour_grid.h"

namespace murosimf {

class NeighbourList {
 public:
  /// @param margin  by which discs are listed wider [m], > 0
  explicit NeighbourList(double margin = 0.1) : margin_(margin) {}
  void reserve(std::size_t discs);
  /// Numbers (i, j), i < j, of all discs that overlap, in ascending order. Valid until the next call.
  std::span<const std::pair<int, int>> find(std::span<const PlaneDisc> discs);

 private:
  bool holds(std::span<const PlaneDisc> discs) const;

  double margin_;
  NeighbourGrid grid_;
  std::vector<PlaneDisc> listed_;
  std::vector<std::pair<int, int>> listed_pairs_, pairs_;
};

}  // namespace murosimf
