// Rays of range sensors are drawn from where they were cast to what they met.

#include "game/scans_renderer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "game/game.h"
#include "murosimf/scene/scenario_reader.h"

namespace murosimf {
namespace {

constexpr int kRays = 181;           // of duo's laser scanner
constexpr double kPeriod = 0.05;     // of its scans [s]
constexpr double kPoleRadius = 0.1;  // of the field of 2007 [m]

/// The first robot of scenarios/square.toml, which drives towards a pole, without noise in its sensors.
struct DrawnScans {
  explicit DrawnScans(std::vector<std::string> overrides = {}) {
    for (const char* constant : {"laser.range_noise", "laser.range_noise_share"})
      overrides.push_back(std::string("robots.red.1.properties.\"") + constant + "\"=0");
    const std::optional<Scene> scene = readScenario("scenarios/square.toml", overrides, diagnostics);
    EXPECT_EQ(diagnostics.text(), "");
    simulation = buildGame(*scene, diagnostics);
    EXPECT_EQ(diagnostics.text(), "");
    places = std::make_unique<ScanPlaces>(*simulation);
    simulation->observe(places.get());
    RendererRegistry all;
    all.add(ScansRenderer::entry(*simulation, *places));
    const World& world = simulation->world();
    robot = world.find("robots.red.1");
    const auto sensors = world.members(robot, subset::kRangeSensors);
    renderings = std::make_unique<Renderings>(all, world, simulation->linked(),
                                              std::vector<ObjectId>(sensors.begin(), sensors.end()));
  }
  ~DrawnScans() { simulation->control()->finish(); }
  void run(double seconds) {
    while (simulation->time() < seconds - 1e-9) simulation->step();
  }
  /// Of the laser alone, or of all.
  const DrawList& draw(bool all = false) {
    renderings->show("scans", all);
    renderings->show("scans", true, simulation->world().members(robot, subset::kRangeSensors)[0]);
    renderings->draw({simulation->frame() - 1, simulation->time()}, list);
    return list;
  }
  std::vector<Vector3> dots() {
    std::vector<Vector3> at;
    const auto& solid = draw().solid();
    if (solid.size() <= MeshLibrary::kSphere) return at;
    for (const MeshInstance& dot : solid[MeshLibrary::kSphere])
      at.push_back({dot.X_WM[0][3], dot.X_WM[1][3], dot.X_WM[2][3]});
    return at;
  }

  Diagnostics diagnostics;
  std::unique_ptr<Simulation> simulation;
  std::unique_ptr<ScanPlaces> places;
  ObjectId robot;
  std::unique_ptr<Renderings> renderings;
  MeshLibrary meshes;
  DrawList list{meshes};
};

/// Of the rays' ends near this pole. @return how many
int checkDotsOnPole(DrawnScans& scans, const Vector3& p_WP) {
  int on = 0;
  for (const Vector3& dot : scans.dots()) {
    const double distance = std::hypot(dot.x - p_WP.x, dot.y - p_WP.y);
    if (distance > 2 * kPoleRadius) continue;
    EXPECT_NEAR(distance, kPoleRadius, 1e-5);
    ++on;
  }
  return on;
}

TEST(ScansRenderer, endsRaysOnThePoleThatTheyMetThoughTheRobotHasDrivenOn) {
  DrawnScans scans;
  const World& world = scans.simulation->world();
  std::optional<Pose> X_WP;
  for (const ObjectId object : scans.simulation->participants().fixed) {
    const auto pose = world.find(object, kFixedPose);
    if (pose && std::fabs(pose->translation.x) < 1e-9 && pose->translation.y > 0) X_WP = pose;
  }
  ASSERT_TRUE(X_WP) << "no pole beside the middle of the field";
  for (const double later : {0.001, 0.02, 0.049}) {
    scans.run(20 * kPeriod + later);
    EXPECT_GE(checkDotsOnPole(scans, X_WP->translation), 3) << later;
  }
}

TEST(ScansRenderer, drawsALineForEachRay) {
  DrawnScans scans;
  scans.run(1);
  EXPECT_EQ(scans.draw().lines().size(), 2U * kRays);
  EXPECT_EQ(scans.draw(true).lines().size(), 2U * (kRays + 1 + 1 + 37));
  EXPECT_TRUE(scans.list.texts().empty());
}

TEST(ScansRenderer, saysThatRobotsWithoutControlSoftwareDoNotScan) {
  DrawnScans scans({"robots.red.1.control=none"});
  scans.run(1);
  EXPECT_EQ(scans.draw(true).lines().size(), 2U * 2 * 4) << "the edges of four sensors";
  ASSERT_EQ(scans.list.texts().size(), 1U);
  EXPECT_EQ(scans.list.texts()[0].text, "no control software: no scans");
}

TEST(ScansRenderer, drawsNothingAtTimesOfARecording) {
  DrawnScans scans;
  scans.run(1);
  scans.draw(true);
  scans.renderings->draw({scans.simulation->frame() - 1, 0.5}, scans.list);
  EXPECT_TRUE(scans.list.lines().empty());
}

}  // namespace
}  // namespace murosimf
