// Our frame against those of MuJoCo and ODE: KS21 stands, 1 ms, same masses, gains, friction, commands and sensors.
//
// A frame: command of all joints, position servos with their torque limit, motion of the tree, both soles against the
// ground with 8 points, dynamics, integration, joint and inertial sensors without noise; no world poses.

#include <fmt/format.h>

#include <deque>
#include <memory>

#include "camera_peer.h"
#include "heap_benchmark.h"
#include "paired_ratio.h"
#include "peers/mujoco_robot.h"
#include "peers/ode_robot.h"
#include "robot_team.h"

namespace murosimf::bench {
namespace {

constexpr int kRounds = 151;
constexpr double kSettled = 2.0;   // [s]
constexpr double kFriction = 0.8;  // that of motion::groundTable()

/// Robots of another simulator, each by itself; Robot commands, steps and reads.
template <class Robot>
class PeerTeam {
 public:
  template <class Make>
  PeerTeam(int robots, const Pose& start, Make&& make) : start_height_(start.translation.z), q_(standingAngles()) {
    for (int i = 0; i < robots; ++i) robots_.push_back(make(start, q_));
    sensors_.assign(robots_.size(), peers::PeerSensors(soleWalker()));
    for (int i = 0; i < kSettled / 1e-3; ++i) frame();
  }
  void frame() {
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      robots_[i]->command(q_);
      robots_[i]->step();
      robots_[i]->read(sensors_[i]);
    }
  }
  Stance stance() const {
    Stance lowest{robots_[0]->height(), robots_[0]->contacts()};
    for (const auto& robot : robots_) {
      if (!(robot->height() >= lowest.height)) lowest = {robot->height(), robot->contacts()};
    }
    return lowest;
  }
  double startHeight() const { return start_height_; }

 private:
  double start_height_;
  std::vector<double> q_;
  std::vector<std::unique_ptr<Robot>> robots_;
  std::vector<peers::PeerSensors> sensors_;
};

/// What our teams of one level are compared with.
struct Match {
  std::string row, peer;
  int robots = 1;
  Level level;
  std::vector<int> lanes;
};

template <class Peer>
std::vector<Row> play(const Match& match, Peer& peer) {
  std::deque<RobotTeam> teams;
  std::vector<std::function<void()>> frames;
  for (const int lanes : match.lanes) {
    RobotTeam& team = teams.emplace_back(soleWalker(), standingAngles(), match.level, match.robots, lanes);
    team.settle(kSettled);
    frames.emplace_back([&team] { team.frame(); });
  }
  const auto results = compareFrames(
      frames, [&peer] { peer.frame(); }, kRounds);
  peer.stance().require(peer.startHeight(), match.peer);
  std::vector<Row> rows;
  for (std::size_t i = 0; i < results.size(); ++i) {
    const Stance ours = teams[i].stance(), theirs = peer.stance();
    ours.require(teams[i].startHeight(), match.row);
    const double per_robot = 1e9 / match.robots;
    Row& row = rows.emplace_back(Row{match.row, results[i].ratio, results[i].ours * per_robot,
                                     results[i].peer * per_robot, "ns/robot-frame", isaOf(match.lanes[i]), ""});
    row.text = fmt::format(
        "{:28} {:7} {:6.1f} times {} ({:.0f} ns, {:.0f} ns a robot-frame); ours stands {:.4f} m high on {} points, "
        "theirs {:.4f} m on {}",
        row.name, row.isa, row.ratio, match.peer, row.ours, row.peer, ours.height, ours.contacts, theirs.height,
        theirs.contacts);
  }
  return rows;
}

Pose startOf(const Level& level) { return RobotTeam(soleWalker(), standingAngles(), level, 1, 1).start(); }

std::vector<Row> againstMujoco(const Level& level, int robots, const std::vector<int>& lanes) {
  const peers::MujocoModel model({.robot = soleWalker(), .friction = kFriction});
  PeerTeam<peers::MujocoRobot> peer(robots, startOf(level), [&](const Pose& X_WB, const std::vector<double>& q) {
    auto robot = std::make_unique<peers::MujocoRobot>(model);
    robot->set({X_WB, {}, q, std::vector<double>(q.size(), 0.0)});
    return robot;
  });
  const std::string name = fmt::format("{}_{}_vs_mujoco", level.name, robots);
  return play({name, fmt::format("MuJoCo {}", mj_versionString()), robots, level, lanes}, peer);
}

std::vector<Row> againstOde(const Level& level, int robots, const std::vector<int>& lanes) {
  PeerTeam<peers::OdeRobot> peer(robots, startOf(level), [](const Pose& X_WB, const std::vector<double>& q) {
    auto robot = std::make_unique<peers::OdeRobot>(peers::PeerScene{.robot = soleWalker(), .friction = kFriction});
    robot->place(X_WB, q);
    return robot;
  });
  return play({fmt::format("{}_{}_vs_ode", level.name, robots), "ODE's QuickStep", robots, level, lanes}, peer);
}

}  // namespace

std::vector<Part> peerParts() {
  return {[] { return againstMujoco(multibodyLevel(), 24, laneWidths()); },
          [] { return againstMujoco(multibodyLevel(), 1, {1}); },
          [] { return againstOde(multibodyLevel(), 24, laneWidths()); },
          [] { return againstOde(simplifiedLevel(), 24, laneWidths()); },
          heapAgainstMujoco,
          cameraAgainstMujoco};
}

}  // namespace murosimf::bench
