#include "murosimf/simulation/integration_statistics.h"

#include <algorithm>
#include <iterator>

namespace murosimf {

IntegrationStatistics::IntegrationStatistics(Simulation& simulation) {
  LinkedWorld& linked = simulation.linked();
  for (const ObjectId id : simulation.participants().robots) {
    robots_.emplace_back().object = id;
    watches_.push_back(
        {linked.handle(id, kSubsteps), linked.handle(id, kIntegrationError), linked.handle(id, kIntegrationFault)});
  }
}

void IntegrationStatistics::afterFrame(Simulation&) {
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    const Watch& watch = watches_[i];
    if (!watch.substeps.valid()) continue;
    Robot& robot = robots_[i];
    ++robot.frames;
    robot.substeps += watch.substeps.get();
    robot.most_substeps = std::max(robot.most_substeps, watch.substeps.get());
    robot.largest_error = std::max(robot.largest_error, watch.error.get());
    robot.faulty_frames += watch.fault.get() > 0 ? 1 : 0;
  }
}

void IntegrationStatistics::archive(StateArchive& archive) {
  for (Robot& robot : robots_) archive(robot);
}

std::vector<IntegrationStatistics::Robot> IntegrationStatistics::robots() const {
  std::vector<Robot> told;
  std::copy_if(robots_.begin(), robots_.end(), std::back_inserter(told), [](const Robot& r) { return r.frames > 0; });
  return told;
}

}  // namespace murosimf
