#include "sights.h"

#include <algorithm>
#include <cmath>

#include "plane.h"
#include "vision/lens.h"

namespace murosimf::controllers {

namespace {

using client::Percept, client::ThingKind;

constexpr double kPointSpacing = 0.3;    // of points of a line [m]
constexpr double kRobotHalfWidth = 0.1;  // [m]
constexpr double kNearest = 0.05;        // that is drawn, before the camera [m]

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

}  // namespace

void SightReader::start(const client::RobotDescription& robot) {
  cameras_ = robot.cameras, field_ = robot.field, obstacle_radius_ = robot.course.obstacle_radius;
}

/// A ray that the lens folds back into the picture is not drawn: its pixel shows another one.
void SightReader::draw(const Look& look, Percept::Kind kind, const Vector3& p_C, double half_width,
                       Percepts& out) const {
  const client::CameraDescription& camera = cameras_[static_cast<std::size_t>(look.camera)];
  if (p_C.z < kNearest) return;
  const PlanePoint ray{p_C.x / p_C.z, p_C.y / p_C.z};
  const PixelPoint pixel = toPixel(camera, ray);
  const PlanePoint shown = toRay(camera, pixel);
  if (!(std::fabs(shown.a - ray.a) + std::fabs(shown.b - ray.b) < 1e-3)) return;
  const Point p = onGround(look.X_RC, p_C);
  out.drawn.push_back({kind, look.camera, pixel.u, pixel.v, camera.fx * half_width / p_C.z, norm(p), direction(p)});
}

void SightReader::addLine(const Look& look, const client::SeenThing& thing, Percepts& out) const {
  const Point a = onGround(look.X_RC, thing.p_C), way = onGround(look.X_RC, thing.q_C) - a;
  const double across = wrapAngle(direction(way) + 0.5 * kPi);
  const int count = std::max(1, static_cast<int>(std::lround(norm(way) / kPointSpacing)));
  for (int i = 0; i < count; ++i) {
    const double share = (i + 0.5) / count;
    const Point p = a + share * way;
    out.lines.push_back({p.x, p.y, across});
    draw(look, Percept::Kind::kLinePoint, thing.p_C + (thing.q_C - thing.p_C) * share, 0.5 * field_.line_width, out);
  }
}

void SightReader::addThing(const Look& look, const client::SeenThing& thing, Percepts& out) const {
  const Point p = onGround(look.X_RC, thing.p_C);
  switch (look.kind) {
    case ThingKind::kBall:
      out.balls.push_back({p.x, p.y, deviationAt(norm(p))});
      return draw(look, Percept::Kind::kBall, thing.p_C, field_.ball_radius, out);
    case ThingKind::kRobot:
      out.robots.push_back({p.x, p.y});
      return draw(look, Percept::Kind::kRobot, thing.p_C, kRobotHalfWidth, out);
    case ThingKind::kPost:
      addLandmark(thing, p, out.posts);
      return draw(look, Percept::Kind::kPost, thing.p_C, field_.post_radius, out);
    case ThingKind::kPole:
      addLandmark(thing, p, out.poles);
      return draw(look, Percept::Kind::kPole, thing.p_C, field_.pole_radius, out);
    case ThingKind::kLine:
      return addLine(look, thing, out);
    case ThingKind::kObstacle:
      out.obstacles.push_back({p.x, p.y});
      return draw(look, Percept::Kind::kObstacle, thing.p_C, obstacle_radius_, out);
  }
}

void SightReader::add(std::span<const client::CameraSights> sights, const CameraPast& past, Percepts& out) const {
  for (const client::CameraSights& found : sights) {
    const auto camera = static_cast<std::size_t>(found.camera);
    if (found.camera < 0 || camera >= cameras_.size() || camera >= past.cameras()) continue;
    const Look look{found.camera, past.pose(camera, found.time), found.kind};
    for (const client::SeenThing& thing : found.things) addThing(look, thing, out);
  }
}

}  // namespace murosimf::controllers
