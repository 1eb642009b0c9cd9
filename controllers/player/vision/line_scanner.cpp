#include "player/vision/line_scanner.h"

#include <algorithm>
#include <array>

namespace murosimf::controllers {
namespace {

constexpr std::size_t kMostCrossings = 1024;
constexpr double kFarthest = 5.0;      ///< lines beyond are thinner than half a pixel [m]
constexpr int kLongestCrossing = 200;  ///< [pixels]

int brightness(const std::uint8_t* rgb) { return rgb[0] + rgb[2]; }

/// Lowest row of this column at which the ground is still farther than kFarthest: bisection, distance grows upwards.
int topRow(const PictureView& view, int u) {
  auto near = [&](int v) {
    const auto p = view.ground(u, v);
    return p && horizontal(*p - view.X_RC.translation) < kFarthest;
  };
  int high = -1, low = view.height - 1;
  if (!near(low)) return view.height;
  while (low - high > 1) {
    const int middle = (low + high) / 2;
    (near(middle) ? low : high) = middle;
  }
  return low;
}

}  // namespace

void GroundScale::measure(const PictureView& view) {
  const double u = 0.5 * view.width;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const double v = (static_cast<double>(i) + 0.5) * kSpacing;
    const auto p = view.ground(u, v), below = view.ground(u, v + 1), right = view.ground(u + 1, v);
    rows_[i] = p && below && right ? Scale{norm(*below - *p), norm(*right - *p)} : Scale{1, 1};
  }
}

/// A straight scan: pixel k is (u + k du, v + k dv), 0 <= k < count.
struct LineScanner::Path {
  int u, v, du, dv, count, scan;
  const std::uint8_t* pixel(const PictureView& view, int k) const { return view.pixel(u + k * du, v + k * dv); }
  int row(int k) const { return v + k * dv; }
};

void LineScanner::start(int width, int height) {
  scale_.start(height);
  crossings_.reserve(kMostCrossings);
  vertical_scans_ = width >= 480 ? width / 8 : width / 6;
}

double LineScanner::metresPerPixel(const Crossing& c) const {
  const GroundScale::Scale& scale = scale_.at(static_cast<int>(c.at.v));
  return c.scan < vertical_scans_ ? scale.along_v : scale.along_u;
}

int LineScanner::stepAt(const Path& path, int k, double line_width) const {
  const GroundScale::Scale& scale = scale_.at(path.row(k));
  const double covered = line_width / (path.dv != 0 ? scale.along_v : scale.along_u);
  return covered < 5 ? 1 : covered < 20 ? static_cast<int>(0.4 * covered) : 8;
}

void LineScanner::scan(const PictureView& view, double line_width) {
  crossings_.clear();
  scale_.measure(view);
  int scan = 0;
  for (; scan < vertical_scans_; ++scan) {
    const int u = scan * view.width / vertical_scans_ + view.width / vertical_scans_ / 2, top = topRow(view, u);
    scanPath(view, {u, view.height - 1, 0, -1, view.height - top, scan}, line_width);
  }
  ++scan;  // no neighbour of the last vertical one
  const int top = std::max(std::min(topRow(view, 0), topRow(view, view.width - 1)), 0);
  for (int v = view.height - 3; v > top; ++scan) {
    scanPath(view, {0, v, 1, 0, view.width, scan}, line_width);
    v -= std::clamp(static_cast<int>(0.06 / scale_.at(v).along_v), view.width >= 480 ? 6 : 4, 24);
  }
}

/// Looks for stretches without green between two green places.
void LineScanner::scanPath(const PictureView& view, const Path& path, double line_width) {
  int last_green = -1, highest = 0;
  bool coloured = false;
  for (int k = 0; k < path.count; k += stepAt(path, k, line_width)) {
    const std::uint8_t* p = path.pixel(view, k);
    if (isGreen(p, view.colours)) {
      const bool bright = 3 * highest > 4 * view.colours.green_level;  // below that no line of any thickness
      if (last_green >= 0 && bright && !coloured && k - last_green < kLongestCrossing) {
        addCrossing(view, path, last_green, k, line_width);
      }
      last_green = k;
      highest = 0;
      coloured = false;
    } else if (last_green >= 0) {
      highest = std::max(highest, brightness(p));
      coloured = coloured || 4 * std::abs(p[0] - p[2]) > brightness(p) + 24;
    }
  }
}

void LineScanner::addCrossing(const PictureView& view, const Path& path, int last_green, int next_green,
                              double line_width) {
  auto level = [&](int k) { return brightness(path.pixel(view, k)); };
  int peak = 0, peak_at = last_green;
  for (int k = last_green; k <= next_green; ++k) {
    if (level(k) > peak) peak = level(k), peak_at = k;
  }
  // Level of the carpet on this scan, from up to three pixels on the sure side.
  auto carpet = [&](int k, int way) {
    int sum = 0, count = 0;
    for (int i = k; count < 3 && i >= 0 && i < path.count; i += way, ++count) sum += level(i);
    return static_cast<double>(sum) / count;
  };
  auto edge = [&](int k, int way) {
    const double middle = 0.5 * (carpet(k, -way) + peak);
    while (k != peak_at && level(k) < middle) k += way;
    const double now = level(k), before = k - way >= 0 && k - way < path.count ? level(k - way) : now;
    const double back = now > before ? (now - middle) / (now - before) : 0.5;
    return k - way * std::clamp(back, 0.0, 1.0);
  };
  const double first = edge(last_green, 1), last = edge(next_green, -1);
  const double pixels = last - first;
  // A line wide enough to have an unmixed middle must be as bright as white paint.
  const double white = 2 * std::min(255.0, 1.96 * view.colours.green_level), ground = carpet(last_green, -1);
  if (pixels >= 3 && peak < ground + 0.72 * (white - ground)) return;
  if (peak < ground + 0.3 * (white - ground) || crossings_.size() == kMostCrossings) return;

  Crossing c;
  const double middle = 0.5 * (first + last);
  c.at = {path.u + middle * path.du, path.v + middle * path.dv};
  const auto p = view.ground(path.u + first * path.du, path.v + first * path.dv);
  const auto q = view.ground(path.u + last * path.du, path.v + last * path.dv);
  if (!p || !q) return;
  c.ground = (*p + *q) * 0.5;
  c.across = *q - *p;
  if (squaredNorm(c.across) > 36 * line_width * line_width) return;
  c.ray = view.rays->ray(c.at.u, c.at.v);
  c.pixels = pixels;
  c.scan = path.scan;
  crossings_.push_back(c);
}

}  // namespace murosimf::controllers
