#pragma once

/// @file Batches: robots of the same structure with the same modules, stepped together in blocks of lanes.

#include <cstdlib>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "murosimf/linking/block_answers.h"
#include "murosimf/linking/module.h"

namespace murosimf {

/// Doubles at an address divisible by 64, the size of the widest register and of a cache line; many of them, in large
/// pages where the system has any.
class AlignedDoubles {
 public:
  AlignedDoubles() = default;
  /// Numbers that nobody has written yet are not a number.
  explicit AlignedDoubles(std::size_t count);
  double* data() const { return data_.get(); }
  std::size_t size() const { return size_; }

 private:
  struct Free {
    void operator()(double* p) const { std::free(p); }
  };
  std::unique_ptr<double, Free> data_;
  std::size_t size_ = 0;
};

/// A piece of memory for each block of a batch, one behind the other: a frame walks through all of them.
class BlockPieces {
 public:
  BlockPieces() = default;
  BlockPieces(std::size_t blocks, std::size_t numbers)
      : blocks_(blocks), numbers_(numbers), stride_((numbers + 7) / 8 * 8), all_(blocks * stride_) {}
  std::size_t size() const { return blocks_; }
  std::span<double> operator[](std::size_t block) const { return {all_.data() + block * stride_, numbers_}; }

 private:
  std::size_t blocks_ = 0, numbers_ = 0, stride_ = 0;
  AlignedDoubles all_;
};

/// One property of one subset, as laid out in the blocks of a batch.
struct ColumnLayout {
  std::string property, unit, subset;
  ColumnRef ref;
  int objects = 0, components = 0;
  Storage storage = Storage::kState;
  std::vector<double> initial;
  int writer = -1;  ///< pass that adds it, by number; -1: none
};

/// One module linked to a batch.
struct LinkedPass {
  std::unique_ptr<BlockModule> module;
  std::string name;
  Phase phase = Phase::kAdvance;
  int period = 1;         ///< in frames
  double dt = 0;          ///< in seconds
  bool scheduled = true;  ///< false: nobody reads what it would compute
  bool answers = false;   ///< adds variables that are computed on demand
};

/// Robots stepped together, in the first `seated` lanes of its blocks. The lanes behind them carry what was there last,
/// or a robot that nobody commands or places: computed with the others, seen by nobody.
struct Batch {
  std::vector<ObjectId> members;  ///< all that may be stepped here; those that begin here first
  int seated = 0;                 ///< how many are now
  int width = 1;
  std::vector<LinkedPass> passes;  ///< in the order in which they run
  std::vector<ColumnLayout> columns;
  std::size_t state_size = 0, step_size = 0, own_size = 0;  ///< numbers per lane
  std::size_t on_demand_size = 0;  ///< of them at the end of state: variables on demand, which no frame touches
  std::size_t sum_size = 0;        ///< of them at the beginning of step memory: sums, cleared before each evaluation
  BlockPieces state, own;
  AlignedDoubles shared;                      ///< constants equal for all members
  AlignedDoubles shared_one;                  ///< the same for one robot alone
  mutable std::vector<BlockAnswers> answers;  ///< of each block; empty where nothing is computed on demand

  /// Blocks in which somebody is seated.
  int blockCount() const { return (seated + width - 1) / width; }
  /// Blocks for all members.
  int capacity() const { return static_cast<int>(state.size()); }
  BlockMemory block(int index, double* step_memory) const {
    const auto i = static_cast<std::size_t>(index);
    return {{state[i].data(), step_memory, shared.data(), own[i].data()}};
  }
  const ColumnLayout* column(std::string_view property, std::string_view subset) const;
};

}  // namespace murosimf
