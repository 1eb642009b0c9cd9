#pragma once

/// @file How the links of a URDF file hang together, checked: each named once, one root, no cycle.

#include <map>
#include <string>
#include <vector>

#include "murosimf/robot/urdf_parts.h"

namespace murosimf::urdf {

/// Indices count in RobotPart::links and RobotPart::joints.
struct LinkGraph {
  std::vector<std::vector<int>> joints_below;  ///< of each link, in the order of the file
  std::vector<int> joint_above;                ///< of each link; -1 for a root
  std::vector<int> child_of_joint;             ///< link; -1 where it is unknown
  int root = -1;
};

/// Connects links by joints. Reports unknown links, links with two parents, several roots and cycles.
LinkGraph connectLinks(const RobotPart& robot, Diagnostics& diagnostics);

/// Reports every name of a link, joint or mounted thing that something else has already. O(n log n).
void checkNames(const RobotPart& robot, Diagnostics& diagnostics);

}  // namespace murosimf::urdf
