// A four-legged robot trots by its control software, as the scenario says.

#include <gtest/gtest.h>

#include <cmath>

#include "murosimf/modules/all_modules.h"
#include "murosimf/scene/scenario_reader.h"
#include "murosimf/scene/world_builder.h"
#include "trotter/trotter.h"

namespace murosimf::test {
namespace {

struct Trot {
  explicit Trot(std::vector<std::string> overrides) {
    Diagnostics diagnostics;
    overrides.emplace_back("robots.red.1.role=0.4 0 0, 0 0 0@9");
    scene = readScenario(MUROSIMF_SOURCE_DIR "/scenarios/trot.toml", overrides, diagnostics).value();
    WorldBuilder builder(scene, diagnostics);
    simulation = builder.link(allModules(), {{"trotter", controllers::trotter::makeTrotter}});
    EXPECT_EQ(diagnostics.text(), "");
    robot = simulation->world().find("robots.red.1");
  }
  ~Trot() { simulation->control()->finish(); }
  Trot(const Trot&) = delete;
  Trot& operator=(const Trot&) = delete;
  Pose base() const { return simulation->linked().handle(robot, kBasePose).get(); }
  template <class Watch>
  void run(double seconds, Watch&& watch) {
    for (long i = std::lround(seconds / simulation->frameLength()); i > 0; --i) simulation->step(), watch();
  }

  Scene scene;
  std::unique_ptr<Simulation> simulation;
  ObjectId robot;
};

class TrotScenario : public testing::TestWithParam<const char*> {};

TEST_P(TrotScenario, ThreeMetresStraightAndThenItStands) {
  Trot trot({std::string(GetParam())});
  trot.run(0.001, [] {});  // robots are placed with the first frame
  const Pose begin = trot.base();
  double lowest = 1, upright = 1;
  trot.run(12, [&] {
    const Pose X_WB = trot.base();
    lowest = std::min(lowest, X_WB.translation.z), upright = std::min(upright, X_WB.rotation.z.z);
  });
  const Vector3 gone = trot.base().translation - begin.translation;
  EXPECT_GT(gone.x, 3);
  EXPECT_LT(std::fabs(gone.y), 0.15);
  EXPECT_GT(lowest, 0.30);
  EXPECT_GT(upright, std::cos(5 * kPi / 180));
  EXPECT_LT(norm(trot.simulation->linked().handle(trot.robot, kBaseVelocity).get().v), 1e-3);
}

INSTANTIATE_TEST_SUITE_P(
    Levels, TrotScenario,
    testing::Values("robots.red.1.level=full", "robots.red.1.level=fast",
                    "robots.red.1.motion=multibody_dynamics, simplified_dynamics@4, multibody_dynamics@6.3"),
    [](const auto& test) {
      return std::string(test.index == 0 ? "full" : test.index == 1 ? "fast" : "exchanged");
    });

}  // namespace
}  // namespace murosimf::test
