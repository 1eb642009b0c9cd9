#include "murosimf/modules/contact/shape_travel.h"

namespace murosimf {

namespace {

double difference(const Rotation3& a, const Rotation3& b) {
  return sqrt(squaredNorm(a.x - b.x) + squaredNorm(a.y - b.y) + squaredNorm(a.z - b.z));
}

}  // namespace

void ShapeTravel::reserve(const ContactRobot& robot) {
  travels_.resize(robot.primitives().size());
  ways_.resize(robot.limbs().size());
  q_.resize(robot.limbs().size());
}

void ShapeTravel::follow(const ContactRobot& robot, long now) {
  if (frame_ == now) return;
  const bool followed = frame_ == now - 1 && shapes_ == &robot.shapes() && !robot.isNewHere();
  const bool known = followed && !robot.limbs().empty();
  frame_ = now, shapes_ = &robot.shapes();
  const bool moved = findWays(robot);
  if (moved || !known) add(robot, known);
}

/// @return whether the robot has another posture than in the frame before
bool ShapeTravel::findWays(const ContactRobot& robot) {
  const std::span<const Limb> limbs = robot.limbs();
  if (limbs.empty()) return false;
  const Pose X_WB = robot.stepEnd(0);
  ways_[0] = {norm(X_WB.translation - X_WB_.translation), difference(X_WB.rotation, X_WB_.rotation)};
  X_WB_ = X_WB;
  bool moved = ways_[0].d + ways_[0].a != 0;
  const LaneValues<double> q = robot.jointPositions();
  for (std::size_t i = 1; i < limbs.size(); ++i) {
    const double now = q.get(static_cast<int>(i) - 1), dq = abs(now - q_[i]);
    const double out = limbs[i].turns ? 0 : max(abs(now), abs(q_[i]));
    q_[i] = now;
    moved = moved || dq != 0;
    const Way& parent = ways_[static_cast<std::size_t>(limbs[i].parent)];
    const double turn = limbs[i].turns ? dq : 0;
    ways_[i] = {parent.d + parent.a * (limbs[i].length + out) + (dq - turn), parent.a + turn};
  }
  return moved;
}

void ShapeTravel::add(const ContactRobot& robot, bool known) {
  double longest = known ? 0 : kUnknown;
  for (std::size_t i = 0; i < robot.shapes().size(); ++i) {
    const Obstacle& shape = robot.shapes()[i];
    double way = kUnknown;
    if (known) {
      const Way& body = ways_[static_cast<std::size_t>(shape.row)];
      way = body.d + body.a * shape.farthest;
    }
    travels_[i] = {travels_[i].now + way, travels_[i].now};
    longest = max(longest, way);
  }
  longest_ = {longest_.now + longest, longest_.now};
}

}  // namespace murosimf
