#include "player/vision/line_finder.h"

#include <algorithm>

#include "player/vision/line_fit.h"

namespace murosimf::controllers {
namespace {

constexpr int kReach = 4;            ///< neighbours on each side
constexpr int kFewest = 4;           ///< points that make a line
constexpr double kShortest = 0.12;   ///< stretch of a line; the cross of a penalty mark is two widths long [m]
constexpr double kFarthestBent = 2;  ///< bends are told from corners up to there [m]
constexpr double kSpacing = 0.1;     ///< least distance on the ground between points that are reported [m]

/// How far from a crossing its neighbours may lie on the ground: the centre circle is straight for so long, as exactly
/// as can be seen at that distance.
double windowAt(double distance) {
  const double window = 0.1 + 0.08 * distance;
  return window < 0.35 ? window : 0.35;
}

/// How well b, on the scan after a, continues the same line; larger is worse, 1 or more is no match.
double mismatch(const Crossing& a, const Crossing& b, bool vertical, double spacing, double metres_per_pixel) {
  const double along = vertical ? abs(b.at.v - a.at.v) : abs(b.at.u - a.at.u);
  const double longer = std::max(a.pixels, b.pixels), shorter = std::min(a.pixels, b.pixels);
  if (longer > 1.6 * shorter + 2.5) return 1;
  const double reach = std::max(3 * spacing, 0.12 / metres_per_pixel);
  return along / std::min(reach, 8 * spacing);
}

/// Fits a crossing with neighbours on both sides, or on one of them.
class Neighbourhood {
 public:
  Neighbourhood(const std::vector<Crossing>& all, const Crossing& centre)
      : all_(all), centre_(centre), window_(windowAt(horizontal(centre.ground))) {}

  /// @param bent the tangent of a bent line instead of a straight one
  FittedLine fit(bool before, bool after, bool bent = false) const {
    LineFit line;
    line.add(centre_.ray);
    const Vector3 first = before ? add(line, &Crossing::previous) : centre_.ground;
    const Vector3 last = after ? add(line, &Crossing::next) : centre_.ground;
    FittedLine fitted = bent ? line.tangent() : line.straight();
    fitted.length = norm(last - first);
    return fitted;
  }

 private:
  /// Adds neighbours on one side, evenly over the window. @returns where the last of them lies on the ground
  Vector3 add(LineFit& line, int Crossing::*way) const {
    Vector3 last = centre_.ground;
    const double spacing = window_ / (kReach + 1);
    int added = 0;
    for (int i = centre_.*way; i >= 0 && added < kReach; i = all_[static_cast<std::size_t>(i)].*way) {
      const Crossing& c = all_[static_cast<std::size_t>(i)];
      if (squaredNorm(c.ground - centre_.ground) > window_ * window_) break;
      if (squaredNorm(c.ground - last) < spacing * spacing) continue;
      line.add(c.ray);
      last = c.ground;
      ++added;
    }
    return last;
  }

  const std::vector<Crossing>& all_;
  const Crossing& centre_;
  double window_;
};

/// The best line through a crossing: straight; bent, as the centre circle near by; or straight on one side only, where
/// lines meet.
std::optional<FittedLine> fitAround(const std::vector<Crossing>& crossings, const Crossing& crossing,
                                    double roughness) {
  const Neighbourhood neighbours(crossings, crossing);
  const FittedLine both = neighbours.fit(true, true);
  if (both.count < kFewest) return std::nullopt;
  if (both.deviation < roughness) return both;
  const FittedLine bent = neighbours.fit(true, true, true);
  if (bent.deviation < roughness && horizontal(crossing.ground) < kFarthestBent) return bent;
  const FittedLine before = neighbours.fit(true, false), after = neighbours.fit(false, true);
  const bool before_good = before.count >= kFewest && before.deviation < roughness;
  const bool after_good = after.count >= kFewest && after.deviation < roughness;
  if (before_good && (!after_good || before.deviation < after.deviation)) return before;
  return after_good ? std::optional(after) : std::nullopt;
}

/// The fitted line on the ground: its point beside the crossing, and its unit normal.
struct GroundLine {
  Vector3 point, normal;
};
std::optional<GroundLine> onGround(const PictureView& view, const FittedLine& line, const PlanePoint& at) {
  const double s = (at.a - line.centre.a) * line.direction.a + (at.b - line.centre.b) * line.direction.b;
  auto place = [&](double t) {
    const PlanePoint p{line.centre.a + t * line.direction.a, line.centre.b + t * line.direction.b};
    return view.meetPlane(view.direction(p), 0);
  };
  const auto here = place(s), before = place(s - 0.01), after = place(s + 0.01);
  if (!here || !before || !after) return std::nullopt;
  const Vector3 along = normalized(*after - *before);
  return GroundLine{*here, {-along.y, along.x, 0}};
}

}  // namespace

void LineFinder::start(int width, int height) {
  scanner_.start(width, height);
  points_.reserve(1024);
}

void LineFinder::linkNeighbours(const PictureView& view) {
  std::vector<Crossing>& all = scanner_.crossings();
  const double spacing_u = static_cast<double>(view.width) / scanner_.verticalScans();
  for (std::size_t begin = 0, i = 0; i < all.size(); ++i) {
    while (all[begin].scan < all[i].scan - 1) ++begin;
    const bool vertical = all[i].scan < scanner_.verticalScans();
    int best = -1;
    double best_mismatch = 1;
    for (std::size_t j = begin; all[j].scan < all[i].scan; ++j) {
      const double spacing = vertical ? spacing_u : abs(all[i].at.v - all[j].at.v);
      const double m = mismatch(all[j], all[i], vertical, spacing, scanner_.metresPerPixel(all[i]));
      if (m < best_mismatch && all[j].next < 0) best_mismatch = m, best = static_cast<int>(j);
    }
    if (best < 0) continue;
    all[i].previous = best;
    all[static_cast<std::size_t>(best)].next = static_cast<int>(i);
  }
}

bool LineFinder::measure(const PictureView& view, const Crossing& c, double line_width, Point& point) {
  const double distance = horizontal(c.ground);
  const auto line = fitAround(scanner_.crossings(), c, 0.8 / view.description->fx);
  if (!line || line->length < kShortest) return false;
  const auto ground = onGround(view, *line, c.ray);
  if (!ground) return false;
  const double length = norm(c.across), width = abs(dot(c.across, ground->normal));
  const double share = width / std::max(1e-6, length);  // sine of the angle between scan and line
  const double blur = 1.2 * length / std::max(c.pixels, 0.5) * share;
  if (width < 0.5 * line_width - blur || width > 1.6 * line_width + blur || share < 0.25) return false;
  const double normal = atan2(ground->normal.y, ground->normal.x);
  point.percept = {ground->point.x, ground->point.y, normal < 0 ? normal + kPi : normal};
  point.drawn = {client::Percept::Kind::kLinePoint, view.camera, c.at.u, c.at.v, 0.5 * c.pixels, distance,
                 atan2(c.ground.y, c.ground.x)};
  return true;
}

bool LineFinder::isCrowded(const LinePercept& p) const {
  return std::any_of(points_.begin(), points_.end(), [&](const Point& other) {
    const double dx = other.percept.x - p.x, dy = other.percept.y - p.y;
    return dx * dx + dy * dy < kSpacing * kSpacing;
  });
}

void LineFinder::find(const PictureView& view, double line_width, Percepts& out) {
  scanner_.scan(view, line_width);
  linkNeighbours(view);
  points_.clear();
  Point point;
  for (const Crossing& c : scanner_.crossings()) {
    if (measure(view, c, line_width, point) && !isCrowded(point.percept)) points_.push_back(point);
  }
  const std::size_t stride = std::max<std::size_t>((points_.size() + kMostPoints - 1) / kMostPoints, 1);
  for (std::size_t i = 0; i < points_.size(); i += stride) {
    out.lines.push_back(points_[i].percept);
    out.drawn.push_back(points_[i].drawn);
  }
}

}  // namespace murosimf::controllers
