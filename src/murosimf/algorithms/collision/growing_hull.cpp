#include "murosimf/algorithms/collision/growing_hull.h"

#include <limits>

namespace murosimf {
namespace {

constexpr double kThin = 1e-9;  // sine of the angle below which corners count as lying on one line

int edgeTowards(const HullTriangle& t, int neighbour) {
  return t.neighbour[0] == neighbour ? 0 : t.neighbour[1] == neighbour ? 1 : 2;
}

}  // namespace

bool GrowingHull::setPlane(HullTriangle& t) const {
  const Vector3 &a = point(t.vertex[0]), ab = point(t.vertex[1]) - a, ac = point(t.vertex[2]) - a;
  const Vector3 across = cross(ab, ac);
  const double area = norm(across);
  t.thin = !(area > kThin * (squaredNorm(ab) + squaredNorm(ac)));
  if (t.thin) return false;
  t.normal = across * (1 / area);
  t.offset = dot(t.normal, a);
  return true;
}

bool GrowingHull::start(const int (&corner)[4]) {
  constexpr int kCorners[4][3] = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};
  constexpr int kNeighbours[4][3] = {{1, 2, 3}, {3, 2, 0}, {1, 3, 0}, {2, 1, 0}};
  int c[4] = {corner[0], corner[1], corner[2], corner[3]};
  const Vector3 base = cross(point(c[1]) - point(c[0]), point(c[2]) - point(c[0]));
  if (dot(base, point(c[3]) - point(c[0])) > 0) c[1] = corner[2], c[2] = corner[1];
  used_ = 4, free_ = 0;
  bool solid = true;
  for (int i = 0; i < 4; ++i) {
    HullTriangle& t = triangle(i) = {};
    t.alive = true;
    for (int k = 0; k < 3; ++k) t.vertex[k] = c[kCorners[i][k]], t.neighbour[k] = kNeighbours[i][k];
    solid = setPlane(t) && solid;
  }
  return solid;
}

void GrowingHull::remove(int i) {
  triangle(i).alive = false;
  triangle(i).offset = std::numeric_limits<double>::infinity();
  memory_.free[static_cast<std::size_t>(free_++)] = i;
}

// Enters triangle `from` over one of its edges; both other edges follow in their order around the hole.
bool GrowingHull::walk(int from, int edge, const Vector3& p, double tolerance) {
  const HullTriangle& t = triangle(from);
  if (!t.alive) return true;
  if (!(dot(t.normal, p) - t.offset > tolerance)) {
    if (rim_ == static_cast<int>(memory_.rim.size())) return false;
    rim(rim_++) = {from, edge};
    return true;
  }
  remove(from);
  for (int k = 1; k < 3; ++k) {
    const int next = t.neighbour[(edge + k) % 3];
    if (!walk(next, edgeTowards(triangle(next), from), p, tolerance)) return false;
  }
  return true;
}

bool GrowingHull::rimIsClosed() {
  if (rim_ < 3) return false;
  for (int i = 0; i < rim_; ++i) {
    const HullRim &here = rim(i), &next = rim((i + 1) % rim_);
    const int end = triangle(here.outside).vertex[here.edge];
    const int begin = triangle(next.outside).vertex[(next.edge + 1) % 3];
    if (end != begin || !triangle(here.outside).alive) return false;
  }
  return true;
}

int GrowingHull::place() {
  if (free_ > 0) return memory_.free[static_cast<std::size_t>(--free_)];
  return used_ < static_cast<int>(memory_.triangles.size()) ? used_++ : -1;
}

bool GrowingHull::coverHole(int point) {
  int first = -1, last = -1;
  for (int i = 0; i < rim_; ++i) {
    const int here = place();
    if (here < 0) return false;
    HullTriangle& outside = triangle(rim(i).outside);
    HullTriangle& t = triangle(here) = {};
    t.alive = true;
    t.vertex[0] = outside.vertex[(rim(i).edge + 1) % 3];
    t.vertex[1] = outside.vertex[rim(i).edge];
    t.vertex[2] = point;
    t.neighbour[0] = rim(i).outside;
    outside.neighbour[rim(i).edge] = here;
    if (!setPlane(t)) t.normal = outside.normal, t.offset = outside.offset;
    if (last >= 0) triangle(last).neighbour[1] = here, t.neighbour[2] = last;
    if (first < 0) first = here;
    last = here;
  }
  triangle(last).neighbour[1] = first;
  triangle(first).neighbour[2] = last;
  return true;
}

bool GrowingHull::add(int number, int seen, double tolerance) {
  const HullTriangle start = triangle(seen);
  rim_ = 0;
  remove(seen);
  for (int k = 0; k < 3; ++k) {
    const int next = start.neighbour[k];
    if (!walk(next, edgeTowards(triangle(next), seen), point(number), tolerance)) return false;
  }
  return rimIsClosed() && coverHole(number);
}

}  // namespace murosimf
