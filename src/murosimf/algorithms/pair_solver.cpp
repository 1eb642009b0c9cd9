#include "murosimf/algorithms/pair_solver.h"

#include <algorithm>
#include <numeric>

#include "murosimf/algorithms/island_solver.h"

namespace murosimf {

PairSolver::PairSolver() : PairSolver(Settings{}) {}
PairSolver::PairSolver(const Settings& settings) : islands_(std::make_unique<IslandSolver>(settings)) {}
PairSolver::~PairSolver() = default;
PairSolver::PairSolver(PairSolver&&) noexcept = default;
PairSolver& PairSolver::operator=(PairSolver&&) noexcept = default;

void PairSolver::reserve(int bodies, int pairs) {
  kept_.reserve(static_cast<std::size_t>(pairs));
  recalled_.reserve(static_cast<std::size_t>(pairs));
  order_.reserve(static_cast<std::size_t>(pairs));
  sorted_.reserve(static_cast<std::size_t>(pairs));
  islands_->reserve(static_cast<std::size_t>(bodies), static_cast<std::size_t>(pairs));
}

void PairSolver::advance(FrameContacts& frame, double dt) {
  sortByKey(frame.pairs);
  recall(frame);
  islands_->advance(frame, recalled_, dt);
  sumPartners(frame);
  kept_.clear();
  for (const KeptContact& contact : recalled_)
    if (contact.depth > 0 || contact.normal_force > 0) kept_.push_back(contact);
}

/// Sorts numbers and moves each pair once: a pair is half a kilobyte.
void PairSolver::sortByKey(std::vector<ContactPair>& pairs) {
  const auto at = [&](int i) -> const ContactPair& { return pairs[static_cast<std::size_t>(i)]; };
  order_.resize(pairs.size());
  std::iota(order_.begin(), order_.end(), 0);
  std::sort(order_.begin(), order_.end(), [&](int a, int b) { return at(a).key < at(b).key; });
  sorted_.clear();
  for (const int i : order_) sorted_.push_back(at(i));
  pairs.swap(sorted_);
}

namespace {

bool sameShapes(const ContactKey& a, const ContactKey& b) {
  return a.name_a == b.name_a && a.name_b == b.name_b && a.shape_a == b.shape_a && a.shape_b == b.shape_b;
}

using Kept = std::span<const KeptContact>;

const KeptContact* find(Kept kept, const ContactKey& key) {
  const auto found = std::find_if(kept.begin(), kept.end(), [&](const KeptContact& k) { return k.key == key; });
  return found == kept.end() ? nullptr : &*found;
}

/// What a point that is new between two shapes inherits of those that they had: how they met, and an even share of the
/// forces of points that are gone.
KeptContact inherited(const ContactKey& key, Kept kept, std::span<const ContactPair> pairs) {
  KeptContact fresh = freshContact(key);
  double heirs = 0;
  for (const ContactPair& pair : pairs) heirs += find(kept, pair.key) == nullptr ? 1 : 0;
  for (const KeptContact& old : kept) {
    fresh.depth = max(fresh.depth, old.depth);
    fresh.approach_speed = max(fresh.approach_speed, old.approach_speed);
    fresh.overlapped = std::max(fresh.overlapped, old.overlapped);
    const bool lives = std::any_of(pairs.begin(), pairs.end(), [&](const ContactPair& p) { return p.key == old.key; });
    if (lives) continue;
    fresh.normal_force += old.normal_force / heirs;
    fresh.friction_force += old.friction_force * (1 / heirs);
  }
  return fresh;
}

}  // namespace

/// One memory per pair; both lists are sorted by key, so that points of the same two shapes stand together.
void PairSolver::recall(FrameContacts& frame) {
  recalled_.clear();
  auto last = kept_.cbegin();
  for (auto first = frame.pairs.begin(); first != frame.pairs.end();) {
    const auto differs = [&](const auto& contact) { return !sameShapes(contact.key, first->key); };
    const auto end = std::find_if(first, frame.pairs.end(), differs);
    while (last != kept_.cend() && last->key < first->key && !sameShapes(last->key, first->key)) ++last;
    const auto last_end = std::find_if(last, kept_.cend(), differs);
    const Kept kept(last, last_end);
    for (auto pair = first; pair != end; ++pair) {
      pair->impulse = pair->moment_A = pair->moment_B = {};
      pair->touched = false;
      const KeptContact* known = find(kept, pair->key);
      pair->fresh = known == nullptr;
      recalled_.push_back(known != nullptr ? *known : inherited(pair->key, kept, std::span(first, end)));
    }
    first = end, last = last_end;
  }
}

/// In the order of keys, so that the sum's rounding depends on names alone.
void PairSolver::sumPartners(FrameContacts& frame) {
  for (ContactPartner& partner : frame.partners) partner.impulse = partner.angular_impulse = {};
  const auto add = [&](const ContactSide& side, const Vector3& impulse, const Vector3& moment) {
    if (side.partner < 0) return;
    ContactPartner& partner = frame.partners[static_cast<std::size_t>(side.partner)];
    partner.impulse += impulse;
    partner.angular_impulse += moment;
  };
  for (const ContactPair& pair : frame.pairs) {
    add(pair.a, pair.impulse, pair.moment_A);
    add(pair.b, -pair.impulse, pair.moment_B);
  }
}

}  // namespace murosimf
