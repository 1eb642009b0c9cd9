#include "game/scripted_match.h"

#include <cmath>

#include "murosimf/modules/all_modules.h"
#include "murosimf/scene/scenario_reader.h"
#include "murosimf/scene/world_builder.h"
#include "murosimf/soccer/field.h"

namespace murosimf::test {

namespace {

class ScriptedProgram final : public client::ControlSoftware {
 public:
  ScriptedProgram(std::map<std::string, ScriptedRobot*>& robots, Script script)
      : robots_(robots), script_(std::move(script)) {}
  void start(const client::RobotDescription& robot) override {
    robot_.description = robot;
    robots_[robot.team + std::to_string(robot.number)] = &robot_;
  }
  void step(const client::SensorFrame& sensors, client::CommandFrame&) override {
    robot_.told.push_back(sensors.game);
    if (script_) script_(robot_, sensors);
  }
  const client::ControlReport& report() const override { return robot_.report; }
  void archive(client::StateArchive&) override {}

 private:
  std::map<std::string, ScriptedRobot*>& robots_;
  Script script_;
  ScriptedRobot robot_;
};

MatchSettings settingsOf(const Scene& scene, const World& world) {
  MatchSettings match;
  match.field = fieldDescription(scene);
  match.ball = world.find("ball");
  match.red_attacks_positive_x = *scene.red.attacks_positive_x;
  for (const RobotSettings& robot : scene.robots) {
    MatchRobot& player = match.robots.emplace_back();
    player.object = world.find(robot.path());
    player.team = robot.team == "red" ? Team::kRed : Team::kBlue;
    player.number = robot.number;
    player.start = *robot.pose;
    if (robot.kickoff_own) player.kickoff_own = **robot.kickoff_own;
    if (robot.kickoff_other) player.kickoff_other = **robot.kickoff_other;
  }
  return match;
}

}  // namespace

ScriptedMatch::ScriptedMatch(const std::vector<std::string>& overrides, Script script) {
  Diagnostics diagnostics;
  scene = readScenario(MUROSIMF_SOURCE_DIR "/scenarios/game_3v3.toml", overrides, diagnostics).value();
  WorldBuilder builder(scene, diagnostics);
  builder.addFixed(addField(builder.world(), fieldDescription(scene), {}));
  simulation = builder.link(allModules(),
                            {{"player", [this, script] { return std::make_unique<ScriptedProgram>(robots, script); }}});
  settings = settingsOf(scene, simulation->world());
  referee = makeReferee(settings, *simulation);
  percepts = std::make_unique<PerceptStatistics>(settings, *simulation);
  simulation->observe(referee.get());
  simulation->control()->observe(percepts.get());
}

void ScriptedMatch::run(double seconds) {
  for (long i = std::lround(seconds / simulation->frameLength()); i > 0; --i) simulation->step();
  simulation->control()->finish();
}

PlanarPose ScriptedMatch::truePose(std::size_t robot) {
  const Pose X_WB = simulation->linked().handle(settings.robots[robot].object, kBasePose).get();
  return {X_WB.translation.x, X_WB.translation.y, atan2(X_WB.rotation.x.y, X_WB.rotation.x.x)};
}

}  // namespace murosimf::test
