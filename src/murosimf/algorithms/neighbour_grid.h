#pragma once

/// @file Which of many discs in the plane overlap: a grid of cells as wide as the widest disc.
///
/// A disc lies in the cell of its centre; whatever it overlaps lies in that cell or in one beside it. Discs are sorted
/// by cell. Discs of infinite radius overlap everything. Cost: O(n log n), to sort them.

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace murosimf {

struct PlaneDisc {
  double x = 0, y = 0, radius = 0;  ///< [m]
};

/// Whether two discs overlap; discs of infinite radius do always.
inline bool overlap(const PlaneDisc& a, const PlaneDisc& b) {
  const double reach = a.radius + b.radius, dx = a.x - b.x, dy = a.y - b.y;
  return dx * dx + dy * dy <= reach * reach;
}

class NeighbourGrid {
 public:
  void reserve(std::size_t discs);
  /// Numbers (i, j), i < j, of all discs that overlap, in ascending order. Valid until the next call.
  std::span<const std::pair<int, int>> find(std::span<const PlaneDisc> discs);

 private:
  struct Entry {
    std::int64_t row = 0, column = 0;
    int disc = 0;
    friend auto operator<=>(const Entry&, const Entry&) = default;
  };
  void sortIntoCells(std::span<const PlaneDisc> discs);
  using Entries = std::vector<Entry>::const_iterator;
  void look(std::span<const PlaneDisc> discs, const Entry& from, Entries next, std::int64_t row,
            std::int64_t last_column);
  void add(std::span<const PlaneDisc> discs, int a, int b);

  std::vector<Entry> entries_;
  std::vector<std::pair<int, int>> pairs_;
};

}  // namespace murosimf
