// Games whose robots' agents connect as to a server of the 3D Simulation League.

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <numeric>
#include <thread>

#include "game/game.h"
#include "game/game_observers.h"
#include "game/program.h"
#include "murosimf/scene/scenario_reader.h"
#include "scene/documented_table.h"

namespace murosimf::test {
namespace {

/// Of ports that tests which run at the same time do not share.
int freePort() { return 40000 + static_cast<int>(getpid() % 20000); }

struct AgentGame {
  nlohmann::json report;
  std::vector<Outcome> agents;  // red 1, 2, 3, blue 1, 2, 3
  nlohmann::json told(std::size_t agent) const { return nlohmann::json::parse(agents[agent].text, nullptr, false); }
};

/// 3 against 3, each robot with an agent of its own.
AgentGame playWithAgents(const std::string& folder) {
  const std::string port = std::to_string(freePort());
  const auto control = [&](const std::string& colour, const std::string& team) {
    return " --set 'teams." + colour + ".control={program=\"agent_server\", port=" + port +
           ", period=0.02, delay=0.02, team=\"" + team + "\"}'";
  };
  AgentGame game;
  game.agents.resize(6);
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < 6; ++i) {
    threads.emplace_back([&, i] {
      game.agents[i] = runCommand("python3 tests/agent_server/plain_agent.py " + port + " KS21 " +
                                  (i < 3 ? "Swifts " : "Robins ") + std::to_string(i % 3 + 1));
    });
  }
  const Outcome outcome = runProgram("run scenarios/game_3v3.toml --set simulation.duration=2" +
                                     control("red", "Swifts") + control("blue", "Robins") +
                                     " --set robots.all.level=oracle --set output.pictures=false --out " + folder);
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(outcome.exit_code, 0) << outcome.text;
  std::ifstream file(folder + "/report.json");
  game.report = nlohmann::json::parse(file, nullptr, false);
  return game;
}

TEST(AgentServer, SixAgentsPlayInLockStepWithTheSameBitsEachTime) {
  const AgentGame game = playWithAgents(freshFolder("agents"));
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(game.agents[i].exit_code, 0) << game.agents[i].text;
    const nlohmann::json told = game.told(i);
    ASSERT_TRUE(told.is_object()) << game.agents[i].text;
    EXPECT_EQ(told["cycles"], 100);
    EXPECT_EQ(told["joints"].size(), 21);
    EXPECT_EQ(told["modes"], nlohmann::json({"BeforeKickOff", "PlayOn"}));
    EXPECT_GT(told["sees"], 10);
  }
  for (const nlohmann::json& program : game.report["control"]["programs"]) {
    EXPECT_EQ(program["missed_answers"], 0);
    EXPECT_EQ(program["not_understood"], 0);
  }
  const AgentGame again = playWithAgents(freshFolder("agents_again"));
  ASSERT_TRUE(game.report.contains("state_hash"));
  EXPECT_EQ(game.report["state_hash"], again.report["state_hash"]);
}

TEST(AgentServer, BeamsBeforeTheKickOffPutRobotsIntoTheirOwnHalves) {
  const AgentGame game = playWithAgents(freshFolder("beams"));
  const nlohmann::json red = game.told(0), blue = game.told(3);
  ASSERT_TRUE(red.is_object() && blue.is_object()) << game.agents[0].text << game.agents[3].text;
  EXPECT_NEAR(red["pos"][0].get<double>(), -1.5, 0.05);
  EXPECT_NEAR(red["pos"][1].get<double>(), -0.5, 0.05);
  EXPECT_NEAR(blue["pos"][0].get<double>(), 1.5, 0.05);
  EXPECT_NEAR(blue["pos"][1].get<double>(), -0.5, 0.05) << "y is the field's";
  EXPECT_NEAR(std::abs(blue["quat"][3].get<double>()), 1, 0.05) << "turned by half a turn";
}

/// Beams once, and counts how often somebody says that it was put somewhere.
class Beamer final : public client::ControlSoftware {
 public:
  Beamer(int& beams, int& times_placed) : beams_(beams), times_placed_(times_placed) {}
  void start(const client::RobotDescription& robot) override { beams_here_ = robot.team == "red" && robot.number == 1; }
  void step(const client::SensorFrame& sensors, client::CommandFrame& commands) override {
    const bool asks = beams_here_ && sensors.time > 0.095 && sensors.time < 0.105;
    commands.beams = asks, commands.beam = {-1, 0.5, 0.25};
    beams_ += asks ? 1 : 0;
    if (sensors.time < 0.1 || !sensors.game.placed) return;
    ++times_placed_;
    if (beams_here_) {
      EXPECT_EQ(sensors.game.placed_at, commands.beam);
    }
  }
  const client::ControlReport& report() const override { return report_; }
  void archive(client::StateArchive&) override {}

 private:
  int &beams_, &times_placed_;
  bool beams_here_ = false;
  client::ControlReport report_;
};

TEST(Beams, TellTheirRobotAloneThatItHasBeenPlaced) {
  Diagnostics diagnostics;
  const auto scene =
      readScenario("scenarios/game_3v3.toml", {"robots.all.level=oracle", "robots.all.control=beamer"}, diagnostics);
  std::vector<int> beams(6), placed(6);
  std::size_t next = 0;
  ControlPrograms programs;
  programs.emplace("beamer", [&] {
    const std::size_t i = next++;
    return std::make_unique<Beamer>(beams.at(i), placed.at(i));
  });
  const auto simulation = buildGame(*scene, diagnostics, {}, allModules(), programs);
  ASSERT_EQ(diagnostics.text(), "");
  const GameObservers observers(*scene, *simulation);
  for (int i = 0; i < 500; ++i) simulation->step();
  simulation->control()->finish();
  EXPECT_EQ(beams, placed) << "the one that beamed, and nobody else";
  EXPECT_EQ(std::accumulate(beams.begin(), beams.end(), 0), 1);
}

TEST(AgentServer, ParametersStandInItsDocument) {
  ControlPrograms one;
  one.emplace("agent_server", allPrograms().at("agent_server"));
  std::string table = programsAsMarkdown(one);
  table.erase(0, table.find("| parameter"));
  expectDocumented("parameters", table, "agent_server.md");
}

}  // namespace
}  // namespace murosimf::test
