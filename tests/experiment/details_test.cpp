#include "experiment/details.h"

#include <gtest/gtest.h>

#include "murosimf/scene/scenario_reader.h"

namespace murosimf {
namespace {

namespace fs = std::filesystem;

const std::string kScenario = R"(
[robots.red.1]
file = "robots/ks21.urdf"
pose = [0, 0, 0]
level = "oracle"
control = "player"
modules.gyroscope_errors = {noise = 0.01}
cameras.head = {module = "ray_caster", shadows = true, antialias = false}
[robots.red.2]
file = "robots/ks21.urdf"
pose = [1, 0, 0]
motion = "multibody_dynamics"
collision = "feet_only"
cameras.head = "none"
)";

std::vector<Detail> find(const std::vector<std::string>& fixed = {}, const std::vector<std::string>& only = {}) {
  Diagnostics diagnostics;
  const fs::path file = fs::path(MUROSIMF_SOURCE_DIR) / "scenarios" / "text.toml";
  const std::optional<Scene> scene = readScenarioText(kScenario, file, fixed, diagnostics);
  EXPECT_TRUE(scene) << diagnostics.text();
  return scene ? detailsOf(*scene, fixed, only, diagnostics) : std::vector<Detail>{};
}

std::vector<std::string> paths(const std::vector<Detail>& details) {
  std::vector<std::string> out;
  for (const Detail& detail : details) out.push_back(detail.path);
  return out;
}

TEST(Details, AreWhatCanBeCheaper) {
  EXPECT_EQ(paths(find()),
            (std::vector<std::string>{"robots.red.1.level", "robots.red.1.cameras.chest", "robots.red.1.cameras.head",
                                      "robots.red.1.cameras.head.shadows", "robots.red.1.localisation",
                                      "robots.red.1.collision", "robots.red.1.modules.gyroscope_errors",
                                      "robots.red.2.cameras.chest"}));
}

TEST(Details, BeginWithFullDetailWhateverTheScenarioSays) {
  const std::vector<Detail> details = find();
  EXPECT_EQ(overridesOf(details, Choices(details.size(), 0)),
            (std::vector<std::string>{"robots.red.1.level=full", "robots.red.1.cameras.chest=ray_caster",
                                      "robots.red.1.cameras.head=ray_caster", "robots.red.1.cameras.head.shadows=true",
                                      "robots.red.1.localisation=none", "robots.red.1.collision=primitives",
                                      "robots.red.1.modules.gyroscope_errors=gyroscope_errors",
                                      "robots.red.2.cameras.chest=ray_caster"}));
}

TEST(Details, OfACameraGoWithItsPictures) {
  const std::vector<Detail> details = find();
  Choices choices(details.size(), 0);
  choices[2] = 1;
  EXPECT_FALSE(isMeant(details, choices, 3));
  EXPECT_EQ(overridesOf(details, choices).size(), details.size() - 1);
}

TEST(Details, ThatTheUserHasSetAreNone) {
  const std::vector<std::string> fixed = {"robots.all.level=kinematic", "teams.red.cameras.chest=none",
                                          "robots.red.1.cameras.head.noise=0", "robots.red.1.collision=primitives",
                                          "robots.red.1.localisation=none"};
  EXPECT_EQ(paths(find(fixed)), (std::vector<std::string>{"robots.red.1.modules.gyroscope_errors"}));
}

TEST(Details, CanBeChosenByTheBeginningOfTheirPaths) {
  EXPECT_EQ(paths(find({}, {"robots.red.2"})), (std::vector<std::string>{"robots.red.2.cameras.chest"}));
  EXPECT_EQ(paths(find({}, {"robots.red.1.level", "robots.red.1.cameras.head"})),
            (std::vector<std::string>{"robots.red.1.level", "robots.red.1.cameras.head",
                                      "robots.red.1.cameras.head.shadows"}));
}

/// Each choice must be one that the reader and the builder's tables know: a misspelt word would only show in a game.
TEST(Details, AreWordsOfTheScenario) {
  const std::vector<Detail> details = find();
  const fs::path file = fs::path(MUROSIMF_SOURCE_DIR) / "scenarios" / "text.toml";
  for (std::size_t d = 0; d < details.size(); ++d) {
    for (std::size_t c = 0; c < details[d].choices.size(); ++c) {
      Choices choices(details.size(), 0);
      choices[d] = c;
      Diagnostics diagnostics;
      EXPECT_TRUE(readScenarioText(kScenario, file, overridesOf(details, choices), diagnostics)) << diagnostics.text();
    }
  }
}

}  // namespace
}  // namespace murosimf
