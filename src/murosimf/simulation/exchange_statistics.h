#pragma once

/// @file Which levels of detail robots were at, and what their exchanges took away: for reports.

#include <vector>

#include "murosimf/simulation/simulation.h"

namespace murosimf {

class ExchangeStatistics final : public FrameObserver {
 public:
  /// Of one robot that was linked with several levels.
  struct Robot {
    ObjectId object;
    std::vector<long> frames;  ///< at each level
    long exchanges = 0;        ///< that changed its level
    double largest_turn = 0;   ///< that kinematic walking took away at once: roll and pitch of a sole [rad]
    double largest_shift = 0;  ///< same: its height [m]
  };

  explicit ExchangeStatistics(Simulation& simulation);
  void afterFrame(Simulation& simulation) override;
  void archive(StateArchive& archive) override;
  const std::vector<Robot>& robots() const { return robots_; }

 private:
  struct Watch {
    Handle<double> turn, shift;
    const Resident* resident = nullptr;
    int level = 0;  ///< in the frame before
  };
  std::vector<Robot> robots_;
  std::vector<Watch> watches_;  // as robots_
};

}  // namespace murosimf
