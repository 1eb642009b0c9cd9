#include "murosimf/algorithms/blocking.h"

#include <algorithm>

#include "murosimf/math/vec3.h"

namespace murosimf {
namespace {

constexpr double kTouch = 1e-9;  // [m]: closer than this to contact counts as contact, so rounding blocks nobody

double excessOverlap(const BlockingDisc& a, const BlockingDisc& b, double wanted_distance) {
  const double x = (a.x + a.dx) - (b.x + b.dx), y = (a.y + a.dy) - (b.y + b.dy);
  return wanted_distance - sqrt(x * x + y * y);
}

/// Unit vector from b to a at their last positions; of two discs on one spot, along x.
struct Direction {
  double x, y, distance;
};
Direction between(const BlockingDisc& a, const BlockingDisc& b) {
  const double x = a.x - b.x, y = a.y - b.y, distance = sqrt(x * x + y * y);
  return distance > 0 ? Direction{x / distance, y / distance, distance} : Direction{1, 0, 0};
}

double along(const Direction& n, const BlockingDisc& d) { return n.x * d.dx + n.y * d.dy; }
void add(BlockingDisc& d, const Direction& n, double size) {
  d.dx += n.x * size;
  d.dy += n.y * size;
}

/// Takes from both what brings them nearer than the gap allows, each in proportion to its own approach.
void removeApproach(BlockingDisc& a, BlockingDisc& b, const Direction& n, double gap) {
  const double by_a = -along(n, a), by_b = along(n, b);
  const double excess = by_a + by_b - max(gap, 0.0);
  const double share_a = max(by_a, 0.0), share_b = max(by_b, 0.0), sum = share_a + share_b;
  if (excess <= 0 || sum <= 0) return;
  add(a, n, excess * (share_a / sum));
  add(b, n, -excess * (share_b / sum));
}

/// What a takes of a correction between the two: in proportion to its own approach, half when neither comes nearer.
double shareOf(const BlockingDisc& a, const BlockingDisc& b, const Direction& n) {
  if (a.fixed || b.fixed) return a.fixed ? 0.0 : 1.0;
  const double by_a = max(-along(n, a), 0.0), by_b = max(along(n, b), 0.0), sum = by_a + by_b;
  return sum > 0 ? by_a / sum : 0.5;
}

/// Parts two discs that overlap at their last positions, by at most `most` in this update.
void separate(BlockingDisc& a, BlockingDisc& b, const Direction& n, double overlap, double most, double share_a) {
  const double wanted = min(overlap, most) - (along(n, a) - along(n, b));
  if (wanted <= 0) return;
  if (!a.fixed) add(a, n, wanted * share_a);
  if (!b.fixed) add(b, n, -wanted * (1 - share_a));
}

/// Whether two discs still come nearer than allowed: to contact, or to where they already were.
bool violates(const BlockingDisc& a, const BlockingDisc& b) {
  const double allowed = min(a.radius + b.radius, between(a, b).distance);
  return excessOverlap(a, b, allowed) > kTouch;
}

bool correct(BlockingDisc& a, BlockingDisc& b, double most) {
  const double reach = a.radius + b.radius;
  if (excessOverlap(a, b, reach) <= kTouch) return false;
  const Direction n = between(a, b);
  const double share_a = shareOf(a, b, n);
  removeApproach(a, b, n, n.distance - reach);
  if (n.distance < reach - kTouch) separate(a, b, n, reach - n.distance, most, share_a);
  return true;
}

}  // namespace

void BlockingRule::reserve(int discs) {
  near_.reserve(static_cast<std::size_t>(discs));
  circles_.reserve(static_cast<std::size_t>(discs));
  pairs_.reserve(16 * static_cast<std::size_t>(discs));
}

/// Pairs whose squares of reach (radius and displacement) overlap, sorted by name.
void BlockingRule::findPairs(std::span<const BlockingDisc> discs) {
  const auto disc = [&](int i) -> const BlockingDisc& { return discs[static_cast<std::size_t>(i)]; };
  // Corrections may turn a displacement, hence its whole length on every side, and a step of separation.
  const auto reach = [&](const BlockingDisc& d) { return d.radius + 2 * (abs(d.dx) + abs(d.dy)) + margin_; };
  constexpr double kCorner = 1.42;  // a circle about a square, over half of its side
  circles_.clear();
  pairs_.clear();
  for (const BlockingDisc& d : discs) circles_.push_back({d.x, d.y, kCorner * reach(d)});
  for (const auto& [i, j] : near_.find(circles_)) {
    if (disc(i).fixed && disc(j).fixed) continue;
    const double far = reach(disc(i)) + reach(disc(j));
    if (abs(disc(i).x - disc(j).x) > far || abs(disc(i).y - disc(j).y) > far) continue;
    pairs_.push_back(disc(i).name < disc(j).name ? Pair{i, j} : Pair{j, i});
  }
  std::sort(pairs_.begin(), pairs_.end(), [&](const Pair& a, const Pair& b) {
    const std::uint64_t first_a = disc(a.first).name, first_b = disc(b.first).name;
    return first_a != first_b ? first_a < first_b : disc(a.second).name < disc(b.second).name;
  });
}

void BlockingRule::apply(std::span<BlockingDisc> discs, double dt) {
  const double most = settings_.separation_speed * dt;
  margin_ = 2 * most;
  findPairs(discs);
  for (int sweep = 0; sweep < settings_.sweeps; ++sweep) {
    bool changed = false;
    for (const Pair& pair : pairs_) {
      const auto first = static_cast<std::size_t>(pair.first), second = static_cast<std::size_t>(pair.second);
      changed |= correct(discs[first], discs[second], most);
    }
    if (!changed) return;
  }
  stopTheRest(discs);
}

/// Who stands still is in nobody's way who stands still: stopping ends, at the latest when all of a crowd stand.
void BlockingRule::stopTheRest(std::span<BlockingDisc> discs) const {
  const auto stop = [](BlockingDisc& d) {
    const bool moved = !d.fixed && (d.dx != 0 || d.dy != 0);
    if (moved) d.dx = d.dy = 0;
    return moved;
  };
  for (bool changed = true; changed;) {
    changed = false;
    for (const Pair& pair : pairs_) {
      BlockingDisc& a = discs[static_cast<std::size_t>(pair.first)];
      BlockingDisc& b = discs[static_cast<std::size_t>(pair.second)];
      if (!violates(a, b)) continue;
      const Direction n = between(a, b);
      // A pusher first; one that flees too slowly from a pusher is left alone.
      if (-along(n, a) > 0) changed |= stop(a);
      if (along(n, b) > 0) changed |= stop(b);
    }
  }
}

}  // namespace murosimf
