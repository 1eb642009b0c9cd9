// What each pass of a frame with dynamics takes: 24 KS21, and the whole frame beside it.

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "paired_ratio.h"
#include "robot_team.h"

namespace murosimf::bench {
namespace {

constexpr int kRobots = 24, kFrames = 4, kRounds = 401;  // rounds so short that few are interrupted

/// Runs the passes of a team one by one with a clock between them. What the integrator asks for runs twice by itself
/// before the integrator, once to warm caches up, once timed; the integrator's own part is the rest of its time. Forces
/// of a state may be computed as often as one likes.
class TimedPasses {
 public:
  TimedPasses(RobotTeam& team, std::string integrator)
      : team_(team),
        integrator_(std::move(integrator)),
        batch_(team.linked().batches().front()),
        memory_(team.linked().stepMemorySize()) {}

  /// Adds the seconds of some frames to `seconds`, by name.
  void run(std::map<std::string, double>& seconds) {
    for (int i = 0; i < kFrames; ++i) {
      timed(seconds["commands"], [&] { team_.command(); });
      for (const Phase phase : {Phase::kPrescribe, Phase::kAdvance, Phase::kSense}) {
        for (int b = 0; b < batch_.blockCount(); ++b) block(phase, b, seconds);
      }
      timed(seconds["sensors"], [&] { team_.sense(); });
    }
  }

 private:
  template <class Work>
  static double timed(double& sum, Work&& work) {
    const double begin = now();
    work();
    const double taken = now() - begin;
    sum += taken;
    return taken;
  }
  void block(Phase phase, int b, std::map<std::string, double>& seconds) {
    const BlockMemory memory = batch_.block(b, memory_.data());
    double evaluations = 0;
    for (int i = 0; i < 2 && phase == Phase::kAdvance; ++i) {
      std::fill_n(memory_.data(), batch_.sum_size * static_cast<std::size_t>(batch_.width), 0.0);
      std::map<std::string, double> warming_up;
      evaluations = passes(Phase::kEvaluate, memory, i == 0 ? warming_up : seconds);
    }
    passes(phase, memory, seconds);
    if (phase == Phase::kAdvance) seconds[integrator_] -= evaluations;
  }
  double passes(Phase phase, const BlockMemory& memory, std::map<std::string, double>& seconds) {
    double sum = 0;
    for (const LinkedPass& pass : batch_.passes) {
      if (pass.phase != phase || !pass.scheduled) continue;
      const StepTime time{0, pass.dt, 0, phase == Phase::kEvaluate ? pass.dt : 0};
      sum += timed(seconds[pass.name], [&] { pass.module->step(memory, time); });
    }
    return sum;
  }

  RobotTeam& team_;
  std::string integrator_;
  const Batch& batch_;
  AlignedDoubles memory_;
};

std::vector<Row> passesAt(const Level& level, int lanes) {
  RobotTeam team(soleWalker(), standingAngles(), level, kRobots, lanes);
  team.settle(1);
  TimedPasses passes(team, level.modules.back());  // the integrator stands last
  std::map<std::string, std::vector<double>> shares, times;
  std::vector<double> wholes;
  for (int round = 0; round < kRounds; ++round) {
    std::map<std::string, double> seconds;
    passes.run(seconds);
    const double begin = now();
    for (int i = 0; i < kFrames; ++i) team.frame();
    const double whole = now() - begin;
    wholes.push_back(whole);
    for (const auto& [name, time] : seconds) shares[name].push_back(time / whole), times[name].push_back(time);
  }
  std::vector<Row> rows;
  constexpr double kPerRobot = 1e9 / (kRobots * kFrames);
  for (const auto& [name, share] : shares) {
    Row& row = rows.emplace_back(Row{fmt::format("pass_{}_{}", level.name, name), median(share),
                                     median(times[name]) * kPerRobot, median(wholes) * kPerRobot, "ns/robot-frame",
                                     isaOf(lanes), ""});
    row.text = fmt::format("{:38} {:7} {:6.1f} % of the frame ({:.0f} of {:.0f} ns)", row.name, row.isa,
                           100 * row.ratio, row.ours, row.peer);
  }
  return rows;
}

}  // namespace

std::vector<Part> passParts() {
  std::vector<Part> parts;
  for (const Level& level : {multibodyLevel(), simplifiedLevel()}) {
    for (const int lanes : laneWidths()) parts.emplace_back([level, lanes] { return passesAt(level, lanes); });
  }
  return parts;
}

}  // namespace murosimf::bench
