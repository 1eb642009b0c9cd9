#include "camera_past.h"

#include <algorithm>
#include <cmath>

namespace murosimf::controllers {

CameraPast::CameraPast() : ring_(kMost) {}

void CameraPast::remember(double time, const PlanarPose& increment, const Posture& posture) {
  const PlanarPose X_OT = count_ == 0 ? PlanarPose{} : compose(newest().X_OT, increment);
  Step& step = ring_[next_];
  step.time = time, step.X_OT = X_OT;
  step.X_TC = posture.X_RC;
  next_ = (next_ + 1) % kMost;
  count_ = std::min(count_ + 1, wanted_);
}

void CameraPast::expect(double time) {
  if (count_ < 2 || time >= stepBefore(count_ - 1).time) return;
  const double period = newest().time - stepBefore(1).time;
  const double steps = period > 0 ? (newest().time - time) / period : 0;
  const double most = kMost;
  wanted_ = std::max(wanted_, static_cast<std::size_t>(std::clamp(std::ceil(steps) + 2, 0.0, most)));
}

const CameraPast::Step& CameraPast::at(double time) const {
  std::size_t back = 0;
  while (back + 1 < count_ && std::fabs(stepBefore(back + 1).time - time) < std::fabs(stepBefore(back).time - time))
    ++back;
  return stepBefore(back);
}

PlanarPose CameraPast::movedSince(double time) const {
  const Step& then = at(time);
  if (&then == &newest()) return {};
  const PlanarPose& X_OR = newest().X_OT;
  const Point p_T = transformedBack(then.X_OT, {X_OR.x, X_OR.y});
  return {p_T.x, p_T.y, wrapAngle(X_OR.heading - then.X_OT.heading)};
}

Pose CameraPast::pose(std::size_t camera, double time) const {
  const Step& then = at(time);
  if (&then == &newest()) return then.X_TC[camera];  // nothing to round
  const PlanarPose X_TR = movedSince(time);
  return inverse(Pose{rotationZ(X_TR.heading), {X_TR.x, X_TR.y, 0}}) * then.X_TC[camera];
}

void CameraPast::archive(client::StateArchive& archive) {
  archive(count_, wanted_);
  if (archive.loading()) next_ = count_ % kMost;
  for (std::size_t i = count_; i-- > 0;) archive(ring_[(next_ + kMost - 1 - i) % kMost]);
}

}  // namespace murosimf::controllers
