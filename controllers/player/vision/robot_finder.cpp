#include "player/vision/robot_finder.h"

#include <algorithm>

namespace murosimf::controllers {
namespace {

constexpr double kNearest = 0.25, kFarthest = 5;           ///< own feet are nearer than that [m]
constexpr double kLowestMark = 0.08, kHighestMark = 0.65;  ///< above the ground [m]
constexpr double kSize = 0.3;                              ///< marks closer than this belong to one robot [m]

bool isField(Colour c) { return c == Colour::kGreen || c == Colour::kWhite; }

/// Last row of the obstacle in this column, going down from `row`; -1 if it reaches the border of the picture.
/// Two field cells in succession are the field; one may be noise, or a bright part.
int footRow(const ColourGrid& grid, int column, int row) {
  int last = -2;
  for (; row < grid.rows(); ++row) {
    if (!isField(grid.cell(column, row))) {
      last = row;
    } else if (row + 1 < grid.rows() && isField(grid.cell(column, row + 1))) {
      return last;
    }
  }
  return -1;
}

/// The lowest place, in picture coordinates, that columns below the region reach.
std::optional<PixelPoint> footOf(const ColourGrid& grid, const Region& region) {
  const int widen = std::max(1, (region.right - region.left) / 2);
  const int first = std::max(0, region.left - widen), last = std::min(grid.columns() - 1, region.right + widen);
  int lowest = -1;
  for (int column = first; column <= last; ++column) lowest = std::max(lowest, footRow(grid, column, region.bottom));
  if (lowest < 0) return std::nullopt;
  int sum = 0, count = 0;
  for (int column = first; column <= last; ++column) {
    if (footRow(grid, column, region.bottom) < lowest - 1) continue;
    sum += grid.pixelOf(column);
    ++count;
  }
  return PixelPoint{static_cast<double>(sum) / count, grid.pixelOf(lowest) + 0.5 * grid.step()};
}

bool markAtRobotsHeight(const PictureView& view, const ColourGrid& grid, const Region& region, double distance) {
  const double u = grid.pixelOf((region.left + region.right) / 2), v = grid.pixelOf((region.top + region.bottom) / 2);
  const Vector3 d = view.direction(u, v);
  const double height = view.X_RC.translation.z + distance * d.z / horizontal(d), tolerance = 0.05 * distance;
  return height > kLowestMark - tolerance && height < kHighestMark + tolerance;
}

bool known(const Percepts& out, const Vector3& p) {
  return std::any_of(out.robots.begin(), out.robots.end(), [&](const RobotPercept& r) {
    return (r.x - p.x) * (r.x - p.x) + (r.y - p.y) * (r.y - p.y) < kSize * kSize;
  });
}

}  // namespace

void findRobots(const PictureView& view, const ColourGrid& grid, Percepts& out) {
  for (const Region& region : grid.regions()) {
    if ((region.colour != Colour::kMagenta && region.colour != Colour::kCyan) || region.cells < 3) continue;
    const std::optional<PixelPoint> foot = footOf(grid, region);
    if (!foot) continue;
    const std::optional<Vector3> p = view.ground(foot->u, foot->v);
    if (!p || known(out, *p)) continue;
    const double distance = horizontal(*p - view.X_RC.translation);
    if (distance < kNearest || distance > kFarthest || !markAtRobotsHeight(view, grid, region, distance)) continue;
    out.robots.push_back({p->x, p->y});
    const double half_width = 0.5 * (region.right - region.left + 1) * grid.step();
    out.drawn.push_back({client::Percept::Kind::kRobot, view.camera, foot->u, foot->v, half_width, horizontal(*p)});
  }
}

}  // namespace murosimf::controllers
