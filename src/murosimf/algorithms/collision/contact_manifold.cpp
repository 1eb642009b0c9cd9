#include "murosimf/algorithms/collision/contact_manifold.h"

namespace murosimf {
namespace {

/// The candidate for which `measure` is largest, -1 if it exceeds `least` nowhere. Of candidates that are equal within
/// `equal` the first one is taken, so that rounding does not choose between the corners of a regular face.
template <class Measure>
int best(const CandidatePoints& candidates, double equal, double least, Measure measure) {
  int chosen = -1;
  double most = least;
  for (int i = 0; i < candidates.count; ++i) {
    const double value = measure(candidates.points[i]);
    if (value > most * (1 + equal)) most = value, chosen = i;
  }
  return chosen;
}

constexpr double kEqualDepth = 1e-10, kEqualPlace = 1e-6;
constexpr double kSamePlace = 1e-9;  // [m]
constexpr double kNoArea = 1e-6;     // of the square of the longest side

}  // namespace

void CandidatePoints::add(const Vector3& position, double depth, std::uint32_t feature) {
  if (!(depth > 0) || count == kMost) return;
  for (int i = 0; i < count; ++i) {
    if (squaredNorm(points[i].position - position) > kSamePlace * kSamePlace) continue;
    points[i].depth = max(points[i].depth, depth);
    return;
  }
  points[count++] = {position, depth, feature};
}

void chooseFour(const CandidatePoints& candidates, ContactManifold& out) {
  out.count = 0;
  const auto take = [&](int i) {
    if (i >= 0) out.points[out.count++] = candidates.points[i];
  };
  if (candidates.count <= 4) {
    for (int i = 0; i < candidates.count; ++i) take(i);
    return;
  }
  take(best(candidates, kEqualDepth, 0, [](const ContactPoint& p) { return p.depth; }));
  const Vector3 a = out.points[0].position;
  take(best(candidates, kEqualPlace, 0, [&](const ContactPoint& p) { return squaredNorm(p.position - a); }));
  if (out.count < 2) return;
  const Vector3 b = out.points[1].position, side = cross(out.normal, b - a);
  const double no_area = kNoArea * squaredNorm(b - a);
  const auto height = [&](const ContactPoint& p) { return dot(side, p.position - a); };
  take(best(candidates, kEqualPlace, no_area, [&](const ContactPoint& p) { return abs(height(p)); }));
  if (out.count < 3) return;
  // The fourth point lies beyond one of the triangle's edges. Twice the area that it adds there:
  const Vector3 c = out.points[2].position;
  const double turn = height(out.points[2]) > 0 ? 1.0 : -1.0;
  const auto beyond = [&](const Vector3& from, const Vector3& to, const Vector3& p) {
    return -turn * dot(out.normal, cross(to - from, p - from));
  };
  take(best(candidates, kEqualPlace, no_area, [&](const ContactPoint& p) {
    return max(beyond(a, b, p.position), max(beyond(b, c, p.position), beyond(c, a, p.position)));
  }));
}

}  // namespace murosimf
