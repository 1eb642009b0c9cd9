#include "player/vision/bars.h"

#include <algorithm>

namespace murosimf::controllers {
namespace {

bool continues(const Bar& bar, const Run& run) {
  if (bar.colour != run.colour || run.row - bar.bottom > 2 || run.row == bar.bottom) return false;
  if (run.first > bar.last.last + 1 || run.last < bar.last.first - 1) return false;
  // Against the mean, too: a bar must not swell by and by.
  const double width = run.width(), change = std::max(abs(width - bar.mean_width), abs(width - bar.last.width()));
  return change <= 1.01 + 0.35 * std::min(width, bar.mean_width);
}

void append(Bar& bar, const Run& run) {
  bar.mean_width = (bar.mean_width * bar.runs + run.width()) / (bar.runs + 1);
  ++bar.runs;
  bar.bottom = run.row;
  bar.bottom_centre = 0.5 * (run.first + run.last);
  bar.last = run;
}

Bar startingWith(const Run& run) {
  const double centre = 0.5 * (run.first + run.last);
  return {run.colour, run.row, run.row, centre, centre, static_cast<double>(run.width()), 1, run};
}

}  // namespace

std::span<const Bar> BarChainer::chain(const ColourGrid& grid) {
  bars_.clear();
  std::size_t open = 0;  // bars before it have ended
  for (const Run& run : grid.runs()) {
    if (run.colour != Colour::kYellow && run.colour != Colour::kBlue) continue;
    while (open < bars_.size() && bars_[open].bottom < run.row - 2) ++open;
    Bar* best = nullptr;
    for (std::size_t i = open; i < bars_.size(); ++i) {
      if (continues(bars_[i], run) && (best == nullptr || bars_[i].runs > best->runs)) best = &bars_[i];
    }
    if (best != nullptr) {
      append(*best, run);
    } else if (bars_.size() < kMostBars) {
      bars_.push_back(startingWith(run));
    }
  }
  return bars_;
}

}  // namespace murosimf::controllers
