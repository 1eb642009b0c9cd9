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

/// Whether the same thing lies behind the bar on both sides. If not, one side may be something that stands before it.
bool sameBackground(const PictureView& view, const PixelPoint& left, const PixelPoint& right) {
  const int v = static_cast<int>(left.v + 0.5), u1 = static_cast<int>(left.u - 1.5),
            u2 = static_cast<int>(right.u + 2.5);
  if (!view.inside(u1, v) || !view.inside(u2, v)) return false;
  const std::uint8_t *p = view.pixel(u1, v), *q = view.pixel(u2, v);
  int difference = 0, sum = 0;
  for (int i = 0; i < 3; ++i) difference += std::abs(p[i] - q[i]), sum += p[i] + q[i];
  return 8 * difference < sum + 160;
}

void measureRow(const PictureView& view, const Bar& bar, const PixelPoint& middle, int reach, Sides& sides) {
  const Signal& signal = signalOf(bar.colour);
  const Edge left = walkToEdge(view, signal, middle, -1, 0, reach);
  const Edge right = walkToEdge(view, signal, middle, 1, 0, reach);
  const bool both = left.end == Edge::End::kFound && right.end == Edge::End::kFound;
  if (both && !sameBackground(view, left.at, right.at)) return;
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

PixelPoint pixelOf(const ColourGrid& grid, double column, double row) {
  const double half = grid.pixelOf(0);
  return {column * grid.step() + half, row * grid.step() + half};
}

/// Some of the rows of a bar, evenly. Its ends may show the next thing already: they are left out where there is room.
void measureBar(const Sight& sight, const Bar& bar, int most_rows, Sides& sides) {
  const int margin = bar.runs > 4 ? 1 : 0, count = bar.runs - 2 * margin, stride = (count + most_rows - 1) / most_rows;
  const int reach = static_cast<int>(2 * bar.mean_width + 4) * sight.grid.step();
  int run = bar.last_run;
  for (int i = 0; i < margin + count; ++i, run = sight.chainer.above(run)) {
    if (i < margin || (i - margin) % stride != 0) continue;
    const Run& r = sight.grid.runs()[static_cast<std::size_t>(run)];
    measureRow(sight.view, bar, pixelOf(sight.grid, 0.5 * (r.first + r.last), r.row), reach, sides);
  }
}

Sides measureSides(const Sight& sight, std::span<const Bar* const> bars) {
  Sides sides;
  sides.reference = azimuthOf(sight.view, topOf(sight.grid, *bars[0]));
  for (const Bar* bar : bars) measureBar(sight, *bar, kMostRows / static_cast<int>(bars.size()), sides);
  return sides;
}

/// Follows the middle line down to where the colour ends. Upwards only the border of the picture matters: a post goes
/// over into the crossbar of the same colour, so its top is where the chain of runs ended.
void findEnds(const Sight& sight, const Bar& upper, const Bar& lower, Upright& upright) {
  const PixelPoint top = topOf(sight.grid, upper), bottom = bottomOf(sight.grid, lower);
  const Edge down = walkToEdge(sight.view, signalOf(lower.colour), bottom, lower.slope, 1, 4 * sight.grid.step());
  upright.cut_below = down.end == Edge::End::kBorder;
  upright.cut_above = upper.top <= 1;
  const int row = std::max(upper.top - 2, 0), column = static_cast<int>(upper.top_centre - 2 * upper.slope + 0.5);
  upright.goes_on_above = column >= 0 && column < sight.grid.columns() && sight.grid.cell(column, row) == upper.colour;
  upright.lowest = down.end == Edge::End::kFound ? down.at : bottom;
  upright.highest = {top.u, top.v - 0.5 * sight.grid.step()};
  upright.below = down.end == Edge::End::kFound ? down.outside : Colour::kOther;
}

/// Distance by the width; deviation of an edge's median .3 pixels.
std::optional<Estimate> byWidth(const PictureView& view, Sides& sides, double radius, double& azimuth) {
  if (sides.rows < 2 || sides.left.count * 3 < sides.rows || sides.right.count * 3 < sides.rows) return std::nullopt;
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
  if (sides.rows < 2) return std::nullopt;
  if (sides.left.count * 3 >= sides.rows) return sides.reference + sides.left.median() - half;
  if (sides.right.count * 3 >= sides.rows) return sides.reference + sides.right.median() + half;
  return std::nullopt;
}

/// Weighs width and foot. A width that is too small for the foot's distance is partly covered: then the foot counts,
/// and the axis may lie beside the middle of what is seen. Too large a width means that the foot is none.
bool combine(const std::optional<Estimate>& width, const std::optional<Estimate>& foot, double radius, Sides& sides,
             Upright& upright) {
  upright.foot_seen = foot.has_value();
  if (!width && !foot) return false;
  if (width && !foot) return upright.distance = *width, true;
  upright.distance = *foot;
  if (width && agree(*width, *foot)) return upright.distance = fuse(*width, *foot), true;
  if (width) {
    upright.azimuth_deviation += radius / foot->value - radius / width->value;
    return width->value > foot->value;
  }
  const std::optional<double> azimuth = azimuthByOneEdge(sides, radius, foot->value);
  if (azimuth) upright.azimuth = *azimuth;
  return azimuth.has_value();
}

}  // namespace

std::optional<Upright> measureUpright(const Sight& sight, std::span<const Bar* const> bars, double radius) {
  Sides sides = measureSides(sight, bars);
  Upright upright;
  findEnds(sight, *bars.front(), *bars.back(), upright);
  upright.azimuth_deviation = 0.01 + 1 / sight.view.description->fx;
  const std::optional<Estimate> width = byWidth(sight.view, sides, radius, upright.azimuth);
  if (!combine(width, byFoot(sight.view, upright, radius), radius, sides, upright)) return std::nullopt;
  const double grid_width = bars.front()->mean_width * sight.grid.step();
  upright.half_width = 0.5 * (sides.widths > 0 ? sides.width_sum / sides.widths : grid_width);
  return upright;
}

PixelPoint topOf(const ColourGrid& grid, const Bar& bar) { return pixelOf(grid, bar.top_centre, bar.top); }
PixelPoint bottomOf(const ColourGrid& grid, const Bar& bar) { return pixelOf(grid, bar.bottom_centre, bar.bottom); }

double slopeAt(const PictureView& view, const PixelPoint& pixel) {
  const Vector3 d = view.direction(pixel.u, pixel.v);
  return d.z / horizontal(d);
}

double heightAt(const PictureView& view, const Upright& upright, const PixelPoint& pixel) {
  return view.X_RC.translation.z + upright.distance.value * slopeAt(view, pixel);
}

}  // namespace murosimf::controllers
