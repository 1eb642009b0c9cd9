#pragma once

/// @file The convex hull of points: vertices, flat faces and neighbours, built once and then only read.
///
/// Built by adding, face by face, the point that lies farthest outside [Barber, Dobkin, Huhdanpaa 1996]. Points
/// that stand out by less than 1e-7 of the set's size are left away; triangles that lie in one plane within 1e-6 of it
/// become one face. Cost of building: O(points * vertices).

#include <span>
#include <vector>

#include "murosimf/math/vec3.h"

namespace murosimf {

class ConvexHull {
 public:
  /// The part of space behind a face is n.p <= offset; every vertex lies there.
  struct Face {
    Vector3 normal;     ///< outward, unit length
    double offset = 0;  ///< [m]
    int first = 0;      ///< of its corners in corners()
    int count = 0;      ///< of corners, counterclockwise seen from outside
  };

  /// @throws std::invalid_argument for fewer than 4 points, points that are no numbers, or points in one plane.
  explicit ConvexHull(std::span<const Vector3> points);

  const std::vector<Vector3>& vertices() const { return vertices_; }
  const std::vector<Face>& faces() const { return faces_; }
  /// Numbers of the vertices that are a face's corners.
  std::span<const int> corners(const Face& face) const {
    return std::span(corners_).subspan(static_cast<std::size_t>(face.first), static_cast<std::size_t>(face.count));
  }
  /// Numbers of the vertices that share an edge with a vertex.
  std::span<const int> neighbours(int vertex) const { return ofVertex(neighbours_, vertex); }
  /// Numbers of the faces of which a vertex is a corner.
  std::span<const int> facesAround(int vertex) const { return ofVertex(faces_around_, vertex); }
  const Vector3& vertex(int number) const { return vertices_[static_cast<std::size_t>(number)]; }
  /// A point inside: the mean of the vertices.
  const Vector3& centre() const { return centre_; }
  /// Radius of the smallest sphere about the frame's origin that holds all vertices [m].
  double boundingRadius() const { return bounding_radius_; }

  /// Number of a vertex that lies farthest in direction d (of any length > 0). Cost: all vertices of a small hull; of a
  /// large one, a walk from neighbour to neighbour.
  int farthestVertex(const Vector3& d) const;

 private:
  void keepUsedVertices(std::span<const Vector3> points);
  void linkNeighbours();
  std::span<const int> ofVertex(const std::vector<int>& all, int vertex) const {
    const auto begin = static_cast<std::size_t>(first_of_vertex_[static_cast<std::size_t>(vertex)]);
    const auto end = static_cast<std::size_t>(first_of_vertex_[static_cast<std::size_t>(vertex) + 1]);
    return std::span(all).subspan(begin, end - begin);
  }

  std::vector<Vector3> vertices_;
  std::vector<Face> faces_;
  std::vector<int> corners_;
  std::vector<int> neighbours_, faces_around_, first_of_vertex_;
  Vector3 centre_;
  double bounding_radius_ = 0;
};

}  // namespace murosimf
