// The built-in table of surfaces: one entry for each unordered pair, and the documentation shows it.

#include <fmt/format.h>

#include <set>

#include "murosimf/scene/field_reader.h"
#include "scene/documented_table.h"

namespace murosimf::test {
namespace {

std::string builtInPairsAsMarkdown() {
  std::string text =
      "| pair | `law` | `stiffness` | `restitution_factor` | `dissipation` | `viscous_friction` | "
      "`friction_coefficient` | `stick_speed` | `turning_friction` | `rolling_resistance` |\n"
      "|---|---|---|---|---|---|---|---|---|---|\n";
  for (const SurfacePairSettings& p : builtInSurfacePairs()) {
    text += fmt::format("| {}, {} | {} | {:g} | {:g} | {:g} | {:g} | {:g} | {:g} | {:g} | {:g} |\n", p.first, p.second,
                        *p.law, *p.stiffness, *p.restitution_factor, *p.dissipation, *p.viscous_friction,
                        *p.friction_coefficient, *p.stick_speed, *p.turning_friction, *p.rolling_resistance);
  }
  return text;
}

TEST(SurfacePairs, TheDocumentationHoldsTheBuiltInOnes) { expectDocumented("surfaces", builtInPairsAsMarkdown()); }

TEST(SurfacePairs, StandOnceEachWhateverTheOrderOfTheirNames) {
  std::set<std::pair<std::string, std::string>> seen;
  for (const SurfacePairSettings& p : builtInSurfacePairs()) {
    EXPECT_LE(p.first, p.second) << "in the order of letters";
    EXPECT_TRUE(seen.emplace(p.first, p.second).second) << p.first << "-" << p.second;
  }
  const Scene one = readGood("[surfaces.ball-turf]\nstiffness = 2000\n"),
              other = readGood("[surfaces.turf-ball]\nstiffness = 2000\n");
  EXPECT_EQ(writeScenario(one), writeScenario(other));
  EXPECT_EQ(findSurfacePair(one, "turf", "ball"), findSurfacePair(one, "ball", "turf"));
  EXPECT_EQ(one.surfaces.size(), builtInSurfacePairs().size());
}

}  // namespace
}  // namespace murosimf::test
