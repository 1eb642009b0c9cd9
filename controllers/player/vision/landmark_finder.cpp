#include "player/vision/landmark_finder.h"

#include <algorithm>
#include <array>

#include "player/vision/upright.h"

namespace murosimf::controllers {
namespace {

constexpr double kNearest = 0.25, kFarthest = 8;  ///< distances that make sense on a field [m]

/// The bars of one pole, from the top.
struct Stack {
  std::array<const Bar*, 3> bars{};
  std::size_t count = 0;
  std::span<const Bar* const> span() const { return {bars.data(), count}; }
};

/// Whether `lower` is of the other colour and sits right below `upper`, equally wide.
bool sitsBelow(const Bar& upper, const Bar& lower) {
  if (upper.colour == lower.colour || lower.top - upper.bottom > 3 || lower.top < upper.bottom - 1) return false;
  const double width = std::max(upper.mean_width, lower.mean_width),
               other = std::min(upper.mean_width, lower.mean_width);
  return abs(upper.centre(upper.bottom) - lower.centre(lower.top)) < 0.4 * width + 0.5 && width < 1.5 * other + 1.5;
}

const Bar* below(const Bar& upper, std::span<const Bar> bars) {
  const Bar* best = nullptr;
  for (const Bar& bar : bars) {
    if (bar.top >= upper.bottom - 1 && sitsBelow(upper, bar) && (best == nullptr || bar.runs > best->runs)) best = &bar;
  }
  return best;
}

bool hasAnother(const Bar& bar, std::span<const Bar> bars, bool above) {
  for (const Bar& other : bars) {
    if (other.runs > 1 && (above ? sitsBelow(other, bar) : sitsBelow(bar, other))) return true;
  }
  return false;
}

LandmarkColour landmarkColour(Colour c) {
  return c == Colour::kYellow ? LandmarkColour::kYellow : LandmarkColour::kBlue;
}
LandmarkColour opposite(LandmarkColour c) {
  return c == LandmarkColour::kYellow ? LandmarkColour::kBlue : LandmarkColour::kYellow;
}

/// How far a height of an upright may be off: tilt of three degrees and the error of its distance.
double heightTolerance(const Upright& upright) { return 0.06 + 0.05 * upright.distance.value; }

PixelPoint jointOf(const ColourGrid& grid, const Bar& upper, const Bar& lower) {
  const double row = 0.5 * (upper.bottom + lower.top);
  return {lower.centre(row) * grid.step() + grid.step() / 2, row * grid.step() + grid.step() / 2};
}

/// Colour of the top segment. With two segments in sight it is open whether they are the upper or the lower two: a
/// visible end of the pole tells, else the height of the joint. Nothing if it is no pole.
std::optional<LandmarkColour> topColour(const PictureView& view, const ColourGrid& grid, const Stack& stack,
                                        const Upright& upright, double pole_height) {
  const LandmarkColour first = landmarkColour(stack.bars[0]->colour);
  const double joint = heightAt(view, upright, jointOf(grid, *stack.bars[0], *stack.bars[1]));
  const double high = pole_height * 2 / 3, low = pole_height / 3, tolerance = heightTolerance(upright);
  if (stack.count == 3) return abs(joint - high) < 2 * tolerance ? std::optional(first) : std::nullopt;
  if (abs(joint - high) > tolerance && abs(joint - low) > tolerance) return std::nullopt;
  const bool foot = upright.foot_seen && heightAt(view, upright, upright.lowest) < 0.1;
  const bool lower_two = foot || (upright.cut_above && abs(joint - low) < abs(joint - high));
  const bool upper_two = !foot && !upright.cut_above;
  if (upper_two) return first;
  return lower_two ? opposite(first) : first;
}

void report(const PictureView& view, const Upright& upright, LandmarkColour colour, client::Percept::Kind kind,
            std::vector<LandmarkPercept>& list, Percepts& out) {
  const SinCos<double> azimuth = sincos(upright.azimuth);
  const double x = view.X_RC.translation.x + upright.distance.value * azimuth.cos;
  const double y = view.X_RC.translation.y + upright.distance.value * azimuth.sin;
  LandmarkPercept percept;
  percept.colour = colour;
  percept.bearing = atan2(y, x);
  percept.distance = sqrt(x * x + y * y);
  percept.bearing_deviation = 0.01 + 1 / view.description->fx;
  percept.distance_deviation = upright.distance.deviation;
  percept.foot_seen = upright.foot_seen;
  list.push_back(percept);
  out.drawn.push_back({kind, view.camera, upright.lowest.u, upright.lowest.v, upright.half_width, percept.distance});
}

bool plausibleDistance(const Upright& upright) {
  return upright.distance.value > kNearest && upright.distance.value < kFarthest;
}

void examinePole(const PictureView& view, const ColourGrid& grid, const Stack& stack,
                 const client::FieldDescription& field, Percepts& out) {
  const std::optional<Upright> upright = measureUpright(view, grid, stack.span(), field.pole_radius);
  if (!upright || !plausibleDistance(*upright)) return;
  const auto colour = topColour(view, grid, stack, *upright, field.pole_height);
  if (colour) report(view, *upright, *colour, client::Percept::Kind::kPole, out.poles, out);
}

/// Both ends where a post's ends must be: on the ground and at the crossbar, unless something hides them.
bool endsLikePost(const PictureView& view, const Upright& upright, double goal_height) {
  const double tolerance = heightTolerance(upright) + 0.06;
  const double top = heightAt(view, upright, upright.highest), bottom = heightAt(view, upright, upright.lowest);
  const bool hidden_below = upright.below == Colour::kOther || upright.below == Colour::kMagenta ||
                            upright.below == Colour::kCyan || upright.below == Colour::kOrange;
  if (!upright.cut_above && abs(top - goal_height) > tolerance + 0.1) return false;
  if (!upright.cut_below && !hidden_below && abs(bottom) > tolerance) return false;
  return bottom < 0.6 * goal_height && bottom > -tolerance && top < goal_height + tolerance + 0.1;
}

void examinePost(const PictureView& view, const ColourGrid& grid, const Bar& bar, const client::FieldDescription& field,
                 Percepts& out) {
  if (bar.runs < 3 || bar.height() < 2.2 * bar.mean_width) return;
  const Bar* const bars[] = {&bar};
  const std::optional<Upright> upright = measureUpright(view, grid, bars, field.post_radius);
  if (!upright || !plausibleDistance(*upright) || !endsLikePost(view, *upright, field.goal_height)) return;
  report(view, *upright, landmarkColour(bar.colour), client::Percept::Kind::kPost, out.posts, out);
}

}  // namespace

void LandmarkFinder::find(const PictureView& view, const ColourGrid& grid, const client::FieldDescription& field,
                          Percepts& out) {
  const std::span<const Bar> bars = chainer_.chain(grid);
  for (const Bar& bar : bars) {
    if (bar.runs < 2) continue;
    const bool above = field.pole_radius > 0 && hasAnother(bar, bars, true);
    const Bar* lower = field.pole_radius > 0 ? below(bar, bars) : nullptr;
    if (!above && lower != nullptr && lower->runs > 1) {
      Stack stack{{&bar, lower, below(*lower, bars)}, 3};
      if (stack.bars[2] == nullptr || stack.bars[2]->runs < 2) stack.count = 2;
      examinePole(view, grid, stack, field, out);
    } else if (!above && lower == nullptr) {
      examinePost(view, grid, bar, field, out);
    }
  }
}

}  // namespace murosimf::controllers
