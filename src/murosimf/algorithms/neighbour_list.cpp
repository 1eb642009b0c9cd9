#include "murosimf/algorithms/neighbour_list.h"

#include <cmath>

namespace murosimf {

void NeighbourList::reserve(std::size_t discs) {
  constexpr std::size_t kNeighbours = 8;
  grid_.reserve(discs);
  listed_.reserve(discs);
  listed_pairs_.reserve(kNeighbours * discs);
  pairs_.reserve(kNeighbours * discs);
}

/// Whether every disc lies within the one that is listed for it. Nothing lies where numbers are none.
bool NeighbourList::holds(std::span<const PlaneDisc> discs) const {
  if (discs.size() != listed_.size()) return false;
  for (std::size_t i = 0; i < discs.size(); ++i) {
    const PlaneDisc &disc = discs[i], &listed = listed_[i];
    if (std::isinf(disc.radius) && std::isinf(listed.radius)) continue;  // overlaps everything, wherever it is
    const double room = listed.radius - disc.radius, dx = disc.x - listed.x, dy = disc.y - listed.y;
    if (!(room >= 0 && dx * dx + dy * dy <= room * room)) return false;
  }
  return true;
}

std::span<const std::pair<int, int>> NeighbourList::find(std::span<const PlaneDisc> discs) {
  if (!holds(discs)) {
    listed_.assign(discs.begin(), discs.end());
    for (PlaneDisc& disc : listed_) disc.radius += margin_;
    const auto found = grid_.find(listed_);
    listed_pairs_.assign(found.begin(), found.end());
  }
  pairs_.clear();
  for (const auto& [i, j] : listed_pairs_) {
    if (overlap(discs[static_cast<std::size_t>(i)], discs[static_cast<std::size_t>(j)])) pairs_.emplace_back(i, j);
  }
  return pairs_;
}

}  // namespace murosimf
