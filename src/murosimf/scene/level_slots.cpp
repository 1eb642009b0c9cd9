#include "murosimf/scene/level_slots.h"

#include <algorithm>

namespace murosimf {

namespace {

constexpr std::string_view kMotors[] = {"dc_motor"};
constexpr std::string_view kIntegrators[] = {"semi_implicit_euler", "explicit_euler", "midpoint", "runge_kutta_4",
                                             "dormand_prince"};
constexpr std::string_view kTorqueEstimates[] = {"torque_estimate"};
constexpr std::string_view kJointForces[] = {"gear_load", "joint_friction"};
constexpr std::string_view kGroundLaws[] = {"hunt_crossley_contact", "smooth_contact", "paper_contact",
                                            "ground_contact"};

constexpr std::string_view kCoarserShapes[] = {"feet_only", "bounding_spheres"};

constexpr Slot kKinematicSlots[] = {
    {"actuation", "ideal_servo"}, {"motion", "kinematic_walking"}, {"collision", "primitives", kCoarserShapes},
    {"kinematics", "body_poses"}, {"sensing", "inertial_sensor"},  {"touch", "push_sensor"}};
constexpr Slot kWheeledSlots[] = {
    {"actuation", "tracking_servo"}, {"motion", "wheeled_kinematics"}, {"collision", "primitives", kCoarserShapes},
    {"kinematics", "body_poses"},    {"sensing", "inertial_sensor"},   {"touch", "push_sensor"}};
constexpr Slot kMultibodySlots[] = {{"electronics", "servo_controller"},
                                    {"velocities", "tree_motion"},
                                    {"actuation", "position_servo", kMotors},
                                    {"contact", "hunt_crossley_contact", kGroundLaws},
                                    {"collision", "primitives", kCoarserShapes},
                                    {"recoil", "pair_forces"},
                                    {"motion", "multibody_dynamics"},
                                    {"sensing", "dynamic_inertial_sensor"},
                                    {"pressure", "foot_pressure"},
                                    {"torque", "joint_torque_sensor"},
                                    {"limits", "joint_limits"},
                                    {"integration", "implicit_euler", kIntegrators},
                                    {"kinematics", "body_poses"},
                                    {"touch", "touch_sensor"},
                                    {"force", "force_sensor"}};
constexpr Slot kSimplifiedSlots[] = {{"velocities", "tree_motion"},
                                     {"actuation", "tracking_servo"},
                                     {"contact", "smooth_contact", kGroundLaws},
                                     {"collision", "primitives", kCoarserShapes},
                                     {"recoil", "rigid_pair_forces"},
                                     {"motion", "simplified_dynamics"},
                                     {"accelerations", "body_accelerations"},
                                     {"sensing", "prescribed_inertial_sensor"},
                                     {"pressure", "foot_pressure"},
                                     {"torque", "none", kTorqueEstimates},
                                     {"integration", "momentum_midpoint"},
                                     {"kinematics", "body_poses"},
                                     {"touch", "touch_sensor"},
                                     {"force", "force_sensor"}};

constexpr LevelSlots kLevels[] = {{"kinematic", "kinematic_walking", kKinematicSlots, 0.01},
                                  {"oracle", "kinematic_walking", kKinematicSlots, 0.01},
                                  {"kinematic", "wheeled_kinematics", kWheeledSlots, 0, {}, true},
                                  {"oracle", "wheeled_kinematics", kWheeledSlots, 0, {}, true},
                                  {"fast", "simplified_dynamics", kSimplifiedSlots, 0},
                                  {"full", "multibody_dynamics", kMultibodySlots, 0, kJointForces},
                                  {"full", "composite_body_dynamics", kMultibodySlots, 0, kJointForces}};

}  // namespace

const LevelSlots& levelNamed(std::string_view name, bool on_wheels) {
  const auto own = std::find_if(std::begin(kLevels), std::end(kLevels),
                                [&](const LevelSlots& l) { return l.name == name && l.on_wheels == on_wheels; });
  if (own != std::end(kLevels)) return *own;
  const auto found =
      std::find_if(std::begin(kLevels), std::end(kLevels), [&](const LevelSlots& l) { return l.name == name; });
  return found == std::end(kLevels) ? kLevels[0] : *found;
}

const LevelSlots& levelOfMotion(std::string_view motion, std::string_view usual) {
  const auto found =
      std::find_if(std::begin(kLevels), std::end(kLevels), [&](const LevelSlots& l) { return l.motion == motion; });
  return found == std::end(kLevels) ? levelNamed(usual) : *found;
}

namespace {
bool contains(std::span<const std::string_view> names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}
}  // namespace

bool takes(const LevelSlots& level, std::string_view slot, std::string_view module) {
  const auto found =
      std::find_if(level.slots.begin(), level.slots.end(), [&](const Slot& s) { return s.name == slot; });
  if (found == level.slots.end()) return false;
  return module.empty() || module == "none" || module == found->module || contains(found->others, module);
}

bool isFurther(const LevelSlots& level, std::string_view module) { return contains(level.further, module); }

}  // namespace murosimf
