#pragma once

/// @file A closed surface of triangles about points, which grows point by point and stays convex.
///
/// Used to build hulls of meshes and to search the least depth of two shapes. Memory is the caller's, so that the
/// search allocates nothing. Triangles know their three neighbours; a new point replaces the triangles that it sees by
/// a fan over their rim. The walk over the seen triangles meets the rim's edges in their order
/// [van den Bergen 2003, 4.3.8].

#include <span>

#include "murosimf/math/vec3.h"

namespace murosimf {

struct HullTriangle {
  int vertex[3] = {0, 0, 0};     ///< counterclockwise seen from outside
  int neighbour[3] = {0, 0, 0};  ///< [i] lies beyond the edge from vertex[i] to vertex[(i + 1) % 3]
  Vector3 normal;                ///< outward, unit length
  double offset = 0;             ///< n.p of its points [m]; infinite for triangles that are gone
  bool alive = false;
  bool thin = false;  ///< corners on one line: has no plane of its own and takes its neighbour's
  bool done = false;  ///< free for the caller
};

/// An edge of the hole that a new point tears.
struct HullRim {
  int outside = 0, edge = 0;  ///< a triangle that stays, and which of its edges faces the hole
};

/// A point's place is its number. Points may be filled in while the hull grows. The three others have equal sizes:
/// 2 * points - 4 triangles suffice, and a few more are needed on the way.
struct HullMemory {
  std::span<const Vector3> points;
  std::span<HullTriangle> triangles;
  std::span<HullRim> rim;
  std::span<int> free;
};

class GrowingHull {
 public:
  explicit GrowingHull(const HullMemory& memory) : memory_(memory) {}

  /// Starts with the tetrahedron of four points. @return false if they lie in a plane
  bool start(const int (&corner)[4]);
  /// Adds a point that lies above triangle `seen`. Triangles above whose planes it lies by no more than `tolerance` [m]
  /// stay. @return false if memory is used up or rounding has torn the surface, which then is useless
  bool add(int point, int seen, double tolerance);

  /// Triangles below this number may be alive.
  int used() const { return used_; }
  const HullTriangle& triangle(int i) const { return memory_.triangles[static_cast<std::size_t>(i)]; }
  HullTriangle& triangle(int i) { return memory_.triangles[static_cast<std::size_t>(i)]; }
  const Vector3& point(int i) const { return memory_.points[static_cast<std::size_t>(i)]; }

 private:
  HullRim& rim(int i) { return memory_.rim[static_cast<std::size_t>(i)]; }
  bool setPlane(HullTriangle& t) const;
  void remove(int i);
  bool walk(int from, int edge, const Vector3& point, double tolerance);
  bool rimIsClosed();
  bool coverHole(int point);
  int place();

  HullMemory memory_;
  int used_ = 0, free_ = 0, rim_ = 0;
};

}  // namespace murosimf
