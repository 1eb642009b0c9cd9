#pragma once

/// @file Integrators: modules that step a state by asking other modules for forces and accelerations in it.

#include <vector>

#include "murosimf/linking/module.h"

namespace murosimf {

/// The modules of a batch that run in Phase::kEvaluate, in their order: what an integrator calls as often as its method
/// needs. Before each call the sums to which several modules add (Declaration::accumulates) are cleared.
class Evaluation {
 public:
  Evaluation() = default;
  /// @param sums  numbers per lane at the beginning of step memory that are sums
  Evaluation(std::vector<const BlockModule*> passes, std::size_t sums, int width)
      : passes_(std::move(passes)), sums_(sums * static_cast<std::size_t>(width)) {}

  /// Computes everything for the state that the block holds now. time.implicit is handed on.
  void operator()(const BlockMemory& block, const StepTime& time) const {
    double* sums = block.piece[static_cast<int>(MemoryKind::kStep)];
    for (std::size_t i = 0; i < sums_; ++i) sums[i] = 0;
    for (const BlockModule* pass : passes_) pass->step(block, time);
  }

 private:
  std::vector<const BlockModule*> passes_;
  std::size_t sums_ = 0;
};

/// A module that runs in Phase::kAdvance and owns the inner loop of a robot's motion.
class Integrator : public BlockModule {
 public:
  /// Called once, behind link(), by the linker.
  void use(Evaluation evaluation) { evaluation_ = std::move(evaluation); }

 protected:
  const Evaluation& evaluate() const { return evaluation_; }

 private:
  Evaluation evaluation_;
};

}  // namespace murosimf
