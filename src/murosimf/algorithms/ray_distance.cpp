#include "murosimf/algorithms/ray_distance.h"

#include <limits>

#include "murosimf/math/elementary.h"

namespace murosimf {

namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// A stretch of a ray; empty where it ends before it begins.
struct Stretch {
  double begin = -kNever, end = kNever;
  bool empty() const { return begin > end; }
  void cut(const Stretch& other) { begin = max(begin, other.begin), end = min(end, other.end); }
  double first() const { return empty() || end < 0 ? kNever : max(begin, 0.0); }
};

/// Where |p + t d| <= half on one axis.
Stretch slab(double p, double d, double half) {
  if (d == 0) return abs(p) <= half ? Stretch{} : Stretch{1, 0};
  const double a = (-half - p) / d, b = (half - p) / d;
  return {min(a, b), max(a, b)};
}

/// Where a t^2 + 2 b t + c <= 0. The discriminant comes from the caller, who may know it better than b^2 - a c.
Stretch below(double a, double b, double discriminant) {
  if (discriminant < 0) return {1, 0};
  const double root = sqrt(discriminant);
  return {(-b - root) / a, (-b + root) / a};
}

Stretch inSphere(const Vector3& p, const Vector3& d, double radius) {
  const double a = dot(d, d), b = dot(p, d);
  const Vector3 nearest = p - d * (b / a);
  return below(a, b, a * (radius * radius - dot(nearest, nearest)));
}

Stretch inTube(const Vector3& p, const Vector3& d, double radius) {
  const double a = d.x * d.x + d.y * d.y, out = p.x * p.x + p.y * p.y;
  if (a == 0) return out <= radius * radius ? Stretch{} : Stretch{1, 0};
  const double b = p.x * d.x + p.y * d.y, miss = p.x * d.y - p.y * d.x;
  return below(a, b, a * radius * radius - miss * miss);
}

double toBox(const Vector3& half, const Vector3& p, const Vector3& d) {
  Stretch inside = slab(p.x, d.x, half.x);
  inside.cut(slab(p.y, d.y, half.y));
  inside.cut(slab(p.z, d.z, half.z));
  return inside.first();
}

double toCapsule(const Vector3& half, const Vector3& p, const Vector3& d) {
  Stretch side = inTube(p, d, half.x);
  side.cut(slab(p.z, d.z, half.z));
  double nearest = side.first();
  for (const double end : {-half.z, half.z})
    nearest = min(nearest, inSphere(p - Vector3{0, 0, end}, d, half.x).first());
  return nearest;
}

/// Of triangle k of a group.
double toTriangle(const CastTriangles& group, int k, const Vector3& p, const Vector3& d) {
  const auto corner = [&](int i) {
    return Vector3{group.corner[i][0][k], group.corner[i][1][k], group.corner[i][2][k]};
  };
  const Vector3 a = corner(0), u = corner(1) - a, v = corner(2) - a;
  const Vector3 h = cross(d, v);
  const double det = dot(u, h);
  if (det == 0) return kNever;
  const Vector3 s = p - a, q = cross(s, u);
  const double x = dot(s, h) / det, y = dot(d, q) / det, t = dot(v, q) / det;
  return x >= 0 && y >= 0 && x + y <= 1 && t >= 0 ? t : kNever;
}

/// Where the ray enters child k's box.
double toChild(const CastMeshNode& node, int k, const Vector3& p, const Vector3& d) {
  constexpr double kSlack = 1e-6;  // [m], of boxes kept as floats
  if (node.low[0][k] > node.high[0][k]) return kNever;
  const double origin[3] = {p.x, p.y, p.z}, way[3] = {d.x, d.y, d.z};
  Stretch inside;
  for (int i = 0; i < 3; ++i) {
    const double low = node.low[i][k], high = node.high[i][k];
    inside.cut(slab(origin[i] - 0.5 * (low + high), way[i], 0.5 * (high - low) + kSlack));
  }
  return inside.first();
}

}  // namespace

double rayDistance(const Shape& shape, const Vector3& p, const Vector3& d) {
  const Vector3& half = shape.half_size;
  switch (shape.kind) {
    case ShapeKind::kBox:
    case ShapeKind::kConvex:
      return toBox(half, p, d);
    case ShapeKind::kCapsule:
      return toCapsule(half, p, d);
    case ShapeKind::kCylinder: {
      Stretch inside = inTube(p, d, half.x);
      inside.cut(slab(p.z, d.z, half.z));
      return inside.first();
    }
    case ShapeKind::kEllipsoid:
      break;
  }
  return inSphere({p.x / half.x, p.y / half.y, p.z / half.z}, {d.x / half.x, d.y / half.y, d.z / half.z}, 1).first();
}

double rayDistance(const TriangleMesh& mesh, const Vector3& p, const Vector3& d) {
  const CastMesh& cast = mesh.cast();
  std::int32_t waiting[kMeshStack];
  int count = 0;
  double nearest = kNever;
  waiting[count++] = 0;
  while (count > 0) {
    const std::int32_t next = waiting[--count];
    if (next >= 0) {
      const CastMeshNode& node = cast.nodes[next];
      for (int k = 0; k < kMeshWidth; ++k) {
        if (toChild(node, k, p, d) < nearest) waiting[count++] = node.child[k];
      }
      continue;
    }
    for (int k = 0; k < kMeshWidth; ++k) nearest = min(nearest, toTriangle(cast.groups[~next], k, p, d));
  }
  return nearest;
}

}  // namespace murosimf
