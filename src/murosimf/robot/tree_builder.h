#pragma once

/// @file Builds a kinematic tree in C++, in the order in which one would describe the robot.
///
///     TreeBuilder builder;
///     const TreePlace hips = builder.base("pelvis").body({.name = "pelvis", .mass = ...}).fork();
///     hips.translation({0, 0, 0.04}).revolute("waist_yaw", kAxisZ, {.lower = -1.5, .upper = 1.5}).body({...});
///     hips.translation({0, 0.045, 0.03}).revolute("hip_yaw_left", kAxisZ).body({...});
///     const KinematicTree tree = builder.build();
///
/// Every call throws std::invalid_argument at once when what it is given cannot be: two successors without a fork, a
/// name that exists already, an axis of length zero, lower > upper, a body that massProblem() refuses, a number that is
/// not finite.

#include <optional>
#include <set>
#include <string>

#include "murosimf/robot/kinematic_tree.h"

namespace murosimf {

class TreeBuilder;

/// An element of a tree being built; each call adds one on top and returns its place. Keep a fork's place in a variable
/// to go on from it several times.
class TreePlace {
 public:
  TreePlace fork() const;
  TreePlace translation(const Vector3& p_PE_P) const;
  TreePlace rotation(const Rotation3& R_PE) const;
  /// Translation and rotation that are not zero, in this order.
  TreePlace pose(const Pose& X_PE) const;
  TreePlace revolute(std::string name, const Vector3& axis, const JointLimits& limits = {},
                     const std::optional<ServoParameters>& servo = {}) const;
  TreePlace prismatic(std::string name, const Vector3& axis, const JointLimits& limits = {},
                      const std::optional<ServoParameters>& servo = {}) const;
  /// A joint with all of its data; name, kind, axis, limits, damping, friction, servo and where are taken.
  TreePlace joint(Joint joint) const;
  /// Hangs a body here; stays at this place.
  TreePlace body(Body body) const;
  int element() const { return element_; }

 private:
  friend class TreeBuilder;
  TreePlace(TreeBuilder* builder, int element) : builder_(builder), element_(element) {}
  TreeBuilder* builder_;
  int element_;
};

class TreeBuilder {
 public:
  TreePlace base(std::string name);
  /// The finished tree. Throws std::invalid_argument when there is no base, or when a joint or the base moves no mass.
  KinematicTree build() const;
  /// What has been built so far; its joints may move no mass yet.
  const KinematicTree& draft() const { return tree_; }

 private:
  friend class TreePlace;
  TreePlace add(int parent, TreeElement element);
  void claimName(const std::string& name);
  KinematicTree tree_;
  std::vector<int> successors_;  ///< of each element
  std::set<std::string> names_;
};

/// All joints (-1: the base) whose bodies together have no mass, so that they would have no inertia.
std::vector<int> masslessJoints(const KinematicTree& tree);

}  // namespace murosimf
