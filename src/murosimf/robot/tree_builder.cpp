#include "murosimf/robot/tree_builder.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "murosimf/robot/checks.h"

namespace murosimf {
namespace {

[[noreturn]] void refuse(const std::string& what) { throw std::invalid_argument(what); }

void require(const std::string& owner, const std::string& problem) {
  if (!problem.empty()) refuse(owner + ": " + problem);
}

bool finite(const Vector3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// Orthonormal and right-handed to 1e-9.
bool isRotation(const Rotation3& r) {
  const Vector3 off{dot(r.x, r.y), dot(r.x, r.z), dot(r.y, r.z)};
  const Vector3 handedness = cross(r.x, r.y) - r.z;
  return squaredNorm(off) < 1e-18 && squaredNorm(handedness) < 1e-18 && abs(squaredNorm(r.x) - 1) < 1e-9;
}

}  // namespace

TreePlace TreePlace::fork() const { return builder_->add(element_, {.kind = ElementKind::kFork}); }

TreePlace TreePlace::translation(const Vector3& p_PE_P) const {
  if (!finite(p_PE_P)) refuse("fixed translation: a component is not finite");
  return builder_->add(element_, {.kind = ElementKind::kFixedTranslation, .translation = p_PE_P});
}

TreePlace TreePlace::rotation(const Rotation3& R_PE) const {
  if (!isRotation(R_PE)) refuse("fixed rotation: the matrix is not orthonormal and right-handed");
  return builder_->add(element_, {.kind = ElementKind::kFixedRotation, .rotation = R_PE});
}

TreePlace TreePlace::pose(const Pose& X_PE) const {
  const TreePlace shifted = X_PE.translation == Vector3{} ? *this : translation(X_PE.translation);
  return X_PE.rotation == Rotation3{} ? shifted : shifted.rotation(X_PE.rotation);
}

TreePlace TreePlace::revolute(std::string name, const Vector3& axis, const JointLimits& limits,
                              const std::optional<ServoParameters>& servo) const {
  return joint({.name = std::move(name), .axis = axis, .limits = limits, .servo = servo});
}

TreePlace TreePlace::prismatic(std::string name, const Vector3& axis, const JointLimits& limits,
                               const std::optional<ServoParameters>& servo) const {
  return joint(
      {.name = std::move(name), .kind = JointKind::kPrismatic, .axis = axis, .limits = limits, .servo = servo});
}

TreePlace TreePlace::joint(Joint joint) const {
  const std::string owner = "joint " + quoted(joint.name);
  const std::optional<Vector3> axis = unitAxis(joint.axis);
  if (!axis) refuse(owner + ": axis has no direction");
  require(owner, limitsProblem(joint.limits));
  if (joint.servo) require(owner, servoProblem(*joint.servo));
  if (!std::isfinite(joint.damping) || joint.damping < 0) refuse(owner + ": damping is not 0 or more");
  if (!std::isfinite(joint.friction) || joint.friction < 0) refuse(owner + ": friction is not 0 or more");
  builder_->claimName(joint.name);

  joint.axis = *axis;
  const bool slides = joint.kind == JointKind::kPrismatic;
  const TreePlace place =
      builder_->add(element_, {.kind = slides ? ElementKind::kVariableTranslation : ElementKind::kVariableRotation,
                               .name = joint.name,
                               .joint = static_cast<int>(builder_->tree_.joints.size())});
  joint.element = place.element_;
  builder_->tree_.joints.push_back(std::move(joint));
  return place;
}

TreePlace TreePlace::body(Body body) const {
  const std::string owner = "body " + quoted(body.name);
  if (!(body.mass == MassProperties{})) require(owner, massProblem(body.mass));
  for (const BodyShape& shape : body.shapes) require(owner, shapeProblem(shape));
  builder_->claimName(body.name);

  const std::vector<TreeElement>& elements = builder_->tree_.elements;
  body.element = element_;
  int above = element_;
  while (above >= 0 && elements[static_cast<std::size_t>(above)].joint < 0) {
    above = elements[static_cast<std::size_t>(above)].parent;
  }
  body.joint = above < 0 ? -1 : elements[static_cast<std::size_t>(above)].joint;
  builder_->tree_.bodies.push_back(std::move(body));
  return *this;
}

TreePlace TreeBuilder::base(std::string name) {
  if (!tree_.elements.empty()) refuse("tree: it has a base already");
  require("base", nameProblem(name));
  return add(-1, {.kind = ElementKind::kBase, .name = std::move(name)});
}

TreePlace TreeBuilder::add(int parent, TreeElement element) {
  if (parent >= 0) {
    const auto p = static_cast<std::size_t>(parent);
    if (successors_[p] > 0 && tree_.elements[p].kind != ElementKind::kFork) {
      refuse("tree: an element that is no fork was given a second successor");
    }
    ++successors_[p];
  }
  element.parent = parent;
  tree_.elements.push_back(std::move(element));
  successors_.push_back(0);
  return {this, static_cast<int>(tree_.elements.size()) - 1};
}

void TreeBuilder::claimName(const std::string& name) {
  require("tree", nameProblem(name));
  if (!names_.insert(name).second) refuse("tree: the name " + quoted(name) + " is used twice");
}

KinematicTree TreeBuilder::build() const {
  if (tree_.elements.empty()) refuse("tree: it has no base");
  for (const int joint : masslessJoints(tree_)) {
    refuse(joint < 0 ? "tree: the base has no mass"
                     : "joint " + quoted(tree_.joints[static_cast<std::size_t>(joint)].name) + ": it moves no mass");
  }
  return tree_;
}

std::vector<int> masslessJoints(const KinematicTree& tree) {
  std::vector<double> masses(tree.joints.size() + 1, 0.0);
  for (const Body& body : tree.bodies) masses[static_cast<std::size_t>(body.joint + 1)] += body.mass.mass;
  std::vector<int> massless;
  for (std::size_t row = 0; row < masses.size(); ++row) {
    if (!(masses[row] > 0)) massless.push_back(static_cast<int>(row) - 1);
  }
  return massless;
}

}  // namespace murosimf
