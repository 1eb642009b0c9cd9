#include "player/vision/robot_finder.h"

#include <algorithm>
#include <array>

namespace murosimf::controllers {
namespace {

constexpr double kNearest = 0.25, kFarthest = 5;          ///< own feet are nearer than that [m]
constexpr double kLowestMark = 0.12, kHighestMark = 0.6;  ///< above the ground [m]
constexpr double kHalfWidth = 0.22;                       ///< of a robot, arms included [m]
constexpr int kLineAtBorder = 6;  ///< so many cells of carpet or line down to the border are no robot
constexpr std::size_t kMostMarks = 32;

/// Last row of the obstacle in this column, going down from `row`; rows() if it reaches down to the
/// border of the picture, -1 if there is none. Two green cells in succession are carpet; one may be noise. White before
/// the carpet is a line that the robot stands on.
int footRow(const ColourGrid& grid, int column, int row) {
  int last_dark = -1;
  for (; row < grid.rows(); ++row) {
    const Colour colour = grid.cell(column, row);
    if (colour == Colour::kGreen) {
      if (row + 1 < grid.rows() && grid.cell(column, row + 1) == Colour::kGreen) return last_dark;
    } else if (colour != Colour::kWhite) {
      last_dark = row;
    }
  }
  return row - last_dark > kLineAtBorder ? last_dark : row;
}

/// The lowest place, in picture coordinates, that columns below the region reach; perhaps the border of the picture.
std::optional<PixelPoint> footOf(const ColourGrid& grid, const Region& region) {
  const int widen = std::max(2, (region.right - region.left + 1) / 2);
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

/// A mark with the foot point below it.
struct Mark {
  Vector3 foot;           ///< in R
  double distance = 0;    ///< of the foot from the camera
  Vector3 direction;      ///< to the mark, horizontal length 1
  PixelPoint pixel;       ///< of the foot
  double half_width = 0;  ///< [pixels]
  bool cut = false;       ///< the foot is out of the picture, nearer than this
};

double heightAt(const PictureView& view, const Vector3& direction, double distance) {
  return view.X_RC.translation.z + distance * direction.z;
}

std::optional<Mark> examine(const PictureView& view, const ColourGrid& grid, const Region& region) {
  const std::optional<PixelPoint> pixel = footOf(grid, region);
  if (!pixel) return std::nullopt;
  const std::optional<Vector3> foot = view.ground(pixel->u, pixel->v);
  if (!foot) return std::nullopt;
  const double u = grid.pixelOf((region.left + region.right) / 2), v = grid.pixelOf((region.top + region.bottom) / 2);
  const Vector3 d = view.direction(u, v);
  Mark mark{*foot, horizontal(*foot - view.X_RC.translation), d * (1 / horizontal(d)), *pixel};
  mark.cut = pixel->v > view.height - 1.5 * grid.step();
  mark.half_width = 0.5 * (region.right - region.left + 1) * grid.step();
  if (mark.distance < kNearest || mark.distance > kFarthest) return std::nullopt;
  const double height = heightAt(view, mark.direction, mark.distance), tolerance = 0.04 * mark.distance;
  if (height < kLowestMark - tolerance || height > kHighestMark + tolerance) return std::nullopt;
  return mark;
}

/// Whether `mark` may hang on the robot whose foot was found nearer: beside it, at a height that robots have. An arm
/// before the carpet has its "foot" far behind its robot.
bool belongsTo(const PictureView& view, const Mark& mark, const Mark& nearer) {
  const Vector3 p = view.X_RC.translation + mark.direction * nearer.distance;
  const double height = heightAt(view, mark.direction, nearer.distance);
  const double dx = p.x - nearer.foot.x, dy = p.y - nearer.foot.y;
  return dx * dx + dy * dy < kHalfWidth * kHalfWidth && height > 0.1 && height < 0.6;
}

}  // namespace

void findRobots(const PictureView& view, const ColourGrid& grid, Percepts& out) {
  std::array<Mark, kMostMarks> marks;  // nearest first
  std::size_t count = 0;
  for (const Region& region : grid.regions()) {
    if ((region.colour != Colour::kMagenta && region.colour != Colour::kCyan) || region.cells < 3) continue;
    const std::optional<Mark> mark = examine(view, grid, region);
    if (!mark || count == kMostMarks) continue;
    std::size_t place = count++;
    for (; place > 0 && marks[place - 1].distance > mark->distance; --place) marks[place] = marks[place - 1];
    marks[place] = *mark;
  }
  std::size_t robots = 0;  // those kept stand at the front of the list
  for (std::size_t i = 0; i < count; ++i) {
    const Mark mark = marks[i];
    const bool known = std::any_of(marks.begin(), marks.begin() + static_cast<std::ptrdiff_t>(robots),
                                   [&](const Mark& robot) { return belongsTo(view, mark, robot); });
    if (known) continue;
    marks[robots++] = mark;
    if (mark.cut) continue;  // it stands there, but who knows where
    out.robots.push_back({mark.foot.x, mark.foot.y});
    out.drawn.push_back({client::Percept::Kind::kRobot, view.camera, mark.pixel.u, mark.pixel.v, mark.half_width,
                         horizontal(mark.foot), atan2(mark.foot.y, mark.foot.x)});
  }
}

}  // namespace murosimf::controllers
