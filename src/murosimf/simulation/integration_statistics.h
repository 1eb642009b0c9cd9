#pragma once

/// @file How hard it was to integrate robots whose integrator chooses its own steps: for reports.

#include <vector>

#include "murosimf/simulation/simulation.h"

namespace murosimf {

class IntegrationStatistics final : public FrameObserver {
 public:
  /// Of one robot, over the frames in which its integrator told of them.
  struct Robot {
    ObjectId object;
    long frames = 0, faulty_frames = 0;
    double substeps = 0, most_substeps = 0;  ///< in all frames; in one
    double largest_error = 0;                ///< integration_error [m, rad, their rates]
    void archive(StateArchive& archive) { archive(frames, faulty_frames, substeps, most_substeps, largest_error); }
  };

  explicit IntegrationStatistics(Simulation& simulation);
  void afterFrame(Simulation& simulation) override;
  void archive(StateArchive& archive) override;
  /// Of a robot in the last frame, by its number; 0 where its integrator tells of none.
  int substeps(int robot) const {
    const Handle<double>& told = watches_[static_cast<std::size_t>(robot)].substeps;
    return told.valid() ? static_cast<int>(told.get()) : 0;
  }
  double error(int robot) const {
    const Handle<double>& told = watches_[static_cast<std::size_t>(robot)].error;
    return told.valid() ? told.get() : 0;
  }
  /// Those that told something.
  std::vector<Robot> robots() const;

 private:
  struct Watch {
    Handle<double> substeps, error, fault;
  };
  std::vector<Robot> robots_;
  std::vector<Watch> watches_;  // as robots_
};

}  // namespace murosimf
