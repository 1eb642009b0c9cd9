#pragma once

/// @file A robot's response, computed anew only when the robot has another posture: most that touch lie or stand still.
///
/// The response about the base's origin depends on the joints' positions and the base's rotation alone. While none of
/// their numbers has changed by more than 2e-3 [rad, 1], neither has the response by more than some thousandths, which
/// is less than what it leaves out of the servos; what two robots hand to one another stays equal and opposite.
/// There is room for all bodies, of which only as much is ever touched as bodies have been; nothing is allocated later.
/// State: what is kept, for checkpoints.

#include <functional>

#include "murosimf/algorithms/tree_response.h"
#include "murosimf/math/state_archive.h"

namespace murosimf {

class KeptResponse final : public Response {
 public:
  /// X_WB of all bodies; called only when it is needed.
  using Places = std::function<std::span<const Pose>()>;

  explicit KeptResponse(const TreeResponse::Constants& constants);
  /// The robot of this moment. @param posture  joints and base's rotation, and whatever else the response depends on
  void begin(const Vector3& p_WO, std::span<const double> posture, bool joints_yield, Places places);
  ResponseBlocks respond(std::span<const int> bodies, std::span<int> places) const override;
  void archive(StateArchive& archive) { archive(bodies_, posture_, blocks_); }

 private:
  static constexpr double kSamePosture = 2e-3;
  bool holds(std::span<const int> bodies) const;

  mutable TreeResponse response_;
  // Of this moment.
  std::vector<double> now_;
  bool joints_yield_ = true;
  Places places_;
  // Kept.
  mutable std::vector<int> bodies_;
  mutable std::vector<double> posture_;
  mutable std::vector<ResponseBlock> blocks_;  // of bodies_
};

}  // namespace murosimf
