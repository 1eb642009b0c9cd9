#include "player/vision/colour_grid.h"

#include <algorithm>

namespace murosimf::controllers {
namespace {

bool isCarpetOrGrey(Colour c) { return c == Colour::kOther || c == Colour::kGreen || c == Colour::kWhite; }

}  // namespace

void ColourGrid::start(int width, int height) {
  step_ = width >= 480 ? 4 : 2;
  columns_ = width / step_;
  rows_ = height / step_;
  cells_.assign(static_cast<std::size_t>(columns_ * rows_), Colour::kOther);
  runs_.reserve(kMostRuns);
  regions_.reserve(kMostRuns);
  region_of_root_.reserve(kMostRuns);
}

void ColourGrid::fill(const PictureView& view) {
  for (int row = 0; row < rows_; ++row) {
    const std::uint8_t* p = view.pixel(pixelOf(0), pixelOf(row));
    Colour* cells = &cells_[static_cast<std::size_t>(row * columns_)];
    for (int column = 0; column < columns_; ++column, p += 3 * step_) cells[column] = classify(p, view.colours);
  }
  findRuns();
  connectRuns();
  collectRegions();
}

void ColourGrid::findRuns() {
  runs_.clear();
  for (int row = 0; row < rows_; ++row) {
    const Colour* cells = &cells_[static_cast<std::size_t>(row * columns_)];
    for (int column = 0; column < columns_;) {
      const Colour colour = cells[column];
      const int first = column;
      while (++column < columns_ && cells[column] == colour) {
      }
      if (isCarpetOrGrey(colour) || runs_.size() == kMostRuns) continue;
      runs_.push_back({colour, row, first, column - 1, static_cast<int>(runs_.size())});
    }
  }
}

int ColourGrid::rootOf(int run) {
  auto at = [this](int i) -> Run& { return runs_[static_cast<std::size_t>(i)]; };
  while (at(run).root != run) {
    at(run).root = at(at(run).root).root;
    run = at(run).root;
  }
  return run;
}

void ColourGrid::connectRuns() {
  std::size_t above = 0;
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    while (above < i && (runs_[above].row < runs_[i].row - 1 ||
                         (runs_[above].row == runs_[i].row - 1 && runs_[above].last < runs_[i].first - 1))) {
      ++above;
    }
    for (std::size_t j = above; j < i && runs_[j].row < runs_[i].row && runs_[j].first <= runs_[i].last + 1; ++j) {
      if (runs_[j].colour != runs_[i].colour) continue;
      const int a = rootOf(static_cast<int>(i)), b = rootOf(static_cast<int>(j));
      runs_[static_cast<std::size_t>(std::max(a, b))].root = std::min(a, b);
    }
  }
}

void ColourGrid::collectRegions() {
  regions_.clear();
  region_of_root_.assign(runs_.size(), -1);
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    const Run& run = runs_[i];
    const int root = rootOf(static_cast<int>(i));
    int& index = region_of_root_[static_cast<std::size_t>(root)];
    if (index < 0) {
      index = static_cast<int>(regions_.size());
      regions_.push_back({run.colour, root, 0, run.first, run.last, run.row, run.row, static_cast<int>(i)});
    }
    Region& region = regions_[static_cast<std::size_t>(index)];
    region.cells += run.width();
    region.left = std::min(region.left, run.first);
    region.right = std::max(region.right, run.last);
    region.bottom = run.row;
    if (run.width() > runs_[static_cast<std::size_t>(region.widest_run)].width())
      region.widest_run = static_cast<int>(i);
  }
}

}  // namespace murosimf::controllers
