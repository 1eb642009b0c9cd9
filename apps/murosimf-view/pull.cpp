#include "murosimf-view/pull.h"

#include <algorithm>

#include "murosimf/algorithms/gravity.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

namespace {

constexpr double kRate = 8;    // w [rad/s]
constexpr double kMostG = 20;  // of force over weight

bool isRobot(const Simulation& simulation, ObjectId object) {
  const auto& robots = simulation.participants().robots;
  return std::find(robots.begin(), robots.end(), object) != robots.end();
}

Pose poseOf(Simulation& simulation, ObjectId object, int row) {
  if (isRobot(simulation, object)) return simulation.view().bodyPose(object, row, simulation.frame() - 1);
  return simulation.linked().handle(object, kBasePose).get();
}

}  // namespace

std::string Pull::refusal(Simulation& simulation, ObjectId object) {
  const std::string& path = simulation.world().path(object);
  const auto& free = simulation.participants().free_bodies;
  if (std::find(free.begin(), free.end(), object) != free.end()) return "";
  if (!isRobot(simulation, object)) return path + " feels no pull: it never moves";
  if (simulation.linked().handle(object, kPairForce, subset::kBodies).valid()) return "";
  return path + " feels no pull: at this level of detail its motion is prescribed";
}

Pull::Pull(Simulation& simulation, ObjectId object, int row, const Vector3& p_W)
    : target_W(p_W),
      object_(object),
      row_(row),
      mass_(simulation.world().find(object, kMass).value_or(1.0)),
      p_B_(applyInverse(poseOf(simulation, object, row), p_W)) {}

Vector3 Pull::place(Simulation& simulation) const { return poseOf(simulation, object_, row_) * p_B_; }

void Pull::request(Simulation& simulation, FrameHistory& history) {
  const Vector3 p_W = place(simulation);
  const Vector3 v_W = last_W_ ? (p_W - *last_W_) * (1 / simulation.frameLength()) : Vector3{};
  last_W_ = p_W;
  Vector3 f_W = ((target_W - p_W) * (kRate * kRate) - v_W * (2 * kRate)) * mass_;
  const double most = kMostG * kGravity * mass_, size = norm(f_W);
  if (size > most) f_W = f_W * (most / size);
  Intervention push;
  push.kind = Intervention::Kind::kPush;
  push.object = object_;
  push.level = row_;
  push.pose = {p_W.x, p_W.y, 0}, push.height = p_W.z;
  push.velocity = f_W;
  history.request(push);
}

}  // namespace murosimf
