#pragma once

/// @file The world after linking: blocks of columns, and the passes that step them.

#include <deque>
#include <string>
#include <vector>

#include "murosimf/linking/batch.h"
#include "murosimf/linking/handle.h"

namespace murosimf {

/// One line of the schedule, for people.
struct PassReport {
  std::string assembly, module;
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
  /// Numbers of step memory that a thread needs to run any block.
  std::size_t stepMemorySize() const;

  /// An assembly's column; an invalid handle when linking did not create it.
  /// @throws std::logic_error when it holds values of another type.
  template <class T>
  Handle<T> handle(ObjectId assembly, const Variable<T>& property, std::string_view of = subset::kSelf) {
    int stride = 1, objects = 0;
    double* first = locate(assembly, property.name, of, Variable<T>::kComponents, stride, objects);
    return {first, stride, objects};
  }
  /// Frames between two updates of a variable of an assembly; 1 when no module writes it.
  int periodOf(ObjectId assembly, std::string_view property) const;
  /// The part of the frame in which it is written; kPrescribe when no module writes it.
  Phase phaseOf(ObjectId assembly, std::string_view property) const;
  /// Runs the passes of one phase that are due in this frame, on one block. Step memory lasts until the next call;
  /// debug builds fill it with NaN first.
  void runBlock(Phase phase, const Batch& batch, int block, long frame, double* step_memory) const;
  /// Same on all blocks, one after the other.
  void run(Phase phase, long frame, double* step_memory) const;
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
  /// Calls visit(value) for every number that a continued run needs: state, and what is kept between frames.
  template <class Visitor>
  void visitMemory(const Place& place, Visitor&& visit) const {
    visitColumns(place, [&](const ColumnLayout&, int, int, double& value) { visit(value); });
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
  const LinkedPass* writerOf(ObjectId assembly, std::string_view property) const;
  double* element(const Place& place, const ColumnLayout& layout) const;
  double* locate(ObjectId assembly, std::string_view property, std::string_view of, int components, int& stride,
                 int& objects);

  double frame_length_;
  std::deque<Batch> batches_;
  std::vector<Place> places_;
  std::vector<PassReport> reports_;
  AlignedDoubles step_memory_;  // of runFrame()
};

}  // namespace murosimf
