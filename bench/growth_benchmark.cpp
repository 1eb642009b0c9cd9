// How the cost of a robot's frame grows: with the number of robots, which should not matter, and with that of its
// joints, where it should be in proportion.

#include <fmt/format.h>

#include <array>
#include <deque>

#include "limb_robot.h"
#include "paired_ratio.h"
#include "robot_team.h"

namespace murosimf::bench {
namespace {

constexpr int kRounds = 75;

Row thousandRobots(int lanes) {
  RobotTeam many(soleWalker(), standingAngles(), multibodyLevel(), 1000, lanes);
  RobotTeam few(soleWalker(), standingAngles(), multibodyLevel(), 24, lanes);
  for (RobotTeam* team : {&many, &few}) team->settle(0.5), team->stance().require(team->startHeight(), "1000 and 24");
  // Ours over peer, for once: `few` stands in the place of what is measured.
  const Comparison c = compareFrames(
                           {[&] { few.frame(); }}, [&] { many.frame(); }, kRounds)
                           .front();
  Row row{"multibody_1000_over_24",
          c.ratio * 24 / 1000,
          c.peer * 1e9 / 1000,
          c.ours * 1e9 / 24,
          "ns/robot-frame",
          isaOf(lanes),
          ""};
  row.text = fmt::format("{:28} {:7} {:6.2f} times the cost of a robot among 24 ({:.0f} ns, {:.0f} ns a robot-frame)",
                         row.name, row.isa, row.ratio, row.ours, row.peer);
  return row;
}

/// 24 robots of 10 to 80 joints; the peer is a second team of 10 joints.
std::vector<Row> moreJoints(const Level& level) {
  constexpr std::array<int, 4> kJoints{10, 20, 40, 80};
  constexpr int kRobots = 24;
  std::deque<RobotBlueprint> prints;
  std::deque<RobotTeam> teams;
  std::vector<std::function<void()>> frames;
  const auto addTeam = [&](int joints) {
    const RobotBlueprint& print = prints.emplace_back(limbRobot(joints));
    RobotTeam& team = teams.emplace_back(print, std::vector<double>(static_cast<std::size_t>(joints), 0.0), level,
                                         kRobots, widestLanes());
    team.settle(0.5);
    team.stance().require(team.startHeight(), print.model.name);
    frames.emplace_back([&team] { team.frame(); });
  };
  for (const int joints : kJoints) addTeam(joints);
  addTeam(kJoints[0]);
  const std::function<void()> peer = frames.back();
  frames.pop_back();
  const std::vector<Comparison> results = compareFrames(frames, peer, kRounds);
  std::vector<Row> rows;
  for (std::size_t i = 0; i < results.size(); ++i) {
    const Comparison& c = results[i];
    constexpr double kPerRobot = 1e9 / kRobots;
    Row& row = rows.emplace_back(Row{fmt::format("joints_{}_{}", kJoints[i], level.name), 1 / c.ratio,
                                     c.ours * kPerRobot, c.peer * kPerRobot, "ns/robot-frame", widestIsa(), ""});
    row.text =
        fmt::format("{:28} {:7} {:6.2f} times the cost at 10 joints ({:.0f} ns a robot-frame, {:.1f} ns a joint)",
                    row.name, row.isa, row.ratio, row.ours, row.ours / kJoints[i]);
  }
  return rows;
}

}  // namespace

std::vector<Part> growthParts() {
  std::vector<Part> parts;
  for (const int lanes : laneWidths()) parts.emplace_back([lanes] { return std::vector<Row>{thousandRobots(lanes)}; });
  for (const Level& level : {multibodyLevel(), simplifiedLevel(), kinematicLevel()}) {
    parts.emplace_back([level] { return moreJoints(level); });
  }
  return parts;
}

}  // namespace murosimf::bench
