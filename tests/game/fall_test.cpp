// A robot with full dynamics among kinematic ones is pushed over and gets up by its control software.

#include <gtest/gtest.h>

#include <cmath>

#include "murosimf/modules/all_modules.h"
#include "murosimf/scene/scenario_reader.h"
#include "murosimf/scene/world_builder.h"
#include "player/player.h"

namespace murosimf::test {
namespace {

std::unique_ptr<Simulation> gameWithoutCameras() {
  Diagnostics diagnostics;
  const std::vector<std::string> overrides{"robots.red.3.level=full", "robots.all.cameras.head.module=none",
                                           "robots.all.cameras.chest.module=none"};
  const Scene scene = readScenario(MUROSIMF_SOURCE_DIR "/scenarios/game_3v3.toml", overrides, diagnostics).value();
  WorldBuilder builder(scene, diagnostics);
  return builder.link(allModules(), {{"player", controllers::makePlayer}});
}

/// Changes the momentum of the whole robot as if it were rigid and hit in its centre of mass [N s].
void push(Simulation& simulation, ObjectId robot, const Vector3& impulse_W) {
  constexpr double kRobotMass = 3.3;
  const Pose X_WB = simulation.linked().handle(robot, kBasePose).get();
  Handle<SpatialMotion<double>> velocity = simulation.linked().handle(robot, kBaseVelocity);
  SpatialMotion<double> V = velocity.get();
  V.v = V.v + applyTransposed(X_WB.rotation, impulse_W * (1 / kRobotMass));
  velocity.set(V);
}

TEST(Fall, ARobotThatIsPushedOverGetsUp) {
  for (const double direction : {0.0, 1.5, kPi}) {  // onto the front, a flank, the back
    const std::unique_ptr<Simulation> simulation = gameWithoutCameras();
    const ObjectId robot = simulation->world().find("robots.red.3");
    const auto base = [&] { return simulation->linked().handle(robot, kBasePose).get(); };
    const auto run = [&](double seconds) {
      for (long i = std::lround(seconds / simulation->frameLength()); i > 0; --i) simulation->step();
    };
    run(2);
    EXPECT_GT(base().rotation.z.z, 0.98) << direction;
    push(*simulation, robot, Vector3{cos(direction), sin(direction), 0} * 5);
    run(1.2);
    EXPECT_LT(base().rotation.z.z, 0.5) << direction << ": it was to fall";
    run(11);
    EXPECT_GT(base().rotation.z.z, 0.98) << direction;
    EXPECT_NEAR(base().translation.z, 0.244, 0.002) << direction;
    simulation->control()->finish();
  }
}

}  // namespace
}  // namespace murosimf::test
