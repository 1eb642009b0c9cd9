#pragma once

/// @file An assembly in the batches: at which levels of detail it may be stepped, and where it is now.

#include <string>
#include <vector>

#include "murosimf/linking/batch.h"
#include "murosimf/linking/handle.h"

namespace murosimf {

/// One level of detail of one assembly: its place among the members of a batch, and what it brings to a lane there.
struct LevelSeat {
  int batch = -1;
  std::vector<double> fresh;  ///< state before the first step, a number per lane
  std::vector<double> own;    ///< constants in which members differ
};

/// Handles on one column of an assembly, at whatever level it is.
struct Watch {
  std::string property, subset;
  std::vector<const ColumnLayout*> layouts;  ///< of each level; null where it has no such column
  std::vector<const LinkedPass*> writers;    ///< of each level; null where no module writes it
  ColumnCell* cell = nullptr;
};

struct Resident {
  ObjectId assembly;
  int level = 0;
  int lane = 0;  ///< in its batch, counted over all blocks
  std::vector<LevelSeat> levels;
  /// State over all levels: each column once, with its layout at each level, null where a level has no such column.
  std::vector<std::vector<const ColumnLayout*>> columns;
  std::vector<Watch> watches;
  int batch() const { return levels[static_cast<std::size_t>(level)].batch; }
};

/// What is carried over between the states of two batches: columns that both have.
struct Passage {
  struct Stretch {
    int from = 0, to = 0, numbers = 0;
  };
  int from = -1, to = -1;
  std::vector<Stretch> stretches;
};

}  // namespace murosimf
