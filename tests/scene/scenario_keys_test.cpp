// The table of keys is what the reader does and what the documentation says.
#include <gtest/gtest.h>

#include <set>

#include "murosimf/scene/scenario_keys.h"
#include "scene/documented_table.h"

namespace murosimf::test {
namespace {

/// Of the keys of a pair, those whose default is not a matter of the pair.
const std::set<std::string_view> kBuiltInForPair = {"law", "blend_speed"};

/// The path with which `--set` reaches a key of a section.
std::string pathOf(const ScenarioKey& key) {
  const std::pair<const char*, const char*> examples[] = {
      {"robots.TEAM.NUMBER", "robots.red.1"}, {"teams.TEAM", "teams.red"},
      {"surfaces.A-B", "surfaces.ball-turf"}, {"MODULE", "robots.red.1.motion"},
      {"CONTROL", "robots.red.1.control"},    {"POSE", "robots.red.1.pose"},
      {"FOCUS", "robots.red.1.focus"}};
  for (const auto& [section, path] : examples)
    if (key.section == section) return std::string(path) + "." + std::string(key.key);
  return std::string(key.section) + "." + std::string(key.key);
}

bool isAccepted(const ScenarioKey& key, const std::string& value) {
  Diagnostics diagnostics;
  // Another value beside it may no longer fit; only what is said of this key counts.
  readScenarioText(kTwoRobots, kPlace, {pathOf(key) + "=" + value}, diagnostics);
  for (const Diagnostic& d : diagnostics.all())
    if (startsWith(d.message, std::string(key.key) + " is ") && d.message.find(expectation(key)) != std::string::npos)
      return false;
  return true;
}

TEST(ScenarioKeys, LimitsOfTheTableAreThoseOfTheReader) {
  int checked = 0;
  for (const ScenarioKey& key : scenarioKeys()) {
    if (!(key.upper > key.lower) || key.key == "lanes") continue;
    const bool whole = key.kind == ScenarioKey::Kind::kInteger;
    const double step = whole ? 1 : 1e-6;
    const auto text = [&](double v) { return whole ? std::to_string(static_cast<long long>(v)) : std::to_string(v); };
    EXPECT_FALSE(isAccepted(key, text(key.lower - step))) << pathOf(key);
    EXPECT_EQ(isAccepted(key, text(key.lower)), !key.above_lower || key.lower != 0) << pathOf(key);
    if (key.upper == kNoLimit) continue;
    EXPECT_TRUE(isAccepted(key, text(key.upper))) << pathOf(key);
    EXPECT_FALSE(isAccepted(key, text(key.upper + (key.upper > 1e5 ? 1 : step)))) << pathOf(key);
    ++checked;
  }
  EXPECT_GT(checked, 30);
}

TEST(ScenarioKeys, DefaultsOfTheTableAreThoseOfTheReader) {
  const std::string scenario = kTwoRobots + "[obstacles.NAME]\npose = [0, 1, 0]\n";
  const std::string without = writeScenario(readGood(scenario));
  int checked = 0;
  for (const ScenarioKey& key : scenarioKeys()) {
    if (key.fallback.empty() || key.section == "MODULE" || key.section == "POSE") continue;
    if (key.section == "surfaces.A-B" && kBuiltInForPair.count(key.key) == 0) continue;
    if (key.section == "FOCUS") continue;
    const Scene scene = readGood(scenario, {pathOf(key) + "=" + std::string(key.fallback)});
    EXPECT_EQ(writeScenario(scene), without) << pathOf(key);
    ++checked;
  }
  EXPECT_GT(checked, 30);
}

TEST(ScenarioKeys, DefaultsOfAFocusAreThoseOfTheReader) {
  const std::string focus = "robots.red.1.focus=\"multibody_dynamics\"",
                    without = writeScenario(readGood(kTwoRobots, {focus}));
  for (const ScenarioKey& key : scenarioKeys()) {
    if (key.section != "FOCUS") continue;
    const Scene scene = readGood(kTwoRobots, {focus, pathOf(key) + "=" + std::string(key.fallback)});
    EXPECT_EQ(writeScenario(scene), without) << pathOf(key);
  }
}

TEST(ScenarioKeys, EveryWordOfTheTableIsTaken) {
  for (const ScenarioKey& key : scenarioKeys()) {
    if (key.kind != ScenarioKey::Kind::kWord) continue;
    for (const std::string& word : allowedWords(key)) EXPECT_TRUE(isAccepted(key, "\"" + word + "\"")) << word;
    EXPECT_FALSE(isAccepted(key, "\"xyzzy\"")) << pathOf(key);
  }
}

TEST(ScenarioKeys, TheDocumentationHoldsTheTable) { expectDocumented("keys", scenarioKeysAsMarkdown()); }

}  // namespace
}  // namespace murosimf::test
