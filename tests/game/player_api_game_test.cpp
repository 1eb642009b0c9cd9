// Games through the player API, with control software in processes of its own.

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <thread>

#include "game/game.h"
#include "game/program.h"
#include "scene/documented_table.h"

namespace murosimf::test {
namespace {

/// The first of a few ports that tests which run at the same time do not share.
int firstPort() { return 20000 + static_cast<int>(getpid() % 20000); }

const char* const kGame =
    "run scenarios/game_4v4.toml --set simulation.control_period=0.008 --set simulation.control_delay=0.008 "
    "--set output.pictures=false --set robots.all.cameras.head.period=0.048 --set "
    "robots.all.cameras.chest.period=0.096 ";

nlohmann::json reportOf(const std::string& arguments, const std::string& folder) {
  const Outcome outcome = runProgram(kGame + arguments + " --out " + folder);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.text;
  std::ifstream file(folder + "/report.json");
  return nlohmann::json::parse(file, nullptr, false);
}

/// Control software of a robot, in a process of its own; gives what it said.
std::thread player(int port, Outcome& outcome) {
  return std::thread([port, &outcome] {
    const std::string program = std::string(MUROSIMF_PROGRAM) + "-control";
    outcome = runCommand(program + " player " + std::to_string(port) + " --patience 60");
  });
}

struct RemoteGame {
  nlohmann::json report;
  std::vector<Outcome> players;
};

/// All eight robots' players are processes.
RemoteGame playRemotely(const std::string& arguments, const std::string& folder) {
  RemoteGame game;
  game.players.resize(8);
  std::vector<std::thread> threads;
  std::string ports;
  for (int i = 0; i < 8; ++i) {
    const int port = firstPort() + i;
    ports += " --set robots." + std::string(i < 4 ? "red." : "blue.") + std::to_string(i % 4 + 1) +
             ".control.port=" + std::to_string(port);
    threads.push_back(player(port, game.players[static_cast<std::size_t>(i)]));
  }
  game.report =
      reportOf("--set 'robots.all.control={program=\"player_api\", patience=60.0}'" + ports + " " + arguments, folder);
  for (std::thread& thread : threads) thread.join();
  return game;
}

class RemoteFourAgainstFour : public ::testing::TestWithParam<const char*> {};

TEST_P(RemoteFourAgainstFour, PlaysTheGameOfLinkedSoftwareToTheLastBit) {
  const std::string more = std::string(GetParam()) + " --set simulation.duration=2";
  const RemoteGame remote = playRemotely(more, freshFolder("remote"));
  const nlohmann::json linked = reportOf(more, freshFolder("linked"));
  ASSERT_TRUE(remote.report.contains("state_hash"));
  EXPECT_EQ(remote.report["state_hash"], linked["state_hash"]);
  EXPECT_EQ(remote.report["state_hashes"], linked["state_hashes"]);
  for (const Outcome& player : remote.players) {
    EXPECT_EQ(player.exit_code, 0) << player.text;
    EXPECT_NE(player.text.find("250 steps"), std::string::npos) << player.text;
  }
  for (const nlohmann::json& program : remote.report["control"]["programs"]) {
    EXPECT_EQ(program["missed_answers"], 0);
    EXPECT_EQ(program["warnings"], 0);
    EXPECT_EQ(program["messages_dropped"], 0);
  }
}

INSTANTIATE_TEST_SUITE_P(KinematicAndFull, RemoteFourAgainstFour,
                         ::testing::Values("--set robots.all.level=kinematic", "--set robots.all.level=full"));

TEST(RemoteGame, GoesOnPacedWhetherItsPlayerComesOrNot) {
  const std::string one = "--set 'robots.red.4.control={program=\"player_api\", port=" + std::to_string(firstPort()) +
                          "}' --set simulation.pace=1 --set simulation.duration=2 --set robots.all.level=oracle ";
  Outcome outcome;
  std::thread thread = player(firstPort(), outcome);
  const nlohmann::json report = reportOf(one, freshFolder("paced"));
  thread.join();
  EXPECT_EQ(outcome.exit_code, 0) << outcome.text;
  EXPECT_GT(report["control"]["programs"][0]["messages_received"].get<double>(), 100);
  const nlohmann::json alone = reportOf(one, freshFolder("paced_alone"));
  EXPECT_EQ(alone["control"]["programs"][0]["connections"], 0);
  EXPECT_NEAR(alone["simulated_seconds"].get<double>(), 2, 1e-9);
}

TEST(RemoteGame, TwoRobotsOnOnePortCannotStart) {
  const std::string port = std::to_string(firstPort());
  const Outcome outcome = runProgram(kGame + ("--set 'robots.all.control={program=\"player_api\", port=" + port) +
                                     "}' --out " + freshFolder("one_port"));
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.text.find("error: red 2: cannot listen on 127.0.0.1:" + port + ": Address already in use"),
            std::string::npos)
      << outcome.text;
}

class HostileClients : public ::testing::TestWithParam<const char*> {};

/// Two ports are attacked; nothing that makes sense is asked of the motors, so all robots must move as if alone.
TEST_P(HostileClients, ChangeNoBitOfAnyRobot) {
  const auto game = [](const std::string& name) {
    const std::string port = "program=\"player_api\", lock_step=\"no\", port=";
    return reportOf("--set robots.all.level=oracle --set simulation.duration=20 --set 'robots.red.1.control={" + port +
                        std::to_string(firstPort()) + "}' --set 'robots.blue.2.control={" + port +
                        std::to_string(firstPort() + 1) + "}'",
                    freshFolder(name));
  };
  static const nlohmann::json alone = game("not_attacked");
  std::vector<std::thread> attackers;
  for (int i = 0; i < 2; ++i)
    attackers.emplace_back([i] {
      runCommand("python3 tests/player_api/hostile_client.py " + std::string(GetParam()) + " " +
                 std::to_string(firstPort() + i) + " 2");
    });
  const nlohmann::json attacked = game("attacked");
  for (std::thread& attacker : attackers) attacker.join();
  ASSERT_TRUE(alone.contains("state_hash"));
  EXPECT_EQ(attacked["state_hash"], alone["state_hash"]);
  EXPECT_GT(attacked["control"]["programs"][0]["connections"].get<double>(), 0) << "nobody attacked";
}

INSTANTIATE_TEST_SUITE_P(Kinds, HostileClients,
                         ::testing::Values("silent", "never_reads", "one_byte_a_second", "four_gibibytes",
                                           "random_bytes", "half_frames", "nan", "flood", "reconnects", "stopped"),
                         [](const auto& kind) { return std::string(kind.param); });

TEST(PlayerApi, ParametersStandInItsDocument) {
  ControlPrograms one;
  one.emplace("player_api", allPrograms().at("player_api"));
  std::string table = programsAsMarkdown(one);
  table.erase(0, table.find("| parameter"));
  expectDocumented("parameters", table, "player_api.md");
}

}  // namespace
}  // namespace murosimf::test
