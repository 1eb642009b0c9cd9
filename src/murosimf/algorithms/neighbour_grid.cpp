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
  for (const Entry& e : entries_) {
    look(discs, e, e.row, e.column);
    look(discs, e, e.row, e.column + 1);
    for (const std::int64_t beside : {-1, 0, 1}) look(discs, e, e.row + 1, e.column + beside);
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

/// Of the discs of one cell those that overlap; within one cell each pair once.
void NeighbourGrid::look(std::span<const PlaneDisc> discs, const Entry& from, std::int64_t row, std::int64_t column) {
  const bool same = row == from.row && column == from.column;
  auto next = std::lower_bound(entries_.begin(), entries_.end(), Entry{row, column, same ? from.disc + 1 : 0});
  for (; next != entries_.end() && next->row == row && next->column == column; ++next)
    add(discs, from.disc, next->disc);
}

void NeighbourGrid::add(std::span<const PlaneDisc> discs, int a, int b) {
  const PlaneDisc &p = discs[static_cast<std::size_t>(a)], &q = discs[static_cast<std::size_t>(b)];
  const double reach = p.radius + q.radius, dx = p.x - q.x, dy = p.y - q.y;
  if (dx * dx + dy * dy <= reach * reach) pairs_.emplace_back(std::min(a, b), std::max(a, b));
}

}  // namespace murosimf
