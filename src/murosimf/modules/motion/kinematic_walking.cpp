#include "murosimf/modules/motion/kinematic_walking.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "murosimf/linking/links.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

namespace {

constexpr Variable<double> kLastPosition{"last_joint_position", "rad", "q at the beginning of the step"};
constexpr Variable<double> kBetween{"between_joint_position", "rad", "q at the touch-down", Storage::kStep};
constexpr Variable<StanceMemory<double>> kStanceMemory{"stance_memory", "SI",
                                                       "anchor, residual and history of support"};

SoleChain chainTo(const SolePlace& sole, const TreeTable& tree) {
  SoleChain chain;
  for (int row = sole.mount.row; row > 0; row = tree.rows[static_cast<std::size_t>(row)].parent) {
    if (chain.length == SoleChain::kLongest) {
      throw std::invalid_argument(fmt::format("more than {} joints between the base and a sole", SoleChain::kLongest));
    }
    chain.rows[chain.length++] = row;
  }
  std::reverse(chain.rows, chain.rows + chain.length);
  chain.X_RS = kernelPose(sole.mount.X_RM);
  chain.half_length = sole.half_length;
  chain.half_width = sole.half_width;
  return chain;
}

}  // namespace

std::vector<ParameterInfo> KinematicWalking::parameters() {
  return {{"hysteresis", "m", "clearance that a swing sole must pass before it may land", 2e-4, 0, 0.05},
          {"blend_time", "s", "time in which the jump of an exchange fades out", 0.05, 1e-3, 1}};
}

KinematicWalking::KinematicWalking(const ParameterValues& values) {
  arguments_.hysteresis = values["hysteresis"];
  arguments_.blend_time = values["blend_time"];
}

void KinematicWalking::declare(Declaration& d) const {
  d.runsIn(Phase::kPrescribe);
  d.needs(kTree);
  d.needs(kSoles);
  d.reads(kJointPosition, subset::kJoints);
  d.reads(kPlacement);
  d.reads(kPlacementCount);
  d.readsLast(kPlanarShift);
  d.adds(kBasePose);
  d.adds(kBasePoseLast);
  d.adds(kStanceSide);
  d.adds(kStanceMemory);
  d.adds(kLastPosition, subset::kJoints);
  d.adds(kBetween, subset::kJoints);
  d.adds(kSoleClearance, subset::kSoles);
  d.adds(kFlattenedTurn);
  d.adds(kFlattenedShift);
  d.adds(kSupportSlip);
  d.adds(kFlight);
}

void KinematicWalking::link(Links& links) {
  const TreeTable tree = links.shared(kTree);
  const std::vector<SolePlace> soles = links.shared(kSoles);
  if (soles.size() != 2) {
    throw std::invalid_argument(fmt::format("the robot has {} soles; expected 2", soles.size()));
  }
  rows_ = kernelRows(tree);
  arguments_.rows = rows_.data();
  arguments_.joints = tree.jointCount();
  for (std::size_t i = 0; i < 2; ++i) arguments_.sole[i] = chainTo(soles[i], tree);
  arguments_.q = links.column(kJointPosition, subset::kJoints);
  arguments_.q_last = links.column(kLastPosition, subset::kJoints);
  arguments_.q_between = links.column(kBetween, subset::kJoints);
  arguments_.placement = links.column(kPlacement);
  arguments_.placement_count = links.column(kPlacementCount);
  arguments_.planar_shift = links.column(kPlanarShift);
  arguments_.base_pose = links.column(kBasePose);
  arguments_.base_pose_last = links.column(kBasePoseLast);
  arguments_.clearance = links.column(kSoleClearance, subset::kSoles);
  arguments_.stance = links.column(kStanceSide);
  arguments_.flattened_turn = links.column(kFlattenedTurn);
  arguments_.flattened_shift = links.column(kFlattenedShift);
  arguments_.slip = links.column(kSupportSlip);
  arguments_.flight = links.column(kFlight);
  arguments_.memory = links.column(kStanceMemory);
  width_ = links.width();
  kernel_ = kernelOfWidth<KinematicWalkingArguments>(width_);
}

void KinematicWalking::initialise(const BlockMemory& block) const {
  // No placement has been obeyed yet, not even the one that stands at the start.
  constexpr int kPlacements = static_cast<int>(offsetof(StanceMemory<double>, placements) / sizeof(double));
  double* memory = block.piece[static_cast<int>(arguments_.memory.memory)] + arguments_.memory.offset * width_;
  std::fill_n(memory + kPlacements * width_, width_, -1.0);
}

}  // namespace murosimf
