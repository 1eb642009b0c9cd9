#include "player/vision/obstacle_finder.h"

#include <algorithm>
#include <cstdlib>
#include <optional>

namespace murosimf::controllers {
namespace {

constexpr int kLeastCells = 6;                   ///< of a region
constexpr double kNearest = 0.2, kFarthest = 4;  ///< distance of the foot from the camera [m]
constexpr int kLargestStep = 1;                  ///< rows between the feet of neighbouring columns of one obstacle
constexpr double kSteepest = 0.6;      ///< rows a column, of its lower edge as a whole: sides that lean are steeper
constexpr double kLeastInSight = 0.4;  ///< of its width
constexpr int kLeastColumns = 3;
constexpr double kDepth = 0.8;  ///< from the feet in sight to the middle, over the radius

/// The lowest red cell of a column of the region, if carpet or a line is below it.
std::optional<int> footRow(const ColourGrid& grid, const Region& region, int column) {
  int row = region.bottom;
  while (row >= region.top && grid.cell(column, row) != region.colour) --row;
  if (row < region.top || row + 2 >= grid.rows()) return std::nullopt;
  const Colour below = grid.cell(column, row + 2);
  return below == Colour::kGreen || below == Colour::kWhite ? std::optional(row) : std::nullopt;
}

/// Feet of neighbouring columns that belong together.
struct Feet {
  int count = 0, first_column = 0, last_column = 0, lowest_row = 0;
  int first_row = 0, last_row = 0;
  Vector3 sum;  ///< on the ground, in R
};

void report(const PictureView& view, const ColourGrid& grid, const Feet& feet, double radius, Percepts& out) {
  if (feet.count < kLeastColumns || std::abs(feet.last_row - feet.first_row) > kSteepest * feet.count) return;
  const Vector3 middle = feet.sum * (1.0 / feet.count), ray = middle - view.X_RC.translation;
  const double distance = horizontal(ray);
  if (distance < kNearest || distance > kFarthest) return;
  const double whole = 2 * radius * view.description->fx / (distance * grid.step());  // columns, near the axis
  if (feet.count < kLeastInSight * whole) return;
  const double further = kDepth * radius / distance;
  const Vector3 p = middle + Vector3{further * ray.x, further * ray.y, 0};
  out.obstacles.push_back({p.x, p.y});
  const double u = 0.5 * (grid.pixelOf(feet.first_column) + grid.pixelOf(feet.last_column));
  out.drawn.push_back({client::Percept::Kind::kObstacle, view.camera, u,
                       grid.pixelOf(feet.lowest_row) + 0.5 * grid.step(),
                       0.5 * (feet.last_column - feet.first_column + 1) * grid.step(), horizontal(p), atan2(p.y, p.x)});
}

void findIn(const PictureView& view, const ColourGrid& grid, const Region& region, double radius, Percepts& out) {
  Feet feet;
  for (int column = region.left; column <= region.right; ++column) {
    const std::optional<int> row = footRow(grid, region, column);
    if (!row) continue;
    const auto foot = view.ground(grid.pixelOf(column), grid.pixelOf(*row) + 0.5 * grid.step());
    if (!foot) continue;
    if (feet.count > 0 && std::abs(*row - feet.last_row) > kLargestStep) {
      report(view, grid, feet, radius, out);
      feet = {};
    }
    if (feet.count == 0) feet.first_column = column, feet.first_row = *row;
    ++feet.count;
    feet.last_column = column;
    feet.lowest_row = std::max(feet.lowest_row, *row);
    feet.last_row = *row;
    feet.sum = feet.sum + *foot;
  }
  report(view, grid, feet, radius, out);
}

}  // namespace

void findObstacles(const PictureView& view, const ColourGrid& grid, double radius, Percepts& out) {
  for (const Region& region : grid.regions()) {
    if (region.colour == Colour::kRed && region.cells >= kLeastCells) findIn(view, grid, region, radius, out);
  }
}

}  // namespace murosimf::controllers
