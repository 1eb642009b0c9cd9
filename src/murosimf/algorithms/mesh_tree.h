#pragma once

/// @file How a set of boxes is put into a tree with eight branches to a node: a part of TriangleMesh.

#include <array>
#include <span>
#include <vector>

#include "murosimf/algorithms/cast_mesh_data.h"

namespace murosimf {

/// A box that may be empty.
struct MeshBox {
  std::array<float, 3> low, high;
};
MeshBox emptyBox();
void include(const MeshBox& other, MeshBox& box);

struct MeshTree {
  std::vector<CastMeshNode> nodes;         ///< root first
  std::vector<std::vector<int>> groups{};  ///< numbers of boxes, at most eight a group, in the order of the tree
};

/// Every box is in one group; every group in one place of a node. Cost: O(n log n).
MeshTree buildMeshTree(std::span<const MeshBox> boxes);

}  // namespace murosimf
