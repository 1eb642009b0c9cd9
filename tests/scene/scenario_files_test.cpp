// The scenarios of the tree are right, and a scene written out reads back to itself.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "scene/scenario_for_test.h"

namespace murosimf::test {
namespace {

namespace fs = std::filesystem;

Scene readFile(const fs::path& file) {
  Diagnostics diagnostics;
  std::optional<Scene> scene = readScenario(file, {}, diagnostics);
  EXPECT_EQ(diagnostics.text(), "");
  EXPECT_TRUE(scene.has_value());
  return scene.value_or(Scene{});
}

void expectRoundTrip(const Scene& scene) {
  const std::string once = writeScenario(scene);
  EXPECT_EQ(writeScenario(readGood(once)), once);
}

TEST(ScenarioFiles, AllReadWithoutAWordAndRoundTrip) {
  int count = 0;
  for (const auto& entry : fs::directory_iterator(kRoot / "scenarios")) {
    if (entry.path().extension() != ".toml") continue;
    SCOPED_TRACE(entry.path().string());
    expectRoundTrip(readFile(entry.path()));
    ++count;
  }
  EXPECT_GE(count, 2);
}

TEST(ScenarioFiles, TheGameIsThreeAgainstThreeOnTheFieldOf2007) {
  const Scene scene = readFile(kRoot / "scenarios/game_3v3.toml");
  const client::FieldDescription field = fieldDescription(scene);
  EXPECT_EQ(field.length, 4.5);
  EXPECT_EQ(field.width, 3.0);
  EXPECT_EQ(field.ball_radius, .070);
  EXPECT_EQ(*scene.ball.mass, .205);
  ASSERT_EQ(scene.robots.size(), 6u);
  const std::string expected[] = {"robots.red.1",  "robots.red.2",  "robots.red.3",
                                  "robots.blue.1", "robots.blue.2", "robots.blue.3"};
  const PlanarPose poses[] = {{-2.10, 0, 0},
                              {-1.10, .55, 0},
                              {-.30, 0, 0},
                              {2.10, 0, std::numbers::pi},
                              {1.10, -.55, std::numbers::pi},
                              {.85, 0, std::numbers::pi}};
  for (std::size_t i = 0; i < 6; ++i) {
    const RobotSettings& robot = scene.robots[i];
    EXPECT_EQ(robot.path(), expected[i]);
    EXPECT_EQ(*robot.pose, poses[i]) << robot.path();
    EXPECT_EQ(*robot.level, "kinematic");
    EXPECT_EQ(*robot.control.module, "player");
    EXPECT_EQ(robot.file_found, kRoot / "robots/ks21.urdf");
    EXPECT_TRUE(robot.cameras.empty()) << "they are as the level says";
  }
  EXPECT_TRUE(*scene.red.attacks_positive_x);
  EXPECT_FALSE(*scene.blue.attacks_positive_x);
}

TEST(ScenarioFiles, NobodyStandsWhereAKickOffForbids) {
  const Scene scene = readFile(kRoot / "scenarios/game_3v3.toml");
  for (const RobotSettings& robot : scene.robots) {
    const double own_side = robot.team == "red" ? -1 : 1;
    for (const bool own_kickoff : {true, false}) {
      const auto& given = own_kickoff ? robot.kickoff_own : robot.kickoff_other;
      const PlanarPose pose = given ? **given : *robot.pose;
      EXPECT_GT(pose.x * own_side, 0) << robot.path() << " stands in the other half";
      if (own_kickoff) continue;
      EXPECT_GT(std::sqrt(pose.x * pose.x + pose.y * pose.y), *scene.field.centre_circle_radius) << robot.path();
    }
  }
}

TEST(ScenarioFiles, EveryKindOfValueRoundTrips) {
  const std::string text = kTwoRobots + R"(
role = "a \"quoted\" \\ word\twith a tab"
motion = {module = "kinematic_walking", period = 0.02, gains = [0.1, 1e-7, 3], bent = {deg = 12.5}, on = true}
kickoff_own = {x = 0.1, y = -0.2}
[robots.blue.1.modules]
wind = {strength = 0.1}
push = "impulse"
[robots.blue.1.properties]
trunk.mass = 1.25
"left foot".surface = "sole"
names = ["a", "b"]
[robots.blue.1.cameras]
head = "none"
chest = {phase = 0.005, noise = 2}
[surfaces.turf-carpet]
stiffness = 1e3
restitution_factor = 0.1
friction_coefficient = 0.7
)";
  const Scene scene = readGood(text);
  const RobotSettings& robot = scene.robots.at(1);
  ASSERT_EQ(robot.modules.size(), 3u);
  EXPECT_EQ(robot.modules[0].slot, "motion");
  EXPECT_EQ(robot.modules[1].slot, "modules.push");
  EXPECT_EQ(*robot.modules[1].module, "impulse");
  EXPECT_EQ(*robot.modules[2].module, "wind") << "a further module is named by its slot unless it says otherwise";
  ASSERT_EQ(robot.properties.size(), 3u);
  EXPECT_EQ(robot.properties[0].name, "left foot.surface");
  EXPECT_EQ(robot.properties[2].name, "trunk.mass");
  EXPECT_EQ(std::get<double>(*robot.properties[2].value), 1.25);
  EXPECT_EQ(robot.properties[2].value.where.line, 16);
  EXPECT_TRUE(findSurfacePair(scene, "turf", "carpet") == findSurfacePair(scene, "carpet", "turf"));
  expectRoundTrip(scene);
}

TEST(ScenarioFiles, ValuesKnowTheirPlaces) {
  const Scene scene = readGood("[ball]\n  mass = 0.3\n" + kTwoRobots);
  EXPECT_EQ(scene.ball.mass.where.file, kPlace.string());
  EXPECT_EQ(scene.ball.mass.where.line, 2);
  EXPECT_EQ(scene.ball.mass.where.column, 10);
  EXPECT_FALSE(scene.ball.radius.given());
  EXPECT_EQ(scene.robots[1].where.line, 7);
  EXPECT_EQ(scene.robots[1].pose.where.line, 9);
}

TEST(ScenarioFiles, TheTeamThatSaysNothingAttacksTheOtherGoal) {
  const Scene scene = readGood("[teams.red]\nattacks = \"-x\"\n");
  EXPECT_FALSE(*scene.red.attacks_positive_x);
  EXPECT_TRUE(*scene.blue.attacks_positive_x);
}

TEST(ScenarioFiles, CoulombFrictionTakesThePlaceOfTheBuiltInViscousFriction) {
  const Scene scene = readGood("[surfaces.turf-ball]\nfriction_coefficient = 0.5\n");
  const SurfacePairSettings* pair = findSurfacePair(scene, "ball", "turf");
  ASSERT_NE(pair, nullptr);
  EXPECT_EQ(*pair->friction_coefficient, .5);
  EXPECT_EQ(*pair->friction, "coulomb");
  EXPECT_EQ(*pair->stiffness, 3e3) << "what is not given stays as built in";
  EXPECT_EQ(findSurfacePair(scene, "ball", "moon"), nullptr);
  const auto said = complaints("[surfaces.ball-turf]\nviscous_friction = 5\nfriction_coefficient = 0.5\n");
  ASSERT_EQ(said.size(), 1u);
  EXPECT_EQ(said[0],
            "3:24: friction_coefficient and viscous_friction are both given, expected one of them, or friction to say "
            "which one holds");
  const Scene both =
      readGood("[surfaces.ball-turf]\nviscous_friction = 5\nfriction_coefficient = 0.5\nfriction = \"viscous\"\n");
  EXPECT_EQ(*findSurfacePair(both, "ball", "turf")->friction, "viscous");
}

}  // namespace
}  // namespace murosimf::test
