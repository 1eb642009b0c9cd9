#pragma once

/// @file How much the pair phase had to look at, and what it found: for reports.

#include "murosimf/simulation/simulation.h"

namespace murosimf {

class ContactStatistics final : public FrameObserver {
 public:
  struct Counts {
    long frames = 0;
    long robots = 0;      ///< pairs of robots near enough to look at their bodies, in all frames
    long listed = 0;      ///< pairs of shapes of robots that might touch soon
    long tested = 0;      ///< of them those that were looked at
    long found = 0;       ///< points at which they overlapped
    long most_found = 0;  ///< in one frame
    double deepest = 0;   ///< of them [m]
  };
  void afterFrame(Simulation& simulation) override {
    const RobotPairs::Counts& now = simulation.pairs().counts();
    ++counts_.frames;
    counts_.robots += now.robots;
    counts_.listed += now.listed;
    counts_.tested += now.tested;
    counts_.found += now.found;
    counts_.most_found = now.found > counts_.most_found ? now.found : counts_.most_found;
    if (now.found == 0) return;
    for (const ContactPair& pair : simulation.pairs().contacts().pairs) {
      if (pair.found) counts_.deepest = max(counts_.deepest, pair.contact.depth);
    }
  }
  void archive(StateArchive& archive) override { archive(counts_); }
  const Counts& counts() const { return counts_; }

 private:
  Counts counts_;
};

}  // namespace murosimf
