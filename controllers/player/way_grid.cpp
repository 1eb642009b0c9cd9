#include "way_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace murosimf::controllers {

namespace {

constexpr double kFreeSide = 1.3;               // beside a course without limit [m]
constexpr double kBefore = 0.6, kBehind = 0.8;  // start and finish line [m]
constexpr double kBody = 0.16, kWish = 0.34;    // distance from an obstacle's edge: too little, enough [m]
constexpr double kCollision = 60, kNear = 6;    // costs a metre
constexpr double kEdge = 0.08, kOutside = 100;  // distance from the strip's edge [m], cost a metre
constexpr double kWallHalfWidth = 0.06, kWallCost = 300;
constexpr double kUnknown = std::numeric_limits<double>::infinity();

}  // namespace

void WayGrid::start(const client::CourseDescription& course) {
  course_ = course;
  const double side = course.width > 0 ? 0.5 * course.width + 0.1 : kFreeSide;
  corner_ = {-kBefore, -side};
  columns_ = std::max(1, static_cast<int>(std::lround((course.length + kBefore + kBehind) / kCell)));
  rows_ = std::max(1, static_cast<int>(std::lround(2 * side / kCell)));
  const auto cells = static_cast<std::size_t>(columns_ * rows_);
  cell_cost_.assign(cells, 1);
  way_cost_.assign(cells, kUnknown);
  heap_.reserve(9 * cells);
}

Point WayGrid::centre(int cell) const {
  const int column = cell % columns_, row = cell / columns_;
  return corner_ + Point{(column + 0.5) * kCell, (row + 0.5) * kCell};
}

int WayGrid::cellOf(const Point& p_C) const {
  const Point p = p_C - corner_;
  const int column = std::clamp(static_cast<int>(std::floor(p.x / kCell)), 0, columns_ - 1);
  const int row = std::clamp(static_cast<int>(std::floor(p.y / kCell)), 0, rows_ - 1);
  return row * columns_ + column;
}

template <class Visit>
void WayGrid::forNeighbours(int cell, const Visit& visit) const {
  const int column = cell % columns_, row = cell / columns_;
  for (int r = std::max(0, row - 1); r <= std::min(rows_ - 1, row + 1); ++r) {
    for (int c = std::max(0, column - 1); c <= std::min(columns_ - 1, column + 1); ++c) {
      if (r != row || c != column) visit(r * columns_ + c, r != row && c != column ? kCell * sqrt(2.0) : kCell);
    }
  }
}

double WayGrid::costAt(const Point& p, std::span<const Point> obstacles_C, std::span<const CourseWall> walls) const {
  double cost = 1;
  for (const Point& obstacle : obstacles_C) {
    const double gap = norm(p - obstacle) - course_.obstacle_radius;
    if (gap < kBody) {
      cost += kCollision * (1 + (kBody - gap) / kBody);
    } else if (gap < kWish) {
      cost += kNear * (kWish - gap) / (kWish - kBody);
    }
  }
  if (course_.width > 0 && std::fabs(p.y) > 0.5 * course_.width - kEdge) cost += kOutside;
  for (const CourseWall& wall : walls) {
    const bool beside = wall.to_left ? p.y > wall.from.y : p.y < wall.from.y;
    if (beside && std::fabs(p.x - wall.from.x) < kWallHalfWidth) cost += kWallCost;
  }
  return cost;
}

void WayGrid::plan(std::span<const Point> obstacles_C, std::span<const CourseWall> walls) {
  heap_.clear();
  for (int cell = 0; cell < columns_ * rows_; ++cell) {
    const auto i = static_cast<std::size_t>(cell);
    const Point p = centre(cell);
    cell_cost_[i] = costAt(p, obstacles_C, walls);
    const bool finish = p.x > course_.length + 0.5 * kBehind;
    way_cost_[i] = finish ? 0 : kUnknown;
    if (finish) heap_.push_back({0, cell});
  }
  while (!heap_.empty()) {
    std::pop_heap(heap_.begin(), heap_.end(), costsMore);
    const Entry entry = heap_.back();
    heap_.pop_back();
    if (entry.cost > way_cost_[static_cast<std::size_t>(entry.cell)]) continue;
    relax(entry.cell);
  }
}

void WayGrid::relax(int cell) {
  const auto i = static_cast<std::size_t>(cell);
  forNeighbours(cell, [&](int other, double length) {
    const auto k = static_cast<std::size_t>(other);
    const double cost = way_cost_[i] + stepCost(cell, other, length);
    if (!(cost < way_cost_[k])) return;
    way_cost_[k] = cost;
    heap_.push_back({cost, other});
    std::push_heap(heap_.begin(), heap_.end(), costsMore);
  });
}

double WayGrid::stepCost(int from, int to, double length) const {
  return 0.5 * length * (cell_cost_[static_cast<std::size_t>(from)] + cell_cost_[static_cast<std::size_t>(to)]);
}

/// The neighbour that lies on the cheapest way; the cell itself at the finish.
int WayGrid::next(int cell) const {
  if (way_cost_[static_cast<std::size_t>(cell)] <= 0) return cell;
  int best = cell;
  double least = kUnknown;
  forNeighbours(cell, [&](int other, double length) {
    const double cost = way_cost_[static_cast<std::size_t>(other)] + stepCost(cell, other, length);
    if (cost < least) least = cost, best = other;
  });
  return best;
}

Point WayGrid::ahead(const Point& p_C, double distance) const {
  int cell = cellOf(p_C);
  Point p = p_C;
  for (double gone = 0; gone < distance;) {
    const int further = next(cell);
    if (further == cell) return p + Point{distance - gone, 0};
    gone += norm(centre(further) - p);
    p = centre(further), cell = further;
  }
  return p;
}

}  // namespace murosimf::controllers
