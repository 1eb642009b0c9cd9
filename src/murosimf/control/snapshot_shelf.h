#pragma once

/// @file Snapshots of the world for pictures that are still to be rendered, in memory that is used again and again.

#include <vector>

#include "murosimf/math/state_archive.h"
#include "murosimf/modules/camera/scene_view.h"

namespace murosimf {

/// Used by the frame thread alone; others may read what is held. The view must live as long.
class SnapshotShelf {
 public:
  /// @param most_held  snapshots that are held at the same time, at most
  /// @param with_motions  whether they tell how things move
  SnapshotShelf(const SceneView& view, int most_held, bool with_motions = false)
      : view_(view), slots_(static_cast<std::size_t>(most_held) + 1, Slot{view.initialScene(), 0, -1}) {
    for (Slot& slot : slots_) slot.scene.motions.resize(with_motions ? slot.scene.drawables.size() : 0);
  }

  /// The world at the end of this frame, taken at the first call in a frame, and held until release().
  /// @returns the snapshot's number
  long hold(long frame);
  void release(long number) { --slots_[static_cast<std::size_t>(number)].holders; }
  /// Stays as it is while it is held.
  const RayScene& scene(long number) const { return slots_[static_cast<std::size_t>(number)].scene; }

  void archive(StateArchive& archive);

 private:
  struct Slot {
    RayScene scene;
    int holders = 0;
    long frame = -1;
  };
  const SceneView& view_;
  std::vector<Slot> slots_;
};

}  // namespace murosimf
