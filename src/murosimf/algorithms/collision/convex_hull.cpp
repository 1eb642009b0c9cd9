#include "murosimf/algorithms/collision/convex_hull.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "murosimf/algorithms/collision/growing_hull.h"

namespace murosimf {
namespace {

constexpr double kKept = 1e-7;  // of the set's size: points that stand out by less are left away
constexpr double kFlat = 1e-6;  // of the set's size: triangles whose corners lie in one plane so far make one face

std::size_t at(int i) { return static_cast<std::size_t>(i); }

double sizeOf(std::span<const Vector3> points) {
  double size = 0;
  for (const Vector3& p : points) size = max(size, norm(p - points[0]));
  return size;
}

/// The number of the point for which `measure` is largest.
template <class Measure>
int farthest(std::span<const Vector3> points, Measure measure) {
  int best = 0;
  double most = measure(points[0]);
  for (int i = 1; i < static_cast<int>(points.size()); ++i) {
    const double value = measure(points[at(i)]);
    if (value > most) most = value, best = i;
  }
  return best;
}

void requireFinite(std::span<const Vector3> points) {
  if (points.size() < 4)
    throw std::invalid_argument("convex hull: found " + std::to_string(points.size()) + " points, expected 4 or more");
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!(squaredNorm(points[i]) < 1e300))
      throw std::invalid_argument("convex hull: point " + std::to_string(i) + " is no number, expected metres");
}

/// Four points that span a tetrahedron, each the farthest from what the ones before it span.
void requireSolid(std::span<const Vector3> points, double size, int (&corner)[4]) {
  const auto point = [&](int k) { return points[at(corner[k])]; };
  const auto require = [&](double extent, const char* what) {
    if (!(extent > kFlat * size))
      throw std::invalid_argument(std::string("convex hull: found ") + what + ", expected points that enclose a body");
  };
  require(size, "points that all coincide");
  corner[0] = farthest(points, [&](const Vector3& p) { return norm(p - points[0]); });
  corner[1] = farthest(points, [&](const Vector3& p) { return norm(p - point(0)); });
  const Vector3 along = normalized(point(1) - point(0));
  const auto fromLine = [&](const Vector3& p) { return norm(cross(p - point(0), along)); };
  corner[2] = farthest(points, fromLine);
  require(fromLine(point(2)), "points on one line");
  const Vector3 normal = normalized(cross(along, point(2) - point(0)));
  const auto fromPlane = [&](const Vector3& p) { return abs(dot(p - point(0), normal)); };
  corner[3] = farthest(points, fromPlane);
  require(fromPlane(point(3)), "points in one plane");
}

/// The surface while it is built.
struct Construction {
  explicit Construction(std::span<const Vector3> given)
      : points(given),
        size(sizeOf(given)),
        triangles(8 * given.size() + 16),
        rim(triangles.size()),
        free(triangles.size()),
        hull({points, triangles, rim, free}) {
    int corner[4] = {0, 0, 0, 0};
    requireSolid(points, size, corner);
    bool whole = hull.start(corner);
    for (int i = nextToGrow(0); whole && i >= 0; i = nextToGrow(0)) whole = growAt(i);
    if (!whole) throw std::invalid_argument("convex hull: points lie too close together for their distance");
  }

  int nextToGrow(int i) const {
    while (i < hull.used() && (!hull.triangle(i).alive || hull.triangle(i).thin || hull.triangle(i).done)) ++i;
    return i < hull.used() ? i : -1;
  }
  bool growAt(int i) {
    HullTriangle& t = hull.triangle(i);
    const Vector3 normal = t.normal;
    const int p = farthest(points, [&](const Vector3& q) { return dot(normal, q); });
    if (dot(normal, points[at(p)]) - t.offset > kKept * size) return hull.add(p, i, 1e-14 * size);
    t.done = true;
    return true;
  }

  std::span<const Vector3> points;
  double size;
  std::vector<HullTriangle> triangles;
  std::vector<HullRim> rim;
  std::vector<int> free;
  GrowingHull hull;
};

/// Joins triangles of one plane, beginning with the largest, and reads off their outlines.
class FaceMerger {
 public:
  FaceMerger(const Construction& built, std::vector<ConvexHull::Face>& faces, std::vector<int>& corners)
      : built_(built), hull_(built.hull), group_(at(hull_.used()), -1), faces_(faces), corners_(corners) {
    std::vector<int> order;
    for (int i = 0; i < hull_.used(); ++i)
      if (hull_.triangle(i).alive) order.push_back(i);
    std::stable_sort(order.begin(), order.end(), [this](int i, int k) { return area(i) > area(k); });
    for (const int i : order)
      if (group_[at(i)] < 0) addFace(i);
  }

 private:
  double area(int i) const {
    const HullTriangle& t = hull_.triangle(i);
    const Vector3& a = hull_.point(t.vertex[0]);
    return norm(cross(hull_.point(t.vertex[1]) - a, hull_.point(t.vertex[2]) - a));
  }
  bool inPlane(int i, const HullTriangle& seed) const {
    const HullTriangle& t = hull_.triangle(i);
    for (const int v : t.vertex)
      if (abs(dot(seed.normal, hull_.point(v)) - seed.offset) > kFlat * built_.size) return false;
    return t.thin || dot(t.normal, seed.normal) > 0.9;
  }
  void addFace(int seed) {
    const int number = static_cast<int>(faces_.size());
    std::vector<int> members{seed};
    group_[at(seed)] = number;
    for (std::size_t k = 0; k < members.size(); ++k)
      for (const int next : hull_.triangle(members[k]).neighbour)
        if (group_[at(next)] < 0 && inPlane(next, hull_.triangle(seed))) {
          group_[at(next)] = number;
          members.push_back(next);
        }
    ConvexHull::Face face;
    face.normal = hull_.triangle(seed).normal;
    face.first = static_cast<int>(corners_.size());
    readOutline(members, number);
    face.count = static_cast<int>(corners_.size()) - face.first;
    faces_.push_back(face);
  }
  bool isOutline(int i, int edge, int number) const { return group_[at(hull_.triangle(i).neighbour[edge])] != number; }
  void readOutline(const std::vector<int>& members, int number) {
    int i = -1, edge = 0;
    for (const int m : members)
      for (int k = 0; k < 3 && i < 0; ++k)
        if (isOutline(m, k, number)) i = m, edge = k;
    const int begin = i, begin_edge = edge;
    do {
      corners_.push_back(hull_.triangle(i).vertex[edge]);
      edge = (edge + 1) % 3;
      while (!isOutline(i, edge, number)) {  // cross into the neighbour and go on around the same corner
        const int next = hull_.triangle(i).neighbour[edge];
        int back = 0;
        while (hull_.triangle(next).neighbour[back] != i) ++back;
        i = next, edge = (back + 1) % 3;
      }
    } while (i != begin || edge != begin_edge);
  }

  const Construction& built_;
  const GrowingHull& hull_;
  std::vector<int> group_;
  std::vector<ConvexHull::Face>& faces_;
  std::vector<int>& corners_;
};

}  // namespace

ConvexHull::ConvexHull(std::span<const Vector3> points) {
  requireFinite(points);
  const Construction built(points);
  const FaceMerger merged(built, faces_, corners_);
  keepUsedVertices(points);
  for (Face& face : faces_) {
    face.offset = dot(face.normal, vertex(corners(face)[0]));
    for (const Vector3& v : vertices_) face.offset = max(face.offset, dot(face.normal, v));
  }
  linkNeighbours();
}

void ConvexHull::keepUsedVertices(std::span<const Vector3> points) {
  std::vector<int> number(points.size(), -1);
  for (int& corner : corners_) {
    int& mine = number[at(corner)];
    if (mine < 0) {
      mine = static_cast<int>(vertices_.size());
      vertices_.push_back(points[at(corner)]);
    }
    corner = mine;
  }
  for (const Vector3& v : vertices_) {
    centre_ += v * (1 / static_cast<double>(vertices_.size()));
    bounding_radius_ = max(bounding_radius_, norm(v));
  }
}

void ConvexHull::linkNeighbours() {
  std::vector<std::vector<std::pair<int, int>>> next(
      vertices_.size());  // the neighbour, the face left of the way there
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    const auto loop = corners(faces_[f]);
    for (std::size_t i = 0; i < loop.size(); ++i)
      next[at(loop[i])].emplace_back(loop[(i + 1) % loop.size()], static_cast<int>(f));
  }
  for (const auto& list : next) {
    first_of_vertex_.push_back(static_cast<int>(neighbours_.size()));
    for (const auto& [neighbour, face] : list) neighbours_.push_back(neighbour), faces_around_.push_back(face);
  }
  first_of_vertex_.push_back(static_cast<int>(neighbours_.size()));
}

int ConvexHull::farthestVertex(const Vector3& d) const {
  constexpr std::size_t kSmall = 40;
  int best = 0;
  double most = dot(d, vertices_[0]);
  if (vertices_.size() <= kSmall) {
    for (int i = 1; i < static_cast<int>(vertices_.size()); ++i) {
      const double height = dot(d, vertex(i));
      if (height > most) most = height, best = i;
    }
    return best;
  }
  for (bool higher = true; higher;) {
    higher = false;
    for (const int i : neighbours(best)) {
      const double height = dot(d, vertex(i));
      if (height > most) most = height, best = i, higher = true;
    }
  }
  return best;
}

}  // namespace murosimf
