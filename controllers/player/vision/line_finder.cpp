#include "player/vision/line_finder.h"

#include <algorithm>

namespace murosimf::controllers {
namespace {

constexpr int kReach = 4;           ///< neighbours on each side
constexpr double kFarthest = 0.35;  ///< of them on the ground [m]: the centre circle is straight no farther than that

/// Straight line through points of the undistorted picture, by total least squares.
struct FittedLine {
  PlanePoint centre, direction;  ///< unit vector along it
  double deviation = 0;          ///< rms across it
  int count = 0;
};

class LineFit {
 public:
  void add(const PlanePoint& p) {
    ++n_;
    sa_ += p.a, sb_ += p.b, saa_ += p.a * p.a, sab_ += p.a * p.b, sbb_ += p.b * p.b;
  }
  FittedLine solve() const {
    const double a = sa_ / n_, b = sb_ / n_;
    const double aa = saa_ / n_ - a * a, ab = sab_ / n_ - a * b, bb = sbb_ / n_ - b * b;
    const double half = 0.5 * (aa - bb), root = sqrt(half * half + ab * ab), largest = 0.5 * (aa + bb) + root;
    // Eigenvector of the larger eigenvalue, from the better conditioned row.
    PlanePoint d = half >= 0 ? PlanePoint{largest - bb, ab} : PlanePoint{ab, largest - aa};
    const double length = sqrt(d.a * d.a + d.b * d.b);
    d = length > 0 ? PlanePoint{d.a / length, d.b / length} : PlanePoint{1, 0};
    return {{a, b}, d, sqrt(std::max(0.0, largest - 2 * root)), n_};
  }

 private:
  int n_ = 0;
  double sa_ = 0, sb_ = 0, saa_ = 0, sab_ = 0, sbb_ = 0;
};

/// How well b, on the scan after a, continues the same line; larger is worse, 1 or more is no match.
double mismatch(const Crossing& a, const Crossing& b, bool vertical, double spacing, double metres_per_pixel) {
  const double along = vertical ? abs(b.at.v - a.at.v) : abs(b.at.u - a.at.u);
  const double longer = std::max(a.pixels, b.pixels), shorter = std::min(a.pixels, b.pixels);
  if (longer > 1.6 * shorter + 2.5) return 1;
  const double reach = std::max(3 * spacing, 0.12 / metres_per_pixel);
  return along / std::min(reach, 8 * spacing);
}

FittedLine fitAround(const std::vector<Crossing>& crossings, const Crossing& crossing) {
  LineFit fit;
  fit.add(crossing.ray);
  auto addWhileNear = [&](int Crossing::*way) {
    int i = crossing.*way;
    for (int k = 0; k < kReach && i >= 0; ++k) {
      const Crossing& c = crossings[static_cast<std::size_t>(i)];
      if (squaredNorm(c.ground - crossing.ground) > kFarthest * kFarthest) return;
      fit.add(c.ray);
      i = c.*way;
    }
  };
  addWhileNear(&Crossing::previous);
  addWhileNear(&Crossing::next);
  return fit.solve();
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

void LineFinder::find(const PictureView& view, double line_width, Percepts& out) {
  scanner_.scan(view, line_width);
  linkNeighbours(view);
  points_.clear();
  const double pixel = 1 / view.description->fx;
  for (const Crossing& c : scanner_.crossings()) {
    const FittedLine line = fitAround(scanner_.crossings(), c);
    if (line.count < 4 || line.deviation > 0.7 * pixel) continue;
    const auto ground = onGround(view, line, c.ray);
    if (!ground) continue;
    const double width = abs(dot(c.across, ground->normal)), blur = 1.2 * norm(c.across) / std::max(c.pixels, 0.5);
    const double share = width / std::max(1e-6, norm(c.across));
    if (width < 0.5 * line_width - blur * share || width > 1.6 * line_width + blur * share || share < 0.25) continue;
    const double distance = horizontal(ground->point);
    double normal = atan2(ground->normal.y, ground->normal.x);
    if (normal < 0) normal += kPi;
    points_.push_back({{ground->point.x, ground->point.y, normal},
                       {client::Percept::Kind::kLinePoint, view.camera, c.at.u, c.at.v, 0.5 * c.pixels, distance}});
  }
  const std::size_t stride = (points_.size() + kMostPoints - 1) / kMostPoints;
  for (std::size_t i = 0; i < points_.size(); i += std::max<std::size_t>(stride, 1)) {
    out.lines.push_back(points_[i].percept);
    out.drawn.push_back(points_[i].drawn);
  }
}

}  // namespace murosimf::controllers
