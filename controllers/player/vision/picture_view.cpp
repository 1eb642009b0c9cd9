#include "player/vision/picture_view.h"

namespace murosimf::controllers {
namespace {

int nearest(double x) { return static_cast<int>(x + 0.5); }

/// Walks along a line of the picture and reads the signal at the nearest pixels.
struct Walk {
  const PictureView& view;
  const Signal& signal;
  PixelPoint from;
  double du, dv;

  bool inside(int k) const {
    const double u = from.u + k * du, v = from.v + k * dv;
    return u > -0.5 && v > -0.5 && u < view.width - 0.5 && v < view.height - 0.5;
  }
  int level(int k) const { return signal.of(view.pixel(nearest(from.u + k * du), nearest(from.v + k * dv))); }
  PixelPoint at(double k) const { return {from.u + k * du, from.v + k * dv}; }
};

/// Place of the fall between step k - 2, still inside, and step k + 1, outside.
double crossing(const Walk& walk, int k) {
  const int first = k >= 2 ? k - 2 : 0;
  const double in = walk.level(first), out = walk.level(k + 1), middle = 0.5 * (in + out);
  double before = in;
  for (int i = first + 1; i <= k + 1; ++i) {
    const double now = walk.level(i);
    if (now <= middle) return i - 1 + (before > now ? (before - middle) / (before - now) : 0.5);
    before = now;
  }
  return k;
}

Edge edgeAt(const Walk& walk, int k) {
  Edge edge;
  edge.end = Edge::End::kFound;
  edge.at = walk.at(crossing(walk, k));
  const PixelPoint beyond = walk.at(walk.inside(k + 2) ? k + 2 : k + 1);
  edge.outside = walk.view.colour(nearest(beyond.u), nearest(beyond.v));
  return edge;
}

}  // namespace

Edge walkToEdge(const PictureView& view, const Signal& signal, PixelPoint from, double du, double dv, int reach) {
  const Walk walk{view, signal, from, du, dv};
  double mean = walk.level(0);
  for (int k = 1; k <= reach; ++k) {
    if (!walk.inside(k + 1)) return {Edge::End::kBorder, walk.at(k), Colour::kOther};
    const int level = walk.level(k);
    if (2 * level < mean && 2 * walk.level(k + 1) < mean) return edgeAt(walk, k);
    mean += 0.2 * (level - mean);  // follows the shading of a round body
  }
  return {};
}

}  // namespace murosimf::controllers
