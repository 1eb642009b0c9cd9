#pragma once

/// @file Containment: a robot whose state is no number any more is frozen where it was in the last step that was kept
/// (block_record.h); all others go on.
///
/// Robots share nothing but contacts, so that it is enough to look at each robot behind every step, before anybody else
/// reads it. A frozen robot stands still, all its other variables as they are before a first step, whatever it is
/// commanded and linked to. It thaws when somebody places it (a referee, a person).

#include <atomic>
#include <span>
#include <string>
#include <vector>

#include "murosimf/linking/outside_access.h"
#include "murosimf/math/state_archive.h"
#include "murosimf/simulation/block_record.h"

namespace murosimf {

class StateGuard {
 public:
  /// What it takes of robots: attach this when linking.
  static const OutsideAccess& robotAccess();

  /// One robot that was frozen, as often as that happened.
  struct Fault {
    ObjectId robot;
    double time = 0;  ///< end of the step that went wrong [s]
    std::string what;
    std::vector<RecordedStep> steps;  ///< that led to it, the wrong one last; empty after a checkpoint
    void archive(StateArchive& archive) { archive(robot, time, what); }
  };

  StateGuard(const World& world, LinkedWorld& linked, const std::vector<ObjectId>& robots);

  /// Behind a phase of a block, from any thread: looks at its residents, where their step has ended in it.
  void look(std::size_t batch, int block, Phase phase, long frame);
  /// Then, once all blocks are through: freezes those that went wrong, and holds those that are frozen.
  void freeze(long frame);
  /// A robot that was placed moves again.
  void thaw(ObjectId robot);
  /// Robots by number, as they were given.
  bool frozen(std::size_t robot) const { return robots_[robot].frozen; }
  const std::vector<Fault>& faults() const { return faults_; }
  void archive(StateArchive& archive);

 private:
  struct Robot {
    ObjectId object;
    const Resident* resident;
    bool wrong = false;  ///< found so by look()
    bool frozen = false;
    double since = -1;  ///< when a hand set it going again [s]; -1: never
    Handle<Pose> base, base_last, shown_base, shown_base_last;
    Handle<double> q, shown_q, shown_q_last, placements, placements_shown;
    Pose X_WB{};                   ///< where it is held
    std::vector<double> at{};      ///< joint positions in which it is held
    int level = 0;                 ///< at which `memory` was taken
    std::vector<double> memory{};  ///< all of its variables while it is held
    void archive(StateArchive& archive) { archive(frozen, X_WB, at, level, memory); }
  };
  void forgetSteps();
  std::vector<RecordedStep> stepsOf(const Robot& robot) const;
  void freezeAt(Robot& robot, double time);
  void stop(Robot& robot);
  void hold(Robot& robot);

  const World& world_;
  LinkedWorld& linked_;
  std::vector<Robot> robots_;
  std::vector<BlockRecord> records_;     // of each batch
  std::vector<int> robot_of_;            ///< number among robots_ of each resident; -1: none
  std::atomic<bool> any_wrong_ = false;  ///< since the last freeze()
  int frozen_ = 0;                       ///< how many are
  double time_ = 0;                      ///< of the last freeze() [s]
  std::vector<Fault> faults_;
};

}  // namespace murosimf
