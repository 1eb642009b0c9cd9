#pragma once

/// @file The meshes of what cameras see, as fine as a picture through a lens needs them.
///
/// A lens bends straight edges. Drawn with corners in their right places and straight edges between, an edge of 32
/// pixels is off by less than 0.1 pixels in the middle for lenses of humanoid robots, one of 64 by four times that. So
/// every shape is kept at several finenesses, each with edges half as long as the one before, and a picture takes the
/// coarsest that is fine enough. Round shapes have as many facets as keep their outline within 0.15 pixels.

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "murosimf/algorithms/ray_scene.h"
#include "murosimf/render/mesh.h"

namespace murosimf {

class FineMeshes {
 public:
  static constexpr double kLongestEdge = 32;  ///< [px]
  static constexpr int kCoarsest = -3, kFinest = 6;

  /// A mesh of the library, in metres; a drawable has one a colour.
  struct Part {
    int number = 0;
    std::optional<Colour> colour;  ///< none: the drawable's
    bool closed = true;            ///< its backs are never seen
  };

  /// The coarsest fineness at which no edge is longer than kLongestEdge where a pixel covers `pixel` [m] of the
  /// drawable's surface, if that is within [kCoarsest, kFinest].
  static int finenessFor(double bounding_radius, double pixel);
  /// Made at the first call. @throws std::invalid_argument for a convex hull that brings no mesh
  std::span<const Part> parts(const Drawable& drawable, int fineness);
  const MeshLibrary& library() const { return library_; }

 private:
  using Key = std::tuple<const TriangleMesh*, ShapeKind, double, double, double, int>;
  std::vector<Part> make(const Drawable& drawable, int fineness);

  MeshLibrary library_;
  std::map<Key, std::vector<Part>> known_;
  std::vector<std::shared_ptr<const TriangleMesh>> kept_;  // so that no other takes the address of one in a key
};

}  // namespace murosimf
