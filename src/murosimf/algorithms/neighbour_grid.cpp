#include "murosimf/algorithms/neighbour_grid.h"

#include <algorithm>
#include <cmath>

namespace murosimf {

void NeighbourGrid::reserve(std::size_t discs) {
  entries_.reserve(discs);
  pairs_.reserve(8 * discs);
}

std::span<const std::pair<int, int>> NeighbourGrid::find(std::span<const PlaneDisc> discs) {
  pairs_.clear();
  sortIntoCells(discs);
  // Both lists of neighbours begin farther on for every further disc: what they pass is never looked at again.
  auto below = entries_.cbegin();
  for (auto e = entries_.cbegin(); e != entries_.cend(); ++e) {
    look(discs, *e, e + 1, e->row, e->column + 1);
    while (below != entries_.cend() && *below < Entry{e->row + 1, e->column - 1, 0}) ++below;
    look(discs, *e, below, e->row + 1, e->column + 1);
  }
  for (std::size_t i = 0; i < discs.size(); ++i) {
    if (std::isfinite(discs[i].radius)) continue;
    for (std::size_t j = 0; j < discs.size(); ++j) {
      const bool once = std::isfinite(discs[j].radius) || i < j;
      if (i != j && once) add(discs, static_cast<int>(i), static_cast<int>(j));
    }
  }
  std::sort(pairs_.begin(), pairs_.end());
  return pairs_;
}

void NeighbourGrid::sortIntoCells(std::span<const PlaneDisc> discs) {
  double widest = 1e-3;
  for (const PlaneDisc& disc : discs) {
    if (std::isfinite(disc.radius)) widest = std::max(widest, 2 * disc.radius);
  }
  entries_.clear();
  for (std::size_t i = 0; i < discs.size(); ++i) {
    const PlaneDisc& disc = discs[i];
    if (!std::isfinite(disc.radius)) continue;
    entries_.push_back({std::llround(disc.y / widest), std::llround(disc.x / widest), static_cast<int>(i)});
  }
  std::sort(entries_.begin(), entries_.end());
}

/// From an entry on, those that overlap, up to a cell of a row.
void NeighbourGrid::look(std::span<const PlaneDisc> discs, const Entry& from, Entries next, std::int64_t row,
                         std::int64_t last_column) {
  for (; next != entries_.cend() && next->row == row && next->column <= last_column; ++next)
    add(discs, from.disc, next->disc);
}

void NeighbourGrid::add(std::span<const PlaneDisc> discs, int a, int b) {
  if (overlap(discs[static_cast<std::size_t>(a)], discs[static_cast<std::size_t>(b)]))
    pairs_.emplace_back(std::min(a, b), std::max(a, b));
}

}  // namespace murosimf
