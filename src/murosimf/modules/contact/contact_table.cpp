#include "murosimf/modules/contact/contact_table.h"

#include <algorithm>

#include "murosimf/world/vocabulary.h"

namespace murosimf {

ContactTable::ContactTable(const World& world) {
  if (const SurfaceTable* table = world.findShared(world.root(), kSurfaceTable)) surfaces_ = *table;
  if (const auto* rules = world.findShared(world.root(), kContactRules)) rules_ = *rules;
}

int ContactTable::kindOf(const std::string& path, const std::string& surface) {
  Kind kind{path, surface, {}};
  for (const ContactRule& rule : rules_) {
    kind.sets.push_back(rule.a.contains(path));
    kind.sets.push_back(rule.b.contains(path));
  }
  const auto known = std::find_if(kinds_.begin(), kinds_.end(),
                                  [&](const Kind& k) { return k.surface == kind.surface && k.sets == kind.sets; });
  if (known != kinds_.end()) return static_cast<int>(known - kinds_.begin());
  kinds_.push_back(std::move(kind));
  return static_cast<int>(kinds_.size()) - 1;
}

void ContactTable::agree(int a, int b) { agreeOn(between_, a, b, false); }
void ContactTable::agreeWithin(int a, int b) { agreeOn(within_, a, b, true); }

void ContactTable::agreeOn(std::vector<int>& pairs, int a, int b, bool same_robot) {
  pairs.resize(kinds_.size() * kinds_.size(), -1);
  if (pairs[at(a, b)] >= 0) return;
  const Kind &first = kinds_[number(a)], &second = kinds_[number(b)];
  terms_.push_back(
      contactTerms(surfaces_, rules_, {first.path, first.surface}, {second.path, second.surface}, same_robot));
  pairs[at(a, b)] = pairs[at(b, a)] = static_cast<int>(terms_.size()) - 1;
}

}  // namespace murosimf
