#include "player/vision/bars.h"

#include <algorithm>

namespace murosimf::controllers {
namespace {

double middle(const Run& run) { return 0.5 * (run.first + run.last); }

/// Columns a row by which an upright thing at this run leans in the picture.
double uprightSlope(const PictureView& view, const ColourGrid& grid, const Run& run) {
  const PlanePoint p = view.rays->ray(middle(run) * grid.step(), grid.pixelOf(run.row));
  const Vector3 z = applyTransposed(view.X_RC.rotation, {0, 0, -1});  // downwards, as seen from C
  const double da = z.x - p.a * z.z, db = z.y - p.b * z.z;
  const DistortedPoint lens = distort(*view.description, p);
  const double du = view.description->fx * (lens.da_da * da + lens.da_db * db);
  const double dv = view.description->fy * (lens.db_da * da + lens.db_db * db);
  return dv > 1e-3 ? std::clamp(du / dv, -3.0, 3.0) : 0;
}

bool continues(const Bar& bar, const Run& last, const Run& run) {
  const int rows = run.row - bar.bottom;
  if (bar.colour != run.colour || rows > 2 || rows < 1) return false;
  const double expected = bar.predicted + (rows - 1) * bar.slope, width = run.width();
  if (abs(middle(run) - expected) > 1.01 + 0.2 * std::min(width, bar.mean_width)) return false;
  const double change = std::max(abs(width - bar.recent_width), abs(width - last.width()));
  return change <= 1.01 + 0.35 * std::min(width, bar.recent_width);
}

/// Follows the runs slowly, so that a steady drift away from upright ends the chain.
void append(Bar& bar, const Run& run, int index, double slope) {
  const double expected = bar.predicted + (run.row - bar.bottom - 1) * bar.slope;
  bar.mean_width = (bar.mean_width * bar.runs + run.width()) / (bar.runs + 1);
  bar.recent_width += 0.2 * (run.width() - bar.recent_width);
  ++bar.runs;
  bar.bottom = run.row;
  bar.bottom_centre = middle(run);
  bar.last_run = index;
  bar.slope = slope;
  bar.predicted = expected + (bar.runs < 4 ? 0.5 : 0.3) * (middle(run) - expected) + slope;
}

Bar startingWith(const Run& run, int index, double slope) {
  const double centre = middle(run), width = run.width();
  return {run.colour, run.row, run.row, centre, centre, width, width, 1, index, centre + slope, slope};
}

}  // namespace

std::span<const Bar> BarChainer::chain(const PictureView& view, const ColourGrid& grid) {
  const std::span<const Run> runs = grid.runs();
  bars_.clear();
  previous_.assign(runs.size(), -1);
  std::size_t open = 0;  // bars before it have ended
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const Run& run = runs[i];
    if (run.colour != Colour::kYellow && run.colour != Colour::kBlue) continue;
    while (open < bars_.size() && bars_[open].bottom < run.row - 2) ++open;
    Bar* best = nullptr;
    for (std::size_t k = open; k < bars_.size(); ++k) {
      Bar& bar = bars_[k];
      const bool fits = continues(bar, runs[static_cast<std::size_t>(bar.last_run)], run);
      if (fits && (best == nullptr || bar.runs > best->runs)) best = &bar;
    }
    const double slope = uprightSlope(view, grid, run);
    if (best != nullptr) {
      previous_[i] = best->last_run;
      append(*best, run, static_cast<int>(i), slope);
    } else if (bars_.size() < kMostBars) {
      bars_.push_back(startingWith(run, static_cast<int>(i), slope));
    }
  }
  return bars_;
}

}  // namespace murosimf::controllers
