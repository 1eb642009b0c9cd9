#include "murosimf/algorithms/collision/surface_feature.h"

namespace murosimf {
namespace {

/// Corner of a polygon that is being cut, named by the two edges that meet in it: edges of the polygon have the numbers
/// of their first corners, cuts kCut + the number of the cutting side.
struct CutCorner {
  Vector3 p;
  std::uint32_t in = 0, out = 0;
};
constexpr std::uint32_t kCut = 64;

struct CutPolygon {
  UnsetArray<CutCorner, 2 * SurfaceFeature::kMost> corners;
  int count = 0;
  void add(const Vector3& p, std::uint32_t in, std::uint32_t out) { corners[count++] = {p, in, out}; }
};

/// A side of a face as a plane parallel to n: inside is dot(normal, p) <= offset.
struct SidePlane {
  Vector3 normal;
  double offset;
  SidePlane(const SurfaceFeature& face, int side, const Vector3& outward) {
    const Vector3 &begin = face.points[side], &end = face.points[(side + 1) % face.count];
    normal = cross(end - begin, outward);
    offset = dot(normal, begin);
  }
  double height(const Vector3& p) const { return dot(normal, p) - offset; }
};

void startPolygon(const SurfaceFeature& face, CutPolygon& out) {
  out.count = 0;
  for (int i = 0; i < face.count; ++i)
    out.add(face.points[i], static_cast<std::uint32_t>(i == 0 ? face.count - 1 : i - 1), static_cast<std::uint32_t>(i));
}

void cut(const CutPolygon& from, const SidePlane& side, std::uint32_t name, CutPolygon& to) {
  to.count = 0;
  for (int i = 0; i < from.count; ++i) {
    const CutCorner &here = from.corners[i], &next = from.corners[i + 1 < from.count ? i + 1 : 0];
    const double h = side.height(here.p), h_next = side.height(next.p);
    if (h <= 0) to.corners[to.count++] = here;
    if ((h <= 0) == (h_next <= 0)) continue;
    const Vector3 crossing = interpolate(here.p, next.p, h / (h - h_next));
    if (h <= 0) {
      to.add(crossing, here.out, name);
    } else {
      to.add(crossing, name, here.out);
    }
  }
}

/// Candidates between a face and points of the other feature. `outward`: the direction along n that leads out of the
/// face's shape; the other's point overlaps by as much as it lies behind the face's plane in that direction.
class FaceDepths {
 public:
  FaceDepths(const SurfaceFeature& face, const Vector3& outward, std::uint32_t names, CandidatePoints& out)
      : face_(face), outward_(outward), per_height_(1 / dot(face.normal, outward)), names_(names), out_(out) {}
  void add(const Vector3& p, std::uint32_t in, std::uint32_t out) {
    const double depth = dot(face_.normal, face_.points[0] - p) * per_height_;
    out_.add(p + outward_ * (0.5 * depth), depth, names_ | in << 8 | out);
  }

 private:
  const SurfaceFeature& face_;
  Vector3 outward_;
  double per_height_;
  std::uint32_t names_;
  CandidatePoints& out_;
};

void betweenFaces(const SurfaceFeature& face, const SurfaceFeature& other, const Vector3& outward, FaceDepths& depths) {
  CutPolygon polygons[2];
  startPolygon(other, polygons[0]);
  int current = 0;
  for (int side = 0; side < face.count && polygons[current].count > 0; ++side) {
    cut(polygons[current], SidePlane(face, side, outward), kCut + static_cast<std::uint32_t>(side),
        polygons[1 - current]);
    current = 1 - current;
  }
  for (int i = 0; i < polygons[current].count; ++i) {
    const CutCorner& corner = polygons[current].corners[i];
    depths.add(corner.p, corner.in, corner.out);
  }
}

void betweenFaceAndLine(const SurfaceFeature& face, const SurfaceFeature& line, const Vector3& outward,
                        FaceDepths& depths) {
  double begin = 0, end = 1;
  std::uint32_t begin_name = 0, end_name = 1;
  for (int i = 0; i < face.count; ++i) {
    const SidePlane side(face, i, outward);
    const double h = side.height(line.points[0]), h_end = side.height(line.points[1]);
    if (h > 0 && h_end > 0) return;
    const double crossing = h / (h - h_end);
    const std::uint32_t name = kCut + static_cast<std::uint32_t>(i);
    if (h > 0 && crossing > begin) begin = crossing, begin_name = name;
    if (h_end > 0 && crossing < end) end = crossing, end_name = name;
  }
  if (begin >= end) return;
  depths.add(interpolate(line.points[0], line.points[1], begin), begin_name, 0);
  depths.add(interpolate(line.points[0], line.points[1], end), end_name, 1);
}

/// Both ends of what two parallel lines share, seen along the first.
void betweenLines(const SurfaceFeature& a, const SurfaceFeature& b, const Vector3& normal, std::uint32_t names,
                  CandidatePoints& out) {
  constexpr double kSine = 0.005;  // of 0.3 degrees: half a millimetre sideways on ten centimetres
  const Vector3 along_a = a.points[1] - a.points[0], along_b = b.points[1] - b.points[0];
  const double length_a = norm(along_a), length_b = norm(along_b);
  if (!(norm(cross(along_a, along_b)) < kSine * length_a * length_b)) return;
  const Vector3 direction = along_a * (1 / length_a);
  const double first = dot(direction, b.points[0] - a.points[0]), rise = dot(direction, along_b);
  const double low = max(0.0, rise > 0 ? first : first + rise);
  const double high = min(length_a, rise > 0 ? first + rise : first);
  if (low >= high) return;
  for (const double s : {low, high}) {
    const Vector3 p_a = plusScaled(a.points[0], direction, s),
                  p_b = plusScaled(b.points[0], along_b, (s - first) / rise);
    const std::uint32_t in = s <= 0 ? 0 : s >= length_a ? 1 : 2;
    out.add((p_a + p_b) * 0.5, dot(normal, p_b - p_a), names | in << 8 | (s > low ? 1U : 0U));
  }
}

/// The deepest overlap is exact; candidates near it are made to agree, and where none comes near it joins them.
void includeDeepest(const DeepestOverlap& overlap, CandidatePoints& candidates) {
  constexpr double kClose = 0.02, kAtLeast = 1e-6;  // of the depth; [m]
  int best = -1;
  for (int i = 0; i < candidates.count; ++i) {
    ContactPoint& p = candidates.points[i];
    p.depth = min(p.depth, overlap.depth);
    if (best < 0 || p.depth > candidates.points[best].depth) best = i;
  }
  if (best >= 0 && candidates.points[best].depth > (1 - kClose) * overlap.depth - kAtLeast) {
    candidates.points[best].depth = overlap.depth;
  } else {
    candidates.add(overlap.midpoint, overlap.depth, 0);
  }
}

}  // namespace

void pointsBetween(const SurfaceFeature& a, const SurfaceFeature& b, const DeepestOverlap& overlap,
                   ContactManifold& out) {
  const std::uint32_t names = (a.name & 0xffU) << 24 | (b.name & 0xffU) << 16;
  CandidatePoints candidates;
  if (a.count > 2 && b.count > 1) {
    FaceDepths depths(a, -out.normal, names, candidates);
    b.count > 2 ? betweenFaces(a, b, -out.normal, depths) : betweenFaceAndLine(a, b, -out.normal, depths);
  } else if (a.count == 2 && b.count > 2) {
    FaceDepths depths(b, out.normal, names, candidates);
    betweenFaceAndLine(b, a, out.normal, depths);
  } else if (a.count == 2 && b.count == 2) {
    betweenLines(a, b, out.normal, names, candidates);
  }
  includeDeepest(overlap, candidates);
  chooseFour(candidates, out);
}

}  // namespace murosimf
