#include "sights.h"

#include <algorithm>
#include <cmath>

#include "plane.h"

namespace murosimf::controllers {

namespace {

constexpr double kPointSpacing = 0.3;  // of points of a line [m]

/// Standard deviation of a distance [m].
double deviationAt(double distance) { return 0.02 + 0.03 * distance; }

Point onGround(const Pose& X_RC, const Vector3& p_C) {
  const Vector3 p_R = X_RC * p_C;
  return {p_R.x, p_R.y};
}

void addLandmark(const client::SeenThing& thing, const Point& p, std::vector<LandmarkPercept>& out) {
  if (thing.mark != "yellow" && thing.mark != "blue") return;
  const LandmarkColour colour = thing.mark == "yellow" ? LandmarkColour::kYellow : LandmarkColour::kBlue;
  out.push_back({colour, direction(p), norm(p), 0.02, deviationAt(norm(p)), true});
}

void addLine(const Point& a, const Point& b, std::vector<LinePercept>& out) {
  const Point way = b - a;
  const double across = wrapAngle(direction(way) + 0.5 * kPi);
  const int count = std::max(1, static_cast<int>(std::lround(norm(way) / kPointSpacing)));
  for (int i = 0; i < count; ++i) {
    const Point p = a + ((i + 0.5) / count) * way;
    out.push_back({p.x, p.y, across});
  }
}

void addThing(client::ThingKind kind, const client::SeenThing& thing, const Pose& X_RC, Percepts& out) {
  const Point p = onGround(X_RC, thing.p_C);
  switch (kind) {
    case client::ThingKind::kBall:
      return out.balls.push_back({p.x, p.y, deviationAt(norm(p))});
    case client::ThingKind::kRobot:
      return out.robots.push_back({p.x, p.y});
    case client::ThingKind::kPost:
      return addLandmark(thing, p, out.posts);
    case client::ThingKind::kPole:
      return addLandmark(thing, p, out.poles);
    case client::ThingKind::kLine:
      return addLine(p, onGround(X_RC, thing.q_C), out.lines);
  }
}

}  // namespace

void addSights(std::span<const client::CameraSights> sights, const Posture& posture, Percepts& out) {
  for (const client::CameraSights& found : sights) {
    const auto camera = static_cast<std::size_t>(found.camera);
    if (found.camera < 0 || camera >= posture.X_RC.size()) continue;
    for (const client::SeenThing& thing : found.things) addThing(found.kind, thing, posture.X_RC[camera], out);
  }
}

}  // namespace murosimf::controllers
