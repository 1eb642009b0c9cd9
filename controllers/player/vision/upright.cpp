#include "player/vision/upright.h"

#include <algorithm>
#include <array>

namespace murosimf::controllers {
namespace {

constexpr int kMostRows = 12;

/// Azimuths of one edge, relative to a reference so that they cannot wrap.
struct EdgeAzimuths {
  std::array<double, kMostRows> values{};
  int count = 0;
  void add(double azimuth) { values[static_cast<std::size_t>(count++)] = azimuth; }
  double median() {
    const auto middle = values.begin() + count / 2;
    std::nth_element(values.begin(), middle, values.begin() + count);
    return *middle;
  }
};

struct Sides {
  EdgeAzimuths left, right;
  double reference = 0;
  int rows = 0;
  double width_sum = 0;
  int widths = 0;
};

double azimuthOf(const PictureView& view, const PixelPoint& p) {
  const Vector3 d = view.direction(p.u, p.v);
  return atan2(d.y, d.x);
}

const Signal& signalOf(Colour colour) { return colour == Colour::kYellow ? kYellowSignal : kBlueSignal; }

/// What stands before a post hides its true edge: dark things, marks and the ball.
bool mayCover(Colour outside) {
  return outside == Colour::kMagenta || outside == Colour::kCyan || outside == Colour::kOrange;
}

void measureRow(const PictureView& view, const Bar& bar, const PixelPoint& middle, int reach, Sides& sides) {
  const Signal& signal = signalOf(bar.colour);
  const Edge left = walkToEdge(view, signal, middle, -1, 0, reach);
  const Edge right = walkToEdge(view, signal, middle, 1, 0, reach);
  ++sides.rows;
  const bool left_good = left.end == Edge::End::kFound && !mayCover(left.outside);
  const bool right_good = right.end == Edge::End::kFound && !mayCover(right.outside);
  if (left_good) sides.left.add(wrapAngle(azimuthOf(view, left.at) - sides.reference));
  if (right_good) sides.right.add(wrapAngle(azimuthOf(view, right.at) - sides.reference));
  if (left_good && right_good) {
    sides.width_sum += right.at.u - left.at.u;
    ++sides.widths;
  }
}

PixelPoint middleOf(const ColourGrid& grid, const Bar& bar, double row) {
  return {bar.centre(row) * grid.step() + grid.step() / 2, row * grid.step() + grid.step() / 2};
}

Sides measureSides(const PictureView& view, const ColourGrid& grid, std::span<const Bar* const> bars) {
  Sides sides;
  sides.reference = azimuthOf(view, middleOf(grid, *bars[0], bars[0]->top));
  const int rows_each = kMostRows / static_cast<int>(bars.size());
  for (const Bar* bar : bars) {
    // The last row of a bar may show the next thing already: stay clear of both ends where there is room.
    const int margin = bar->height() > 4 ? 1 : 0;
    const int first = bar->top + margin, last = bar->bottom - margin, count = std::min(rows_each, last - first + 1);
    for (int i = 0; i < count; ++i) {
      const int row = first + (count == 1 ? 0 : i * (last - first) / (count - 1));
      const int reach = static_cast<int>(2 * bar->mean_width + 4) * grid.step();
      measureRow(view, *bar, middleOf(grid, *bar, row), reach, sides);
    }
  }
  return sides;
}

/// Follows the middle line down, and up, to where the colour ends.
void findEnds(const PictureView& view, const ColourGrid& grid, const Bar& upper, const Bar& lower, Upright& upright) {
  const PixelPoint top = middleOf(grid, upper, upper.top), bottom = middleOf(grid, lower, lower.bottom);
  const double length = bottom.v - top.v;
  const double slope = length >= 4 * grid.step() ? (bottom.u - top.u) / length : 0;
  const int reach = 4 * grid.step();
  const Edge down = walkToEdge(view, signalOf(lower.colour), bottom, slope, 1, reach);
  const Edge up = walkToEdge(view, signalOf(upper.colour), top, -slope, -1, reach);
  upright.cut_below = down.end == Edge::End::kBorder;
  upright.cut_above = up.end == Edge::End::kBorder;
  upright.lowest = down.end == Edge::End::kFound ? down.at : bottom;
  upright.highest = up.end == Edge::End::kFound ? up.at : top;
  upright.below = down.end == Edge::End::kFound ? down.outside : Colour::kOther;
}

/// Distance by the width; deviation of an edge's median .3 pixels.
std::optional<Estimate> byWidth(const PictureView& view, Sides& sides, double radius, double& azimuth) {
  if (sides.left.count * 3 < sides.rows || sides.right.count * 3 < sides.rows) return std::nullopt;
  const double left = sides.left.median(), right = sides.right.median();
  const double sine = sin(0.5 * (left - right));
  if (sine <= 1e-4) return std::nullopt;
  azimuth = sides.reference + 0.5 * (left + right);
  const double distance = radius / sine;
  return Estimate{distance, distance * (0.3 / view.description->fx / sine + 0.01)};
}

/// Distance by the foot point; the front of the foot is a radius nearer than the axis.
std::optional<Estimate> byFoot(const PictureView& view, const Upright& upright, double radius) {
  if (upright.below != Colour::kGreen && upright.below != Colour::kWhite) return std::nullopt;
  const auto foot = view.ground(upright.lowest.u, upright.lowest.v);
  if (!foot) return std::nullopt;
  const double distance = horizontal(*foot - view.X_RC.translation) + radius;
  return Estimate{distance, groundDeviation(distance, view.X_RC.translation.z, view.description->fx)};
}

/// With one edge out of sight the axis lies beside the other one, by the angle that the foot's distance implies.
std::optional<double> azimuthByOneEdge(Sides& sides, double radius, double distance) {
  const double half = asin(radius / distance);
  if (sides.left.count * 3 >= sides.rows) return sides.reference + sides.left.median() - half;
  if (sides.right.count * 3 >= sides.rows) return sides.reference + sides.right.median() + half;
  return std::nullopt;
}

}  // namespace

std::optional<Upright> measureUpright(const PictureView& view, const ColourGrid& grid, std::span<const Bar* const> bars,
                                      double radius) {
  Sides sides = measureSides(view, grid, bars);
  Upright upright;
  findEnds(view, grid, *bars.front(), *bars.back(), upright);
  const std::optional<Estimate> width = byWidth(view, sides, radius, upright.azimuth);
  const std::optional<Estimate> foot = byFoot(view, upright, radius);
  if (width) upright.distance = *width;
  if (foot) {
    const double contradiction = width ? abs(foot->value - width->value) : 0;
    const double allowed = width ? 0.05 + 3 * (foot->deviation + width->deviation) : 1;
    upright.foot_seen = contradiction < allowed;
  }
  if (!width) {
    if (!upright.foot_seen) return std::nullopt;
    const std::optional<double> azimuth = azimuthByOneEdge(sides, radius, foot->value);
    if (!azimuth) return std::nullopt;
    upright.azimuth = *azimuth;
    upright.distance = *foot;
  } else if (upright.foot_seen) {
    upright.distance = fuse(*width, *foot);
  }
  upright.half_width =
      sides.widths > 0 ? 0.5 * sides.width_sum / sides.widths : 0.5 * bars.front()->mean_width * grid.step();
  return upright;
}

double heightAt(const PictureView& view, const Upright& upright, const PixelPoint& pixel) {
  const Vector3 d = view.direction(pixel.u, pixel.v);
  return view.X_RC.translation.z + upright.distance.value * d.z / horizontal(d);
}

}  // namespace murosimf::controllers
