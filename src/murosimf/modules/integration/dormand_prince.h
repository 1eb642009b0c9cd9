#pragma once

/// @file Steps of the length that a wanted accuracy allows, and jumps of forces found to the picosecond.
///
/// Model      y' = f(y) with y the joints' positions and rates and the base's pose and velocity; the method of Dormand
///            and Prince of order 5 (dormand_prince_tableau.h), rotations in a chart of their own (base_chart.h).
///            Every robot has steps of its own length and reaches the end of the frame by itself (step_control.h).
/// Events     event_function of joints and bodies, where a module writes it, is watched at every stage. Where one
///            changes its sign, a step ends and the next one begins.
/// Forces     are asked for as they are now, without the look ahead of implicit steps.
/// Lanes      All robots of a block are evaluated together, each in its own state; one that has arrived stands still
///            while the others go on. A block costs what its slowest robot costs.
/// Adds       joint_position, joint_velocity, base_pose, base_velocity; integration_step, the length that the error
///            would have, for the next frame; event_time. Of the last frame: integration_error, substeps,
///            force_evaluations, event_count, integration_fault.
/// Cost       1 evaluation a frame and 6 a step that is tried; about 12 more an event. A tool for accuracy, not for
///            games: docs/integrators.md.
/// Exchange   with any other integrator.

#include "murosimf/linking/fixed_value.h"
#include "murosimf/linking/integrator.h"
#include "murosimf/linking/robot_lane.h"
#include "murosimf/modules/integration/dormand_prince_kernel.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

inline constexpr Variable<double> kIntegrationStep{"integration_step", "s", "length of step that the error would have"};
inline constexpr Variable<double> kForceEvaluations{"force_evaluations", "1", "of the last frame, of this robot alone",
                                                    Storage::kKept};
inline constexpr Variable<double> kEventCount{"event_count", "1", "jumps of forces in the last frame", Storage::kKept};
inline constexpr Variable<double> kEventTime{"event_time", "s", "when forces jumped last; -1: not yet"};

class DormandPrince final : public Integrator {
 public:
  static std::vector<ParameterInfo> parameters();
  explicit DormandPrince(const ParameterValues& values);
  void declare(Declaration& declaration) const override;
  void link(Links& links) override;
  void initialise(const BlockMemory& block) const override;
  void adopt(const BlockMemory& one) const override { manner_.adopt(one); }
  void step(const BlockMemory& block, const StepTime& time) const override;

 private:
  using Control = StepControl<double>;
  void run(const BlockMemory& block, DormandPrincePart part, int stage = 0) const;
  /// Makes the same decision for every robot of the block; true when it is for one of them.
  template <class Decide>
  bool decide(const BlockMemory& block, Decide&& decision) const;
  void tryStep(const BlockMemory& block, const StepTime& time) const;
  void locateEvents(const BlockMemory& block, const StepTime& time) const;
  void report(const BlockMemory& block, const StepTime& time) const;

  StepLimits limits_;
  DormandPrinceArguments arguments_;
  FixedValue<StepManner> manner_{kStepManner, {0.5, 0.5}};
  ColumnRef initial_;
  RobotValues<Control> control_;
  RobotValues<double> step_, error_, substeps_, evaluations_, events_, event_time_, fault_;
  int width_ = 1;
  KernelSet<DormandPrinceTask>::Kernel kernel_ = nullptr;
};

}  // namespace murosimf
