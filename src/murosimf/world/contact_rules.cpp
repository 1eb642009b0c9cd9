#include "murosimf/world/contact_rules.h"

#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <stdexcept>

namespace murosimf {

namespace {

bool hasForm(std::string_view name, std::string_view form) {
  return fnmatch(std::string(form).c_str(), std::string(name).c_str(), FNM_NOESCAPE) == 0;
}

/// Cuts the first name off a dotted path.
std::string_view takeName(std::string_view& path) {
  const std::size_t dot = path.find('.');
  const std::string_view name = path.substr(0, dot);
  path = dot == path.npos ? std::string_view{} : path.substr(dot + 1);
  return name;
}

template <class T>
void replace(T& value, const std::optional<T>& change) {
  if (change) value = *change;
}

bool speaksOf(const ContactRule& rule, std::string_view a, std::string_view b, bool same_robot) {
  if ((rule.pairs == ContactRule::Pairs::kSelf) != same_robot) return false;
  if (rule.pairs != ContactRule::Pairs::kBetween) return rule.a.contains(a) && rule.a.contains(b);
  return (rule.a.contains(a) && rule.b.contains(b)) || (rule.a.contains(b) && rule.b.contains(a));
}

}  // namespace

bool patternMeans(std::string_view pattern, std::string_view path) {
  while (!pattern.empty()) {
    if (path.empty() || !hasForm(takeName(path), takeName(pattern))) return false;
  }
  return true;
}

bool ObjectSet::contains(std::string_view path) const {
  return std::any_of(patterns.begin(), patterns.end(), [&](const std::string& p) { return patternMeans(p, path); });
}

void SurfaceChange::applyTo(SurfacePair& pair) const {
  replace(pair.normal_law, normal_law);
  replace(pair.friction_law, friction_law);
  replace(pair.stiffness, stiffness);
  replace(pair.restitution_factor, restitution_factor);
  replace(pair.blend_speed, blend_speed);
  replace(pair.dissipation, dissipation);
  replace(pair.friction, friction);
  replace(pair.stick_speed, stick_speed);
  replace(pair.viscous_friction, viscous_friction);
  replace(pair.turning_friction, turning_friction);
  replace(pair.rolling_resistance, rolling_resistance);
}

ContactTerms contactTerms(const SurfaceTable& table, const std::vector<ContactRule>& rules, const ContactBody& a,
                          const ContactBody& b, bool same_robot) {
  ContactTerms terms;
  terms.check = !same_robot;
  const SurfacePair* pair = table.find(a.surface, b.surface);
  bool hard_enough = pair != nullptr;  // a rule may say what the table does not
  if (pair != nullptr) terms.surface = *pair;
  for (const ContactRule& rule : rules) {
    if (!speaksOf(rule, a.path, b.path, same_robot)) continue;
    replace(terms.check, rule.check);
    replace(terms.one_point, rule.one_point);
    rule.surface.applyTo(terms.surface);
    hard_enough = hard_enough || (rule.surface.stiffness && rule.surface.restitution_factor);
  }
  if (terms.check && !hard_enough) {
    throw std::invalid_argument(
        fmt::format("{0} and {1} may touch, but there is no surface pair of {2} and {3}; "
                    "expected [surfaces.{2}-{3}] in the scenario",
                    a.path, b.path, a.surface, b.surface));
  }
  return terms;
}

}  // namespace murosimf
