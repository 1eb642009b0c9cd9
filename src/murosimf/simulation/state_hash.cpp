#include "murosimf/simulation/state_hash.h"

#include "murosimf/math/random.h"

namespace murosimf {

std::uint64_t hashState(const LinkedWorld& linked, const Place& place) {
  std::uint64_t hash = 0;
  linked.visitState(place, [&](const ColumnLayout&, int, int, double value) {
    hash = mixBits(hash ^ __builtin_bit_cast(std::uint64_t, value));
  });
  return hash;
}

std::uint64_t hashState(const LinkedWorld& linked) {
  std::uint64_t hash = 0;
  for (const Place& place : linked.places()) hash = mixBits(hash ^ hashState(linked, place));
  return hash;
}

}  // namespace murosimf
