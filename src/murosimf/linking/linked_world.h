#pragma once

/// @file The world after linking: blocks of columns, and the passes that step them.

#include <algorithm>
#include <deque>
#include <string>
#include <vector>

#include "murosimf/linking/resident.h"

namespace murosimf {

/// One line of the schedule, for people.
struct PassReport {
  std::string assembly;
  int level = 0;
  std::string module;
  Phase phase = Phase::kAdvance;
  double dt = 0;  ///< [s]
  bool scheduled = true;
  std::string unread;  ///< when not scheduled: the variables that nobody reads
};

/// Where an assembly's columns lie.
struct Place {
  ObjectId assembly;
  int batch = -1, block = 0, lane = 0;
};

class LinkedWorld {
 public:
  explicit LinkedWorld(double frame_length) : frame_length_(frame_length) {}

  double frameLength() const { return frame_length_; }
  const std::deque<Batch>& batches() const { return batches_; }
  const std::vector<Place>& places() const { return places_; }  ///< in the order of paths
  const std::vector<PassReport>& passes() const { return reports_; }
  /// All assemblies with all their levels of detail, in the order of paths.
  const std::vector<Resident>& residents() const { return residents_; }
  /// Numbers of step memory that a thread needs to run any block.
  std::size_t stepMemorySize() const;

  /// An assembly's column; an invalid handle when linking did not create it.
  /// @throws std::logic_error when it holds values of another type.
  template <class T>
  Handle<T> handle(ObjectId assembly, const Variable<T>& property, std::string_view of = subset::kSelf) {
    return Handle<T>(watch(assembly, property.name, of, Variable<T>::kComponents));
  }
  /// How many levels of detail an assembly was linked with, and at which it is.
  int levelCount(ObjectId assembly) const;
  int levelOf(ObjectId assembly) const;
  /// The assembly itself, for those who look at its level in every frame: it stays where it is.
  /// @throws std::logic_error for an object that is none
  const Resident& residentOf(ObjectId assembly) const;
  /// Frames between two steps of the slowest of the modules of a level: between them its state is not that of the
  /// moment.
  int longestPeriod(ObjectId assembly, int level) const;
  /// Moves an assembly to another level of detail, between two frames, when it has made its last step on the old one:
  /// variables that both have keep their values, the others begin anew, then the modules of the new level adopt the
  /// state (BlockModule::adopt). Handles and places follow. Allocates nothing; nobody else's numbers change.
  void exchange(ObjectId assembly, int level);
  /// Gives all variables of an assembly the values from before its first step, at the level at which it is.
  void beginAnew(ObjectId assembly);
  const Place& placeOf(const Resident& resident) const {
    return places_[static_cast<std::size_t>(&resident - residents_.data())];
  }
  /// Runs the passes of one phase that are due in this frame, on one block. Step memory lasts until the next call;
  /// debug builds fill it with NaN first.
  void runBlock(Phase phase, const Batch& batch, int block, long frame, double* step_memory) const;
  /// Whether a pass of this phase is due in this frame.
  bool anyDue(Phase phase, const Batch& batch, long frame) const;
  /// Asks the memory for the state of a block that comes next, where the batch is too large to stay in the cache: the
  /// columns of a block are too short and too many for the processor to guess them.
  void fetchState(const Batch& batch, int block) const;
  /// Who stands in the lanes of a block, by their numbers among residents().
  std::span<const int> seatedIn(std::size_t batch, int block) const;
  /// All three phases on all blocks, on this thread: a whole frame where nothing but modules moves anything.
  void runFrame(long frame);

  /// Calls visit(layout, object number, component, value) for every number of an assembly's state, in a fixed order: by
  /// property, then subset.
  template <class Visitor>
  void visitState(const Place& place, Visitor&& visit) const {
    visitColumns(place, [&](const ColumnLayout& layout, int object, int component, double& value) {
      if (layout.storage == Storage::kState) visit(layout, object, component, value);
    });
  }
  /// Calls visit(layout, object number, component, value) for every number of a resident's state at all of its levels,
  /// always as many and in the same order; 0 stands for those that its present level does not have.
  template <class Visitor>
  void visitAllLevels(const Resident& resident, Visitor&& visit) const {
    const Place& place = placeOf(resident);
    for (const auto& layouts : resident.columns) {
      const ColumnLayout* now = layouts[static_cast<std::size_t>(resident.level)];
      const ColumnLayout& any =
          **std::find_if(layouts.begin(), layouts.end(), [](const auto* l) { return l != nullptr; });
      const double* first = now == nullptr ? nullptr : element(place, *now);
      const int width = batches_[static_cast<std::size_t>(place.batch)].width;
      for (int i = 0; i < any.objects; ++i) {
        for (int c = 0; c < any.components; ++c) {
          visit(any, i, c, first == nullptr ? 0.0 : first[(i * any.components + c) * width]);
        }
      }
    }
  }
  /// Calls visit(value) for every number that a continued run needs: state, and what is kept between frames. It may
  /// change them.
  template <class Visitor>
  void visitMemory(const Place& place, Visitor&& visit) const {
    visitColumns(place, [&](const ColumnLayout& layout, int, int, double& value) {
      if (layout.storage != Storage::kOnDemand) visit(value);
    });
    forgetAnswers(place);  // visitors may write
  }

  /// Columns that an assembly has at its present level, and a number of one of them, for those who show them.
  const std::vector<ColumnLayout>& columnsOf(const Place& place) const {
    return batches_[static_cast<std::size_t>(place.batch)].columns;
  }
  double numberAt(const Place& place, const ColumnLayout& layout, int object, int component) const {
    const Batch& batch = batches_[static_cast<std::size_t>(place.batch)];
    if (layout.storage == Storage::kOnDemand) batch.answers[static_cast<std::size_t>(place.block)].give();
    return element(place, layout)[(object * layout.components + component) * batch.width];
  }
  /// What is computed on demand is asked anew: somebody has changed what it follows from.
  void forgetAnswers(const Place& place) const {
    const Batch& batch = batches_[static_cast<std::size_t>(place.batch)];
    if (!batch.answers.empty()) batch.answers[static_cast<std::size_t>(place.block)].forget();
  }

 private:
  friend class Linker;
  template <class Visitor>
  void visitColumns(const Place& place, Visitor&& visit) const {
    const Batch& batch = batches_[static_cast<std::size_t>(place.batch)];
    for (const ColumnLayout& layout : batch.columns) {
      if (layout.ref.memory != MemoryKind::kState) continue;
      double* first = element(place, layout);
      for (int i = 0; i < layout.objects; ++i) {
        for (int c = 0; c < layout.components; ++c) {
          visit(layout, i, c, first[(i * layout.components + c) * batch.width]);
        }
      }
    }
  }
  double* element(const Place& place, const ColumnLayout& layout) const;
  int residentNumber(ObjectId assembly) const;
  const ColumnCell* watch(ObjectId assembly, std::string_view property, std::string_view of, int components);
  Batch& batchOf(const Resident& resident) { return batches_[static_cast<std::size_t>(resident.batch())]; }
  void point(Resident& resident);
  void leave(Resident& resident);
  void enter(Resident& resident, int level);
  void finishSeating();
  std::vector<std::vector<const ColumnLayout*>> stateColumns(const Resident& resident) const;

  double frame_length_;
  std::deque<Batch> batches_;
  std::vector<Resident> residents_;                       // in the order of paths
  std::vector<int> resident_of_;                          // of each object, by number; -1 or beyond: none
  std::vector<std::vector<int>> seats_;                   // of each batch: resident in each lane
  std::vector<Passage> passages_;                         // between any two batches of one assembly
  AlignedDoubles state_one_, step_one_, own_one_, left_;  // of one robot, while it is exchanged
  std::vector<Place> places_;                             // of the residents
  std::vector<PassReport> reports_;
  /// Handles point to these. Those of one robot that one part of the frame asks for stand side by side: of a thousand
  /// robots each would be a miss of the cache else.
  std::deque<ColumnCell> cells_;
  AlignedDoubles step_memory_;  // of runFrame()
};

}  // namespace murosimf
