// What reports tell of integrators that choose their own steps.

#include "murosimf/simulation/integration_statistics.h"

#include "simulation/walkers.h"

namespace murosimf::test {
namespace {

TEST(IntegrationStatistics, TellStepsAndErrorOfWhoeverChoosesItsStepsAndOfNobodyElse) {
  BuiltWorld built(walkers(3), {"robots.red.1.motion=multibody_dynamics", "robots.red.1.integration=dormand_prince",
                                "robots.red.2.motion=multibody_dynamics", "robots.red.3.motion=kinematic_walking"});
  const auto simulation = built.simulation();
  IntegrationStatistics statistics(*simulation);
  simulation->observe(&statistics);
  for (int i = 0; i < 200; ++i) simulation->step();
  const auto robots = statistics.robots();
  ASSERT_EQ(robots.size(), 1U);
  EXPECT_EQ(simulation->world().path(robots[0].object), "robots.red.1");
  EXPECT_EQ(robots[0].frames, 200);
  EXPECT_EQ(robots[0].faulty_frames, 0);
  EXPECT_GE(robots[0].substeps, 200);
  EXPECT_GE(robots[0].most_substeps, robots[0].substeps / 200);
  EXPECT_GT(robots[0].largest_error, 0);
  EXPECT_LT(robots[0].largest_error, 1e-2);
}

}  // namespace
}  // namespace murosimf::test
