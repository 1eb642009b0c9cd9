#include <fmt/format.h>

#include <algorithm>
#include <tuple>
#include <utility>

#include "murosimf/scene/field_reader.h"
#include "murosimf/scene/table_reader.h"

namespace murosimf {

namespace {

struct BuiltInPair {
  const char *first, *second;
  double stiffness, restitution_factor, dissipation, viscous_friction, friction_coefficient, stick_speed,
      turning_friction, rolling_resistance;
};

// Ours, for frames of 1 ms and robots of 3.3 kg, whose bodies are of plastic. A sole sinks 1.6 mm into the turf; the
// ball bounces with sqrt(.35) = .59 from the turf, with sqrt(.5) = .71 from a foot, and slows down by
// c_rr g / (1 + beta) = .3 m/s^2 while it rolls. Robots touch each other harder, or thin parts would go through. A hoof
// is a round foot: its turning is resisted by a patch of radius r = 1 cm, s_nu = s_mu r^2 / 2.
// Law: smooth with ball and turf; hunt_crossley among robots and with posts, where it needs no Newton steps.
// The ball's dissipation gives hunt_crossley the same restitution at 1 m/s as the factor gives the other laws.
constexpr BuiltInPair kBuiltIn[] = {
    {"ball", "hoof", 3e3, .5, .61, 3, .5, .002, 0, 0},       {"ball", "plastic", 3e3, .5, .61, 3, .5, .002, 0, 0},
    {"ball", "post", 3e3, .6, .43, 2, .3, .002, 0, 0},       {"ball", "sole", 3e3, .5, .61, 3, .5, .002, 0, 0},
    {"ball", "turf", 3e3, .35, 1.01, 5, .5, .002, 0, .05},   {"hoof", "hoof", 1e5, .2, 5, 3, .4, .002, .0005, 0},
    {"hoof", "plastic", 1e5, .2, 5, 3, .4, .002, .0005, 0},  {"hoof", "post", 2e4, .3, 5, 3, .4, .002, .0005, 0},
    {"hoof", "sole", 1e5, .2, 5, 3, .4, .002, .0005, 0},     {"hoof", "turf", 2e4, .3, 20, 10, .8, .01, .0005, 0},
    {"plastic", "plastic", 1e5, .2, 5, 3, .4, .002, .05, 0}, {"plastic", "post", 2e4, .3, 5, 3, .4, .002, .05, 0},
    {"plastic", "sole", 1e5, .2, 5, 3, .4, .002, .05, 0},    {"plastic", "turf", 2e4, .3, 20, 8, .7, .01, .2, 0},
    {"post", "sole", 2e4, .3, 5, 3, .4, .002, .05, 0},       {"sole", "sole", 1e5, .2, 5, 3, .4, .002, .05, 0},
    {"sole", "turf", 2e4, .3, 20, 10, .8, .01, .1, 0},
};

bool isSurfaceName(std::string_view name) {
  return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
  });
}

/// Both names of "a-b" in the order of letters; empty ones when it is no pair.
std::pair<std::string, std::string> splitPair(std::string_view key) {
  const std::size_t dash = key.find('-');
  if (dash == key.npos || !isSurfaceName(key.substr(0, dash)) || !isSurfaceName(key.substr(dash + 1))) return {};
  std::pair<std::string, std::string> names{key.substr(0, dash), key.substr(dash + 1)};
  if (names.second < names.first) std::swap(names.first, names.second);
  return names;
}

SurfacePairSettings* findPair(std::vector<SurfacePairSettings>& pairs,
                              const std::pair<std::string, std::string>& names) {
  for (SurfacePairSettings& pair : pairs)
    if (pair.first == names.first && pair.second == names.second) return &pair;
  return nullptr;
}

std::vector<std::string> pairNames(const std::vector<SurfacePairSettings>& pairs) {
  std::vector<std::string> names;
  for (const SurfacePairSettings& pair : pairs) names.push_back(pair.first + "-" + pair.second);
  return names;
}

/// A pair that is not built in must say what nothing else can: how hard and how springy it is.
bool startNewPair(const TextNode& node, std::vector<SurfacePairSettings>& pairs, Diagnostics& diagnostics) {
  if (node.isTable() && node.find("stiffness") != nullptr && node.find("restitution_factor") != nullptr) return true;
  diagnostics.error(node.key_where,
                    fmt::format("surfaces.{} is no built-in pair, expected stiffness and restitution_factor for it{}",
                                printable(node.key), didYouMean(node.key, pairNames(pairs))));
  return false;
}

}  // namespace

void readSurfacePair(const TableReader& reader, SurfacePairSettings& pair, Diagnostics& diagnostics) {
  reader.read("law", pair.law);
  reader.read("stiffness", pair.stiffness);
  reader.read("restitution_factor", pair.restitution_factor);
  reader.read("blend_speed", pair.blend_speed);
  reader.read("dissipation", pair.dissipation);
  const bool said = reader.read("friction", pair.friction);
  const bool viscous = reader.read("viscous_friction", pair.viscous_friction);
  const bool coulomb = reader.read("friction_coefficient", pair.friction_coefficient);
  reader.read("stick_speed", pair.stick_speed);
  reader.read("turning_friction", pair.turning_friction);
  reader.read("rolling_resistance", pair.rolling_resistance);
  if (said || !coulomb) return;
  if (viscous) {
    diagnostics.error(pair.friction_coefficient.where,
                      "friction_coefficient and viscous_friction are both given, expected one of them, or friction to "
                      "say which one holds");
  }
  pair.friction = {"coulomb", pair.friction_coefficient.where};
}

std::vector<SurfacePairSettings> builtInSurfacePairs() {
  std::vector<SurfacePairSettings> pairs;
  for (const BuiltInPair& b : kBuiltIn) {
    SurfacePairSettings& pair = pairs.emplace_back();
    pair.first = b.first;
    pair.second = b.second;
    if (pair.first != "ball" && pair.second != "turf") pair.law.value = "hunt_crossley";
    pair.stiffness.value = b.stiffness;
    pair.restitution_factor.value = b.restitution_factor;
    pair.dissipation.value = b.dissipation;
    pair.viscous_friction.value = b.viscous_friction;
    pair.friction_coefficient.value = b.friction_coefficient;
    pair.stick_speed.value = b.stick_speed;
    pair.turning_friction.value = b.turning_friction;
    pair.rolling_resistance.value = b.rolling_resistance;
  }
  return pairs;
}

void normaliseSurfaces(TextNode& scenario, Diagnostics& diagnostics) {
  TextNode* surfaces = scenario.find("surfaces");
  if (surfaces == nullptr || !surfaces->isTable()) return;
  std::vector<TextNode> kept;
  for (TextNode& node : surfaces->children) {
    const auto [first, second] = splitPair(node.key);
    if (first.empty()) {
      diagnostics.error(node.key_where,
                        fmt::format("\"{}\" names no pair of surfaces, expected two names as in surfaces.ball-turf{}",
                                    printable(node.key), didYouMean(node.key, pairNames(builtInSurfacePairs()))));
      continue;
    }
    node.key = first + "-" + second;
    const auto same = std::find_if(kept.begin(), kept.end(), [&](const TextNode& n) { return n.key == node.key; });
    if (same == kept.end()) {
      kept.push_back(std::move(node));
    } else if (node.key_where.line == 0) {
      layOver(*same, node);
    } else {
      diagnostics.error(node.key_where, fmt::format("the pair {} is there twice, also in line {}, expected it once",
                                                    node.key, same->key_where.line));
    }
  }
  surfaces->children = std::move(kept);
}

std::vector<SurfacePairSettings> readSurfaces(const TextNode* table, Diagnostics& diagnostics) {
  std::vector<SurfacePairSettings> pairs = builtInSurfacePairs();
  if (table == nullptr) return pairs;
  if (!table->isTable()) {
    diagnostics.error(table->where, fmt::format("surfaces is {}, expected a table", describe(*table)));
    return pairs;
  }
  for (const TextNode& node : table->children) {
    const auto names = splitPair(node.key);
    SurfacePairSettings* pair = findPair(pairs, names);
    if (pair == nullptr) {
      if (!startNewPair(node, pairs, diagnostics)) continue;
      pair = &pairs.emplace_back();
      std::tie(pair->first, pair->second) = names;
    }
    const TableReader reader(&node, "surfaces.A-B", diagnostics);
    reader.refuseUnknownKeys();
    pair->where = node.key_where;
    readSurfacePair(reader, *pair, diagnostics);
  }
  std::sort(pairs.begin(), pairs.end(), [](const SurfacePairSettings& a, const SurfacePairSettings& b) {
    return std::tie(a.first, a.second) < std::tie(b.first, b.second);
  });
  return pairs;
}

}  // namespace murosimf
