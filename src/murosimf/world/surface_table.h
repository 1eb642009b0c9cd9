#pragma once

/// @file What happens between types of surface: one entry per unordered pair of names, stored once.

#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "murosimf/algorithms/surface_pair.h"

namespace murosimf {

class SurfaceTable {
 public:
  /// Sets the entry of a pair in either order, replacing an earlier one.
  void set(std::string_view a, std::string_view b, const SurfacePair& pair) {
    pairs_.insert_or_assign(key(a, b), pair);
  }
  /// The entry of a pair in either order; null when there is none.
  const SurfacePair* find(std::string_view a, std::string_view b) const {
    const auto found = pairs_.find(key(a, b));
    return found == pairs_.end() ? nullptr : &found->second;
  }

  friend bool operator==(const SurfaceTable&, const SurfaceTable&) = default;

 private:
  using Key = std::pair<std::string, std::string>;
  static Key key(std::string_view a, std::string_view b) { return a < b ? Key(a, b) : Key(b, a); }
  std::map<Key, SurfacePair> pairs_;
};

}  // namespace murosimf
