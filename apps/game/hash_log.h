#pragma once

/// @file Hash of the state once a simulated second, for comparing runs.

#include <cstdint>
#include <vector>

#include "murosimf/simulation/simulation.h"

namespace murosimf {

class HashLog final : public FrameObserver {
 public:
  void afterFrame(Simulation& simulation) override;
  const std::vector<std::uint64_t>& hashes() const { return hashes_; }
  void archive(StateArchive& archive) override { archive(hashes_); }

 private:
  std::vector<std::uint64_t> hashes_;
};

}  // namespace murosimf
