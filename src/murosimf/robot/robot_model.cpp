#include "murosimf/robot/robot_model.h"

#include <algorithm>

namespace murosimf {
namespace {

/// The joint next nearer to the base, of each joint; -1 where that is the base itself.
std::vector<int> parentJoints(const KinematicTree& tree) {
  std::vector<int> nearest;  // joint at or above each element
  std::vector<int> parents(tree.joints.size(), -1);
  for (const TreeElement& element : tree.elements) {
    const int above = element.parent < 0 ? -1 : nearest[static_cast<std::size_t>(element.parent)];
    if (element.joint >= 0) parents[static_cast<std::size_t>(element.joint)] = above;
    nearest.push_back(element.joint >= 0 ? element.joint : above);
  }
  return parents;
}

/// Does `carrier` stand at most `joints` joints above `joint`, or in the same place?
bool carriesWithin(const std::vector<int>& parents, int carrier, int joint, int joints) {
  for (int steps = 0; steps <= joints; ++steps) {
    if (joint == carrier) return true;
    if (joint < 0) return false;
    joint = parents[static_cast<std::size_t>(joint)];
  }
  return false;
}

void sortUnique(std::vector<std::pair<int, int>>& pairs) {
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
}

}  // namespace

std::array<Vector3, 4> Sole::corners() const {
  const double x = 0.5 * length, y = 0.5 * width;
  return {X_BSole * Vector3{x, y, 0}, X_BSole * Vector3{x, -y, 0}, X_BSole * Vector3{-x, -y, 0},
          X_BSole * Vector3{-x, y, 0}};
}

bool RobotModel::ignoresContact(int body, int other) const {
  return std::binary_search(ignored_pairs.begin(), ignored_pairs.end(), std::pair<int, int>(std::minmax(body, other)));
}

void ignoreNearPairs(RobotModel& model, int joints) {
  const std::vector<int> parents = parentJoints(model.tree);
  const std::vector<Body>& bodies = model.tree.bodies;
  for (std::size_t a = 0; a < bodies.size(); ++a) {
    for (std::size_t b = a + 1; b < bodies.size(); ++b) {
      if (carriesWithin(parents, bodies[a].joint, bodies[b].joint, joints) ||
          carriesWithin(parents, bodies[b].joint, bodies[a].joint, joints)) {
        model.ignored_pairs.emplace_back(static_cast<int>(a), static_cast<int>(b));
      }
    }
  }
  sortUnique(model.ignored_pairs);
}

void ignorePair(RobotModel& model, int body, int other) {
  model.ignored_pairs.emplace_back(std::min(body, other), std::max(body, other));
  sortUnique(model.ignored_pairs);
}

}  // namespace murosimf
