#pragma once

/// @file Stops at the ends of the joints' ranges: one-sided springs with dampers.
///
/// Model      Beyond upper_limit by the depth d > 0, tau = -(k d + c dq), where that pushes back; beyond lower_limit
///            likewise upwards. For a step h that looks ahead d and dq are those at its end, d + h (dq + h ddq) and
///            dq + h ddq; what depends on ddq counts as inertia h c + h^2 k at the joint, so stops of any stiffness are
///            stable, and a joint that would get beyond its limit within the step meets the stop in it.
/// Stiffness  limit_stiffness of the joint; where there is none, so much that the joint's own servo at its stall torque
///            gives way by the parameter `give` (a joint without a servo: as with 1 N m): k = stall_torque / give.
/// Damping    limit_damping of the joint; where there is none c = 2 damping_ratio sqrt(k armature) with an armature of
///            1e-3 kg m^2 at least: the ratio that the bare rotor has at its stop. A link makes it less, so that a limb
///            bounces a little.
/// Sliders    the same with m and N in the place of rad and N m.
/// Phase      kEvaluate.
/// Adds to    joint_torque, joint_inertia.
/// Cost       about 5 operations a joint within its range, 15 and a square root at a stop.

#include "murosimf/linking/module.h"
#include "murosimf/modules/actuation/joint_limits_kernel.h"
#include "murosimf/world/property.h"

namespace murosimf {

inline constexpr Constant<double> kLimitStiffness{"limit_stiffness", "N m/rad",
                                                  "of the stops; 0: from the stall torque"};
inline constexpr Constant<double> kLimitDamping{"limit_damping", "N m s/rad", "of the stops; 0: from the armature"};

class JointLimitStops final : public BlockModule {
 public:
  static std::vector<ParameterInfo> parameters();
  explicit JointLimitStops(const ParameterValues& values);
  void declare(Declaration& declaration) const override;
  void link(Links& links) override;
  void step(const BlockMemory& block, const StepTime& time) const override { kernel_(arguments_, block, time); }

 private:
  JointLimitArguments arguments_;
  KernelSet<JointLimitArguments>::Kernel kernel_ = nullptr;
};

}  // namespace murosimf
