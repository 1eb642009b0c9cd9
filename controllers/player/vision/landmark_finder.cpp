#include "player/vision/landmark_finder.h"

#include <algorithm>
#include <array>

#include "player/vision/upright.h"

namespace murosimf::controllers {
namespace {

constexpr double kNearest = 0.25;    ///< a landmark nearer than that would stand on the robot's feet [m]
constexpr double kLeastPost = 0.25;  ///< what must be seen of a post's height [m]

double squared(double x) { return x * x; }

constexpr std::size_t kMostFound = 16;

/// What has been found in this picture so far, of one kind.
struct Found {
  std::array<LandmarkPercept, kMostFound> percepts;
  std::array<client::Percept, kMostFound> drawn;
  std::size_t count = 0;
};

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
  return abs(upper.bottom_centre - lower.top_centre) < 0.4 * width + 0.5 && width < 1.5 * other + 1.5;
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
  const PixelPoint a = bottomOf(grid, upper), b = topOf(grid, lower);
  return {0.5 * (a.u + b.u), 0.5 * (a.v + b.v)};
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

LandmarkPercept perceptOf(const PictureView& view, const Upright& upright, LandmarkColour colour) {
  const SinCos<double> azimuth = sincos(upright.azimuth);
  const double x = view.X_RC.translation.x + upright.distance.value * azimuth.cos;
  const double y = view.X_RC.translation.y + upright.distance.value * azimuth.sin;
  LandmarkPercept percept;
  percept.colour = colour;
  percept.bearing = atan2(y, x);
  percept.distance = sqrt(x * x + y * y);
  percept.bearing_deviation = upright.azimuth_deviation;
  percept.distance_deviation = upright.distance.deviation;
  percept.foot_seen = upright.foot_seen;
  return percept;
}

/// Two parts of one post, for example above and below an arm before it.
bool sameThing(const LandmarkPercept& a, const LandmarkPercept& b) {
  return a.colour == b.colour && abs(wrapAngle(a.bearing - b.bearing)) < 0.03 + 0.05 / b.distance &&
         abs(a.distance - b.distance) < 0.15 * b.distance + a.distance_deviation + b.distance_deviation;
}

/// Adds a percept, unless this picture has given a better one of the same thing; a worse one is replaced.
void report(const PictureView& view, const Upright& upright, LandmarkColour colour, client::Percept::Kind kind,
            Found& found) {
  const LandmarkPercept percept = perceptOf(view, upright, colour);
  const client::Percept drawn{
      kind, view.camera, upright.lowest.u, upright.lowest.v, upright.half_width, percept.distance, percept.bearing};
  for (std::size_t i = 0; i < found.count; ++i) {
    if (!sameThing(found.percepts[i], percept)) continue;
    if (percept.distance_deviation < found.percepts[i].distance_deviation) {
      found.percepts[i] = percept;
      found.drawn[i] = drawn;
    }
    return;
  }
  if (found.count == kMostFound) return;
  found.percepts[found.count] = percept;
  found.drawn[found.count++] = drawn;
}

void append(const Found& found, std::vector<LandmarkPercept>& list, Percepts& out) {
  for (std::size_t i = 0; i < found.count; ++i) {
    list.push_back(found.percepts[i]);
    out.drawn.push_back(found.drawn[i]);
  }
}

/// A landmark cannot be farther away than the field's corners are from each other, and a little.
bool plausibleDistance(const Upright& upright, const client::FieldDescription& field) {
  const double x = field.length + 2 * field.border, y = field.width + 2 * field.border;
  return upright.distance.value > kNearest && squared(upright.distance.value) < 1.1 * (x * x + y * y);
}

/// Distance by the angle between two places of the axis that are `rise` apart; a tilt of the camera matters little.
Estimate byRise(const PictureView& view, const PixelPoint& upper, const PixelPoint& lower, double rise, double step) {
  const double slope = std::max(1e-3, slopeAt(view, upper) - slopeAt(view, lower));
  return {rise / slope, rise / slope * (0.02 + 0.4 * step / view.description->fy / slope)};
}

/// Whether a segment that shows from end to end is as high as the width says. Without such a segment only a foot that
/// goes with the width tells that nothing covers a side.
bool confirmed(const PictureView& view, const ColourGrid& grid, const Stack& stack, const Upright& upright,
               double pole_height) {
  if (upright.foot_seen) return true;
  const double rise = pole_height / 3;
  const PixelPoint joint = jointOf(grid, *stack.bars[0], *stack.bars[1]);
  if (!upright.cut_above) {
    return agree(byRise(view, upright.highest, joint, rise, grid.step()), upright.distance);
  }
  if (stack.count < 3) return false;
  const PixelPoint lower = jointOf(grid, *stack.bars[1], *stack.bars[2]);
  return agree(byRise(view, joint, lower, rise, grid.step()), upright.distance);
}

void examinePole(const Sight& sight, const Stack& stack, const client::FieldDescription& field, Found& poles) {
  const std::optional<Upright> upright = measureUpright(sight, stack.span(), field.pole_radius);
  if (!upright || !plausibleDistance(*upright, field)) return;
  if (!confirmed(sight.view, sight.grid, stack, *upright, field.pole_height)) return;
  const auto colour = topColour(sight.view, sight.grid, stack, *upright, field.pole_height);
  if (colour) report(sight.view, *upright, *colour, client::Percept::Kind::kPole, poles);
}

/// Distance by the top, just below the crossbar's middle; which is known to .06 m only.
Estimate byTop(const PictureView& view, const Upright& upright, double goal_height) {
  const double rise = goal_height - view.X_RC.translation.z, slope = slopeAt(view, upright.highest);
  if (rise < 0.05) return {upright.distance.value, 1e3};
  const double distance = rise / std::max(slope, 0.01);  // a top below the horizon is not a post's
  return {distance, groundDeviation(distance, rise, view.description->fx) + distance * 0.06 / rise};
}

/// Both ends where a post's ends must be: on the ground and at the crossbar, unless something hides them.
bool endsLikePost(const PictureView& view, const Upright& upright, double goal_height) {
  const double tolerance = heightTolerance(upright), bottom = heightAt(view, upright, upright.lowest);
  const bool hidden_below = upright.below == Colour::kOther || upright.below == Colour::kMagenta ||
                            upright.below == Colour::kCyan || upright.below == Colour::kOrange;
  if (!upright.cut_below && !hidden_below && abs(bottom) > tolerance) return false;
  const double top = heightAt(view, upright, upright.highest);
  return bottom < 0.6 * goal_height && bottom > -tolerance && top < goal_height + tolerance + 0.15 &&
         top - bottom > kLeastPost;
}

/// Whether the bar goes on above in the same colour at another width: then it is the lower part of a partly covered
/// post. The crossbar's runs are wider than it is high.
bool isLowerPart(const Bar& bar, std::span<const Bar> bars) {
  for (const Bar& other : bars) {
    if (&other == &bar || other.colour != bar.colour || other.runs < 3 || other.height() < other.mean_width) continue;
    const bool touches = other.bottom < bar.bottom && other.bottom >= bar.top - 3 && other.top < bar.top;
    const double apart = abs(other.bottom_centre - bar.top_centre);
    if (touches && apart < 0.5 * (other.mean_width + bar.mean_width) + 1) return true;
  }
  return false;
}

/// Whether the bar ends at the height of the crossbar, as exactly as its distance and an upright camera allow.
bool endsAtCrossbar(const PictureView& view, const Upright& upright, double goal_height) {
  const double error = abs(heightAt(view, upright, upright.highest) - goal_height);
  const double slope = abs(slopeAt(view, upright.highest));
  return error < 0.08 + 0.04 * upright.distance.value + 3 * slope * upright.distance.deviation;
}

/// Without a foot, nothing but the top tells whether the width is that of a whole post. With one the top may be a bad
/// measure still: where a bar goes on into another one before it reaches the crossbar.
bool weighTop(const Sight& sight, const Bar& bar, std::span<const Bar> bars, double goal_height, Upright& upright) {
  if (!upright.foot_seen && isLowerPart(bar, bars)) return false;
  if (upright.cut_above) return true;
  if (!endsAtCrossbar(sight.view, upright, goal_height)) return upright.foot_seen && upright.goes_on_above;
  upright.distance = fuse(upright.distance, byTop(sight.view, upright, goal_height));
  return true;
}

void examinePost(const Sight& sight, const Bar& bar, std::span<const Bar> all, const client::FieldDescription& field,
                 Found& posts) {
  if (bar.runs < 3 || bar.height() < 2.2 * bar.mean_width) return;
  const Bar* const bars[] = {&bar};
  std::optional<Upright> upright = measureUpright(sight, bars, field.post_radius);
  if (!upright || !plausibleDistance(*upright, field) || !endsLikePost(sight.view, *upright, field.goal_height)) return;
  if (!weighTop(sight, bar, all, field.goal_height, *upright)) return;
  report(sight.view, *upright, landmarkColour(bar.colour), client::Percept::Kind::kPost, posts);
}

}  // namespace

void LandmarkFinder::find(const PictureView& view, const ColourGrid& grid, const client::FieldDescription& field,
                          Percepts& out) {
  const std::span<const Bar> bars = chainer_.chain(view, grid);
  const Sight sight{view, grid, chainer_};
  Found posts, poles;
  for (const Bar& bar : bars) {
    if (bar.runs < 2) continue;
    const bool above = field.pole_radius > 0 && hasAnother(bar, bars, true);
    const Bar* lower = field.pole_radius > 0 ? below(bar, bars) : nullptr;
    if (!above && lower != nullptr && lower->runs > 1) {
      Stack stack{{&bar, lower, below(*lower, bars)}, 3};
      if (stack.bars[2] == nullptr || stack.bars[2]->runs < 2) stack.count = 2;
      examinePole(sight, stack, field, poles);
    } else if (!above && lower == nullptr) {
      examinePost(sight, bar, bars, field, posts);
    }
  }
  append(posts, out.posts, out);
  append(poles, out.poles, out);
}

}  // namespace murosimf::controllers
