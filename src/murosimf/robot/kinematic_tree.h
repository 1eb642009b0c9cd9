#pragma once

/// @file The kinematic tree of a robot [Friedmann, Petersen, von Stryk 2007, 3.1].
///
/// A tree is made of elements: its base, forks, fixed translations and rotations, and variable ones, the joints. Bodies
/// hang on elements. It says what there is and what its constants are; it knows no motion, no algorithm and no file.
/// Elements stand parents before children; the n-th variable element is joint n.
///
/// Pose of an element E on its parent P: X_PE = (identity for base and fork; a shift; a turn; for joints a shift along
/// or a turn about `axis` by the joint's position q).

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "murosimf/algorithms/collision/convex_hull.h"
#include "murosimf/algorithms/shape.h"
#include "murosimf/algorithms/tree_table.h"
#include "murosimf/algorithms/triangle_mesh.h"
#include "murosimf/robot/mass_properties.h"
#include "murosimf/world/diagnostics.h"

namespace murosimf {

inline constexpr Vector3 kAxisX{1, 0, 0}, kAxisY{0, 1, 0}, kAxisZ{0, 0, 1};

enum class ElementKind { kBase, kFork, kFixedTranslation, kFixedRotation, kVariableTranslation, kVariableRotation };

struct TreeElement {
  ElementKind kind = ElementKind::kBase;
  std::string name{};     ///< of the base or the joint; empty for the others
  int parent = -1;        ///< index of the element it stands on; -1 for the base
  Vector3 translation{};  ///< kFixedTranslation: p_PE_P [m]
  Rotation3 rotation{};   ///< kFixedRotation: R_PE
  int joint = -1;         ///< variable elements: index into KinematicTree::joints
};

/// One shape of a body.
struct BodyShape {
  Shape shape{};
  Pose X_BS{};                                 ///< place on the body
  Colour colour{};                             ///< where it is drawn and `team_colour` is false
  bool team_colour = false;                    ///< drawn in the colour of the robot's team
  bool drawn = true;                           ///< seen by cameras and viewers
  bool collides = true;                        ///< takes part in contacts
  std::string surface = "default";             ///< name by which a scenario sets the parameters of pairs of surfaces
  std::shared_ptr<const ConvexHull> hull{};    ///< of a kConvex shape, in S
  std::shared_ptr<const TriangleMesh> mesh{};  ///< drawn in the shape's place, in S; none: the shape itself
  std::string mesh_source{};                   ///< file and scale of what `hull` and `mesh` were made of
  SourceLocation where{};
};

struct Body {
  std::string name{};
  MassProperties mass{};  ///< mass 0 for a mere frame, which must be fixed to a body that has mass
  std::vector<BodyShape> shapes{};
  int element = -1;  ///< element that it hangs on; the body's frame B is that element's frame
  int joint = -1;    ///< joint by which it moves: the last variable element above it; -1 on the base
  SourceLocation where{};
};

/// Datasheet and controller of a position servo: tau = kp (q_wanted - q) - kd v, bounded by the line from
/// stall_torque at rest to zero at no_load_speed.
struct ServoParameters {
  std::string type{};        ///< "DX-117"
  double stall_torque = 0;   ///< [N m]
  double no_load_speed = 0;  ///< [rad/s]
  double kp = 0;             ///< [N m/rad]
  double kd = 0;             ///< [N m s/rad]
  double armature = 0;       ///< rotor inertia seen at the joint [kg m^2]
  double resolution = 0;     ///< of the angle that it reports [rad]; 0: exact
  double backlash = 0;       ///< play between servo and joint [rad]
  std::string file{};        ///< of more parameters, read when a world is built; empty: none
  friend bool operator==(const ServoParameters&, const ServoParameters&) = default;
};

/// Range and largest values of a joint [rad, rad/s, N m; prismatic: m, m/s, N]. Infinite: no limit.
struct JointLimits {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  double largest_velocity = std::numeric_limits<double>::infinity();
  double largest_torque = std::numeric_limits<double>::infinity();
  friend bool operator==(const JointLimits&, const JointLimits&) = default;
};

struct Joint {
  std::string name{};
  JointKind kind = JointKind::kRevolute;
  Vector3 axis = kAxisZ;  ///< of length 1, in the frame of its element, the same before and after the motion
  JointLimits limits{};
  double damping = 0;   ///< viscous [N m s/rad]
  double friction = 0;  ///< dry [N m]
  std::optional<ServoParameters> servo{};
  int element = -1;
  SourceLocation where{};
};

struct KinematicTree {
  std::vector<TreeElement> elements{};
  std::vector<Joint> joints{};
  std::vector<Body> bodies{};

  int bodyIndex(std::string_view name) const;   ///< -1 when there is none
  int jointIndex(std::string_view name) const;  ///< -1 when there is none
  double mass() const;                          ///< of all bodies [kg]
};

/// Pose of each element in the base for the joint positions q, straight from the elements: slow and obvious. For tests,
/// tools and set-up; simulation uses the flattened table.
std::vector<Pose> elementPoses(const KinematicTree& tree, const std::vector<double>& q);

}  // namespace murosimf
