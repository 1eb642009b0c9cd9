#include "murosimf/modules/contact/shape_travel.h"

#include <algorithm>

namespace murosimf {

namespace {

template <class T>
void fetchAll(std::span<T> values) {
  constexpr std::size_t kLine = 64 / sizeof(T);
  for (std::size_t i = 0; i < values.size(); i += kLine) __builtin_prefetch(&values[i], 1);
}

constexpr std::size_t kTravelNumbers = sizeof(Travel) / sizeof(double);

double difference(const Rotation3& a, const Rotation3& b) {
  return sqrt(squaredNorm(a.x - b.x) + squaredNorm(a.y - b.y) + squaredNorm(a.z - b.z));
}

}  // namespace

std::size_t ShapeTravel::numbersOf(const ContactRobot& robot) {
  return robot.limbs().size() + kTravelNumbers * robot.primitives().size();
}

void ShapeTravel::reserve(const ContactRobot& robot, std::span<double> numbers) {
  std::fill(numbers.begin(), numbers.end(), 0.0);
  q_ = numbers.first(robot.limbs().size());
  travels_ = {reinterpret_cast<Travel*>(numbers.data() + q_.size()), robot.primitives().size()};
}

void ShapeTravel::follow(const ContactRobot& robot, long now, std::span<Way> ways) {
  if (frame_ == now) return;
  const bool followed = frame_ == now - 1 && shapes_ == &robot.shapes() && !robot.isNewHere();
  const bool known = followed && !robot.limbs().empty();
  frame_ = now, shapes_ = &robot.shapes();
  const bool moved = findWays(robot, ways);
  if (moved || !known) add(robot, known, ways);
}

void ShapeTravel::fetch(const ContactRobot& robot) const {
  fetchAll(q_), fetchAll(travels_);
  robot.fetchPosture();
}

/// @return whether the robot has another posture than in the frame before
bool ShapeTravel::findWays(const ContactRobot& robot, std::span<Way> ways) {
  const std::span<const Limb> limbs = robot.limbs();
  if (limbs.empty()) return false;
  const Pose X_WB = robot.stepEnd(0);
  ways[0] = {norm(X_WB.translation - X_WB_.translation), difference(X_WB.rotation, X_WB_.rotation)};
  X_WB_ = X_WB;
  bool moved = ways[0].d + ways[0].a != 0;
  const LaneValues<double> q = robot.jointPositions();
  for (std::size_t i = 1; i < limbs.size(); ++i) {
    const double now = q.get(static_cast<int>(i) - 1), dq = abs(now - q_[i]);
    const double out = limbs[i].turns ? 0 : max(abs(now), abs(q_[i]));
    q_[i] = now;
    moved = moved || dq != 0;
    const Way& parent = ways[static_cast<std::size_t>(limbs[i].parent)];
    const double turn = limbs[i].turns ? dq : 0;
    ways[i] = {parent.d + parent.a * (limbs[i].length + out) + (dq - turn), parent.a + turn};
  }
  return moved;
}

void ShapeTravel::add(const ContactRobot& robot, bool known, std::span<const Way> ways) {
  double longest = known ? 0 : kUnknown;
  for (std::size_t i = 0; i < robot.shapes().size(); ++i) {
    const Obstacle& shape = robot.shapes()[i];
    double way = kUnknown;
    if (known) {
      const Way& body = ways[static_cast<std::size_t>(shape.row)];
      way = body.d + body.a * shape.farthest;
    }
    travels_[i] = {travels_[i].now + way, travels_[i].now};
    longest = max(longest, way);
  }
  longest_ = {longest_.now + longest, longest_.now};
}

}  // namespace murosimf
