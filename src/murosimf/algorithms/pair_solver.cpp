#include "murosimf/algorithms/pair_solver.h"

#include <algorithm>

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
  islands_->reserve(static_cast<std::size_t>(bodies), static_cast<std::size_t>(pairs));
}

void PairSolver::advance(FrameContacts& frame, double dt) {
  std::sort(frame.pairs.begin(), frame.pairs.end(),
            [](const ContactPair& a, const ContactPair& b) { return a.key < b.key; });
  recall(frame);
  islands_->advance(frame, recalled_, dt);
  sumPartners(frame);
  kept_.clear();
  for (const KeptContact& contact : recalled_)
    if (contact.depth > 0 || contact.normal_force > 0) kept_.push_back(contact);
}

/// One memory per pair; both lists are sorted by key.
void PairSolver::recall(FrameContacts& frame) {
  recalled_.clear();
  auto last = kept_.cbegin();
  for (ContactPair& pair : frame.pairs) {
    pair.impulse = pair.moment_A = pair.moment_B = {};
    pair.touched = false;
    while (last != kept_.cend() && last->key < pair.key) ++last;
    const bool known = last != kept_.cend() && last->key == pair.key;
    recalled_.push_back(known ? *last : freshContact(pair.key));
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
