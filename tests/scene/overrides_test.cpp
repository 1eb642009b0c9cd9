// `--set PATH=VALUE`, and the order in which the layers of a robot hold: all < team < robot < --set.
#include <gtest/gtest.h>

#include "scene/scenario_for_test.h"

namespace murosimf::test {
namespace {

const RobotSettings& red(const Scene& scene) { return scene.robots.at(0); }
const RobotSettings& blue(const Scene& scene) { return scene.robots.at(1); }

const NamedValue* findValue(const std::vector<NamedValue>& values, const std::string& name) {
  for (const NamedValue& v : values)
    if (v.name == name) return &v;
  return nullptr;
}

const ModuleChoice& motionOf(const RobotSettings& robot) {
  static const ModuleChoice kNone;
  for (const ModuleChoice& m : robot.modules)
    if (m.slot == "motion") return m;
  ADD_FAILURE() << "no motion module in " << robot.path();
  return kNone;
}

TEST(Overrides, ChangeValuesOfEverySort) {
  const Scene scene = readGood(
      kTwoRobots, {"simulation.duration=10", "field.brightness = 0.8", "field.preset=2025_kid", "referee.enabled=false",
                   "output.video=out/a b.mp4", "robots.red.1.pose.heading={deg = 90}", "ball.position=[0.5, -1]"});
  EXPECT_EQ(*scene.simulation.duration, 10);
  EXPECT_EQ(*scene.field.brightness, .8);
  EXPECT_EQ(*scene.field.length, 9);
  EXPECT_FALSE(*scene.referee.enabled);
  EXPECT_EQ(*scene.output.video, "out/a b.mp4");
  EXPECT_EQ(red(scene).pose->x, -1) << "the array of the file keeps its other parts";
  EXPECT_NEAR(red(scene).pose->heading, 1.5707963267948966, 1e-15);
  EXPECT_EQ(scene.ball.position->y, -1);
  EXPECT_EQ(scene.field.brightness.where.file, "--set field.brightness = 0.8");
  EXPECT_EQ(scene.field.brightness.where.line, 0);
}

TEST(Overrides, ANumberServesAsTextWhereTextIsExpected) {
  const Scene scene = readGood("[field]\npreset = \"2025_kid\"\n" + kTwoRobots, {"field.preset=2007"});
  EXPECT_EQ(*scene.field.preset, "2007");
  EXPECT_EQ(*scene.field.length, 4.5);
}

TEST(Overrides, TheLaterHoldsOverTheEarlier) {
  const Scene scene = readGood(kTwoRobots, {"ball.mass=0.3", "ball.mass=0.4"});
  EXPECT_EQ(*scene.ball.mass, .4);
}

TEST(Overrides, AModuleKeepsItsNameWhenAParameterFollows) {
  const Scene scene = readGood(kTwoRobots, {"robots.red.1.motion=walk", "robots.red.1.motion.period=0.02"});
  EXPECT_EQ(*motionOf(red(scene)).module, "walk");
  EXPECT_EQ(*motionOf(red(scene)).period, .02);
}

TEST(Overrides, PropertiesByDotsOrQuotesAreTheSame) {
  const std::string text = kTwoRobots + "[robots.red.1.properties]\n\"trunk.mass\" = 1\nhead.mass = 1\n";
  const Scene scene =
      readGood(text, {"robots.red.1.properties.trunk.mass=2", "robots.red.1.properties.\"head.mass\"=3"});
  ASSERT_EQ(red(scene).properties.size(), 2u);
  EXPECT_EQ(std::get<double>(*findValue(red(scene).properties, "trunk.mass")->value), 2);
  EXPECT_EQ(std::get<double>(*findValue(red(scene).properties, "head.mass")->value), 3);
}

TEST(Overrides, SurfacesInEitherOrderAreTheSamePair) {
  const Scene scene = readGood("[surfaces.ball-turf]\nstiffness = 2000\nrolling_resistance = 0.1\n",
                               {"surfaces.turf-ball.stiffness=2500"});
  EXPECT_EQ(*findSurfacePair(scene, "ball", "turf")->stiffness, 2500);
  EXPECT_EQ(*findSurfacePair(scene, "ball", "turf")->rolling_resistance, .1);
}

TEST(Overrides, WrongOnesNameTheirOwnPlace) {
  const std::pair<const char*, const char*> cases[] = {
      {"simulation.duration=-1", "duration is -1 s, expected a number, more than 0"},
      {"simulation.durtion=1", "unknown key \"durtion\" in simulation, expected \"frame\", \"duration\""},
      {"robots.red=2", "red is 2, expected a table"},
      {"robots.all=2", "all is 2, expected a table"},
      {"robots.red.7.motion=walk", "the scenario has no robots.red.7"},
      {"robots.gren.1.motion=walk", "there is no team \"gren\""},
      {"field.brightness", "expected PATH=VALUE"},
      {"=3", "expected PATH=VALUE"},
      {"field..brightness=3", "expected PATH=VALUE"},
      {"field.brightness=", "the value is missing"},
      {"field.brightness={a=", "the value is \"{a=\", expected a TOML value or a bare word"},
      {"field.brightness=bright", "brightness is text \"bright\", expected a number"},
      {"field=3", "field is 3, expected a table"},
      {"ball.mass.unit=kg", "mass is a table, expected a number"},
      {"robots.red.1.pose=[1, 2]", "pose is an array of 2 values"},
      {"robots.red.1.control.gain=2", "control names no program"},
      {"robots.red.1.control={program=\"player\", phase=0.1}", "unknown key \"phase\" in control"},
      {"robots.red.1.control={program=\"player\", period=0.0105}", "period is 0.0105 s, expected a multiple of"},
      {"robots.red.1.control={program=\"player\", delay=0.0005}", "delay is 0.0005 s, expected a multiple of"},
      {"robots.red.1.control={program=\"player\", period=0.0}", "period is 0 s, expected a number, more than 0"},
      {"surfaces.ballturf.stiffness=3", "\"ballturf\" names no pair of surfaces"},
      {"surfaces.b-c={stiffness=1, law=2}",
       "surfaces.b-c is no built-in pair, expected stiffness and restitution_factor"},
  };
  for (const auto& [assignment, words] : cases) {
    const auto said = complaints(kTwoRobots, {assignment});
    ASSERT_EQ(said.size(), 1u) << assignment;
    EXPECT_TRUE(startsWith(said[0], std::string("--set ") + assignment + ": " + words)) << said[0];
  }
}

TEST(Layers, TheHigherHolds) {
  const std::string text = R"(
[robots.all]
role = "all"
motion = {module = "walk", period = 0.01, speed = 1, turn = 1, lean = 1}
[robots.all.properties]
"trunk.mass" = 1
"head.mass" = 1
[teams.red]
role = "team"
motion = {speed = 2, turn = 2}
[teams.red.properties]
"trunk.mass" = 2
)" + kTwoRobots + R"(
role = "own"
)";
  const Scene scene = readGood(text, {"robots.all.motion.lean=4"});
  EXPECT_EQ(*red(scene).role, "team");
  EXPECT_EQ(*blue(scene).role, "own");
  const auto parameter = [](const RobotSettings& r, const char* name) {
    return std::get<double>(*findValue(motionOf(r).parameters, name)->value);
  };
  EXPECT_EQ(*motionOf(red(scene)).module, "walk");
  EXPECT_EQ(parameter(red(scene), "speed"), 2);
  EXPECT_EQ(parameter(blue(scene), "speed"), 1);
  EXPECT_EQ(parameter(blue(scene), "lean"), 4);
  EXPECT_EQ(std::get<double>(*findValue(red(scene).properties, "trunk.mass")->value), 2);
  EXPECT_EQ(std::get<double>(*findValue(red(scene).properties, "head.mass")->value), 1);
  EXPECT_EQ(findValue(motionOf(red(scene)).parameters, "speed")->value.where.line, 10);
}

TEST(Layers, SetForAllHoldsOverARobotsOwnTable) {
  const std::string text = kTwoRobots + "control = \"player\"\n";
  EXPECT_EQ(*blue(readGood(text)).control.module, "player");
  EXPECT_EQ(*red(readGood(text)).control.module, "none");
  EXPECT_EQ(*blue(readGood(text, {"robots.all.control=none"})).control.module, "none");
  const Scene scene = readGood(text, {"robots.blue.1.control=player", "teams.blue.control=none"});
  EXPECT_EQ(*blue(scene).control.module, "player") << "within --set too, the robot holds over the team";
}

TEST(Layers, AnotherModuleTakesTheParametersOfTheFormerAway) {
  const std::string text = "[robots.all]\nmotion = {module = \"walk\", speed = 1}\ncameras.head = {noise = 3}\n" +
                           kTwoRobots + "motion = \"roll\"\ncameras.head = \"none\"\n";
  const Scene scene = readGood(text);
  EXPECT_EQ(*motionOf(blue(scene)).module, "roll");
  EXPECT_TRUE(motionOf(blue(scene)).parameters.empty());
  EXPECT_TRUE(blue(scene).cameras.at(0).parameters.empty());
  EXPECT_EQ(red(scene).cameras.at(0).parameters.size(), 1u);
  const Scene same = readGood(text, {"robots.all.motion=walk"});
  EXPECT_EQ(motionOf(red(same)).parameters.size(), 1u) << "naming the same module again keeps them";
}

}  // namespace
}  // namespace murosimf::test
