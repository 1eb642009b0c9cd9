#include "murosimf/control/snapshot_shelf.h"

#include <algorithm>
#include <stdexcept>

namespace murosimf {

long SnapshotShelf::hold(long frame) {
  auto slot =
      std::find_if(slots_.begin(), slots_.end(), [&](const Slot& s) { return s.holders > 0 && s.frame == frame; });
  if (slot == slots_.end()) {
    slot = std::find_if(slots_.begin(), slots_.end(), [](const Slot& s) { return s.holders == 0; });
    if (slot == slots_.end()) throw std::logic_error("more snapshots are held than there is room for");
    view_.snapshot(frame, slot->scene);
    slot->frame = frame;
  }
  ++slot->holders;
  return slot - slots_.begin();
}

void SnapshotShelf::archive(StateArchive& archive) {
  for (Slot& slot : slots_) {
    archive(slot.holders, slot.frame);
    if (slot.holders == 0) continue;
    for (Drawable& drawable : slot.scene.drawables) archive(drawable.X_WS);
    for (SpatialMotion<double>& motion : slot.scene.motions) archive(motion);
  }
}

}  // namespace murosimf
