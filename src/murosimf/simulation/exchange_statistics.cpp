#include "murosimf/simulation/exchange_statistics.h"

#include <algorithm>

namespace murosimf {

ExchangeStatistics::ExchangeStatistics(Simulation& simulation) {
  LinkedWorld& linked = simulation.linked();
  for (const ObjectId id : simulation.participants().robots) {
    if (linked.levelCount(id) < 2) continue;
    Robot& robot = robots_.emplace_back();
    robot.object = id;
    robot.frames.resize(static_cast<std::size_t>(linked.levelCount(id)));
    watches_.push_back({linked.handle(id, kFlattenedTurn), linked.handle(id, kFlattenedShift), &linked.residentOf(id),
                        linked.levelOf(id)});
  }
}

void ExchangeStatistics::afterFrame(Simulation&) {
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    Robot& robot = robots_[i];
    Watch& watch = watches_[i];
    const int level = watch.resident->level;
    robot.exchanges += level == watch.level ? 0 : 1;
    watch.level = level;
    ++robot.frames[static_cast<std::size_t>(level)];
    if (!watch.turn.valid()) continue;
    robot.largest_turn = std::max(robot.largest_turn, watch.turn.get());
    robot.largest_shift = std::max(robot.largest_shift, watch.shift.get());
  }
}

void ExchangeStatistics::archive(StateArchive& archive) {
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    Robot& robot = robots_[i];
    archive(robot.frames, robot.exchanges, robot.largest_turn, robot.largest_shift, watches_[i].level);
  }
}

}  // namespace murosimf
