#include "murosimf/robot/kinematic_tree.h"

namespace murosimf {
namespace {

template <class Named>
int indexOfName(const std::vector<Named>& list, std::string_view name) {
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (list[i].name == name) return static_cast<int>(i);
  }
  return -1;
}

Pose poseOnParent(const KinematicTree& tree, const TreeElement& element, const std::vector<double>& q) {
  switch (element.kind) {
    case ElementKind::kFixedTranslation:
      return {Rotation3{}, element.translation};
    case ElementKind::kFixedRotation:
      return {element.rotation, Vector3{}};
    case ElementKind::kVariableTranslation:
    case ElementKind::kVariableRotation: {
      const auto j = static_cast<std::size_t>(element.joint);
      const Vector3 motion = tree.joints[j].axis * q[j];
      if (element.kind == ElementKind::kVariableTranslation) return {Rotation3{}, motion};
      return {rotationExp(motion), Vector3{}};
    }
    default:
      return {};
  }
}

}  // namespace

int KinematicTree::bodyIndex(std::string_view name) const { return indexOfName(bodies, name); }
int KinematicTree::jointIndex(std::string_view name) const { return indexOfName(joints, name); }

double KinematicTree::mass() const {
  double sum = 0;
  for (const Body& body : bodies) sum += body.mass.mass;
  return sum;
}

std::vector<Pose> elementPoses(const KinematicTree& tree, const std::vector<double>& q) {
  std::vector<Pose> poses;
  poses.reserve(tree.elements.size());
  for (const TreeElement& element : tree.elements) {
    const Pose X_PE = poseOnParent(tree, element, q);
    poses.push_back(element.parent < 0 ? X_PE : poses[static_cast<std::size_t>(element.parent)] * X_PE);
  }
  return poses;
}

}  // namespace murosimf
