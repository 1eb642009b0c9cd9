#pragma once

/// @file The memory of one block of robots, as kernels see it.
///
/// A block holds W robots of the same structure, robot i in lane i. One column is one property of one subset of
/// objects: [object][component][lane], lanes fastest, so that one register holds the same number of all W robots.
/// Plain structures only: kernels of every instruction set include this file.

namespace murosimf {

enum class MemoryKind { kState, kStep, kSharedConstant, kOwnConstant };

/// Where a column begins, in numbers per lane; resolved once when linking.
struct ColumnRef {
  int offset = -1;
  MemoryKind memory = MemoryKind::kState;
};

/// The four pieces of memory that columns lie in. State is the block's own and contiguous; step memory belongs to the
/// thread; constants are shared by all blocks of a batch where all its robots have equal values, else the block's own.
struct BlockMemory {
  double* piece[4] = {nullptr, nullptr, nullptr, nullptr};
};

/// The step that a pass makes: from t to t + dt.
struct StepTime {
  double t = 0;    ///< simulated time at the beginning [s]
  double dt = 0;   ///< length: the module's own period [s]
  long frame = 0;  ///< number of the frame in which it is made, from 0
  /// Evaluations only: length of the implicit step for which forces also tell how they change with velocity, as added
  /// inertia; 0: they are wanted as they are now [s].
  double implicit = 0;
};

}  // namespace murosimf
