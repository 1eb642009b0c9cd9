#include "murosimf/scene/contact_builder.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "murosimf/world/vocabulary.h"

namespace murosimf {

namespace {

NormalLaw normalLaw(const std::string& name) {
  return name == "paper" ? NormalLaw::kPaper : name == "hunt_crossley" ? NormalLaw::kHuntCrossley : NormalLaw::kSmooth;
}
FrictionLaw frictionLaw(const std::string& name) {
  return name == "coulomb" ? FrictionLaw::kCoulomb : FrictionLaw::kViscous;
}

std::optional<double> given(const Located<double>& value) {
  return value.given() ? std::optional(*value) : std::nullopt;
}

SurfaceChange changeOf(const SurfacePairSettings& s) {
  SurfaceChange change;
  if (s.law.given()) change.normal_law = normalLaw(*s.law);
  if (s.friction.given()) change.friction_law = frictionLaw(*s.friction);
  change.stiffness = given(s.stiffness);
  change.restitution_factor = given(s.restitution_factor);
  change.blend_speed = given(s.blend_speed);
  change.dissipation = given(s.dissipation);
  change.friction = given(s.friction_coefficient);
  change.stick_speed = given(s.stick_speed);
  change.viscous_friction = given(s.viscous_friction);
  change.turning_friction = given(s.turning_friction);
  change.rolling_resistance = given(s.rolling_resistance);
  return change;
}

ContactRule ruleOf(const ContactRuleSettings& s) {
  using Pairs = ContactRule::Pairs;
  ContactRule rule;
  rule.pairs = s.self.given() ? Pairs::kSelf : s.within.given() ? Pairs::kWithin : Pairs::kBetween;
  rule.a.patterns = s.self.given() ? *s.self : s.within.given() ? *s.within : *s.between;
  rule.b.patterns = *s.with;
  if (s.check.given()) rule.check = *s.check;
  if (s.points.given()) rule.one_point = *s.points == "one";
  rule.surface = changeOf(s.surface);
  return rule;
}

/// Paths of all bodies that can touch anything.
std::vector<std::string> pathsOfBodies(const World& world, const Participants& participants) {
  std::vector<std::string> paths{std::string(kGroundPath)};
  for (const ObjectId robot : participants.robots) {
    for (const ObjectId body : world.members(robot, subset::kBodies)) paths.push_back(world.path(body));
  }
  for (const ObjectId id : participants.free_bodies) paths.push_back(world.path(id));
  for (const ObjectId id : participants.fixed) paths.push_back(world.path(id));
  return paths;
}

void checkNames(const Located<std::vector<std::string>>& names, const std::string& rule,
                const std::vector<std::string>& paths, Diagnostics& diagnostics) {
  for (const std::string& name : *names) {
    const bool known =
        std::any_of(paths.begin(), paths.end(), [&](const std::string& path) { return patternMeans(name, path); });
    if (known) continue;
    diagnostics.error(
        names.where,
        fmt::format("\"{}\" in contacts.{} means no body of this scenario, expected a name as in {} or {}{}", name,
                    rule, paths.back(), kGroundPath, didYouMean(name, paths)));
  }
}

/// Of each of its shapes; empty where no rule speaks of the robot and the ground.
std::vector<ContactTerms> groundTerms(const World& world, ObjectId robot, const std::vector<ContactRule>& rules) {
  const SurfaceTable& table = *world.findShared(world.root(), kSurfaceTable);
  const ContactBody ground{kGroundPath, kGroundSurface};
  std::vector<ContactTerms> terms;
  for (const PlacedShape& shape : *world.findShared(robot, kShapes)) {
    const ObjectId body = world.members(robot, subset::kBodies)[static_cast<std::size_t>(shape.row)];
    terms.push_back(shape.collides ? contactTerms(table, rules, {world.path(body), shape.surface}, ground, false)
                                   : ContactTerms{});
  }
  return terms;
}

bool speaksOfGround(const ContactRule& rule) { return rule.a.contains(kGroundPath) || rule.b.contains(kGroundPath); }

}  // namespace

void addSurfaces(World& world, const Scene& scene) {
  SurfaceTable table;
  for (const SurfacePairSettings& s : scene.surfaces) {
    SurfacePair pair;
    pair.normal_law = normalLaw(*s.law);
    pair.friction_law = frictionLaw(*s.friction);
    pair.stiffness = *s.stiffness;
    pair.restitution_factor = *s.restitution_factor;
    pair.blend_speed = *s.blend_speed;
    pair.dissipation = *s.dissipation;
    pair.friction = *s.friction_coefficient;
    pair.stick_speed = *s.stick_speed;
    pair.viscous_friction = *s.viscous_friction;
    pair.turning_friction = *s.turning_friction;
    pair.rolling_resistance = *s.rolling_resistance;
    table.set(s.first, s.second, pair);
  }
  world.set(world.root(), kSurfaceTable, std::move(table));
}

void addContactRules(World& world, const Scene& scene, const Participants& participants, Diagnostics& diagnostics) {
  if (scene.contacts.empty()) return;
  const std::vector<std::string> paths = pathsOfBodies(world, participants);
  std::vector<ContactRule> rules;
  for (const ContactRuleSettings& s : scene.contacts) {
    for (const auto* names : {&s.between, &s.with, &s.within, &s.self}) checkNames(*names, s.name, paths, diagnostics);
    rules.push_back(ruleOf(s));
  }
  if (std::any_of(rules.begin(), rules.end(), speaksOfGround)) {
    for (const ObjectId robot : participants.robots) {
      try {
        world.set(robot, kGroundTerms, groundTerms(world, robot, rules));
      } catch (const std::invalid_argument& problem) {
        diagnostics.error({scene.file.string(), 0, 0}, problem.what());
      }
    }
  }
  world.set(world.root(), kContactRules, std::move(rules));
}

}  // namespace murosimf
