#include "murosimf/simulation/live_line.h"

#include <fmt/format.h>
#include <unistd.h>

namespace murosimf {

namespace {

struct SlowestStage {
  Stage stage = Stage::kCount;
  double share = 0;  // of the time of all stages
};

/// The stage that took most of the time between two readings of the clock.
SlowestStage slowest(const StageClock& now, const StageClock& last) {
  SlowestStage found;
  double sum = 0, most = 0;
  for (int i = 0; i < static_cast<int>(Stage::kCount); ++i) {
    const auto stage = static_cast<Stage>(i);
    const double seconds = now.seconds(stage) - last.seconds(stage);
    sum += seconds;
    if (seconds > most) most = seconds, found.stage = stage;
  }
  found.share = sum > 0 ? most / sum : 0;
  return found;
}

}  // namespace

LiveLine::LiveLine(const Settings& settings) : LiveLine(settings, isatty(fileno(settings.out)) == 1) {}

bool LiveLine::isDue(double simulated, double wall) const {
  if (!started_) return true;
  return terminal_ ? wall - last_wall_ >= settings_.wall_period
                   : simulated - last_simulated_ >= settings_.simulated_period - 1e-9;
}

void LiveLine::update(double simulated, double wall, const StageClock& stages, const std::string& score) {
  if (!isDue(simulated, wall)) return;
  if (started_) {
    const std::string line = compose(simulated, wall, stages, score);
    // Blanks cover what is left of a longer line.
    const std::size_t blanks = terminal_ && shown_ > line.size() ? shown_ - line.size() : 0;
    fmt::print(settings_.out, "{}{}{}{}", terminal_ ? "\r" : "", line, std::string(blanks, ' '), terminal_ ? "" : "\n");
    std::fflush(settings_.out);
    shown_ = line.size();
    open_ = terminal_;
  }
  started_ = true;
  last_simulated_ = simulated;
  last_wall_ = wall;
  last_stages_ = stages;
}

std::string LiveLine::compose(double simulated, double wall, const StageClock& stages, const std::string& score) const {
  const double passed = wall - last_wall_;
  const double factor = passed > 0 ? (simulated - last_simulated_) / passed : 0;
  const SlowestStage stage = slowest(stages, last_stages_);
  std::string line = fmt::format("{:8.1f} s  {:6.1f} x real time", simulated, factor);
  if (!score.empty()) line += "  " + score;
  if (stage.stage != Stage::kCount)
    line += fmt::format("  slowest: {} {:.0f} %", nameOf(stage.stage), 100 * stage.share);
  return line;
}

void LiveLine::finish() {
  if (open_) fmt::print(settings_.out, "\n");
  open_ = false;
}

}  // namespace murosimf
