#include "controllers/vision_trials.h"

namespace murosimf::test {
namespace {

using controllers::LandmarkColour;
using controllers::LandmarkPercept;
using controllers::Percepts;

const client::CameraDescription& description(int camera) {
  static const client::CameraDescription cameras[] = {headCamera(), chestCamera()};
  return cameras[camera];
}

/// Where p_W shows in the picture; off by more than the picture when it is behind.
controllers::PixelPoint projected(const View& view, const Vector3& p_W) {
  const Vector3 p = applyInverse(view.X_WC(), p_W);
  if (p.z < 0.05 || p.x * p.x + p.y * p.y > 2.5 * p.z * p.z) return {-1e4, -1e4};
  return controllers::toPixel(description(view.camera), {p.x / p.z, p.y / p.z});
}
bool inPicture(const View& view, const controllers::PixelPoint& p, double margin) {
  const client::CameraDescription& c = description(view.camera);
  return p.u > margin && p.v > margin && p.u < c.width - 1 - margin && p.v < c.height - 1 - margin;
}
bool shows(const View& view, const Vector3& p_W, int label, double margin = 2) {
  const Vector3 eye = view.X_WC().translation;
  return inPicture(view, projected(view, p_W), margin) && firstHit(view.scene, eye, p_W - eye) == label;
}

const Solid* find(const SyntheticScene& scene, int label) {
  for (const Solid& s : scene.solids) {
    if (s.label == label) return &s;
  }
  return nullptr;
}

/// Share of the ball's outline that is in the picture and not covered.
double visibleBall(const View& view, const Solid& ball) {
  const Vector3 eye = view.X_WC().translation, to = ball.centre - eye;
  const double distance = norm(to), sine = 0.96 * ball.radius / distance;
  const Vector3 c = to * (1 / distance), side = normalized(cross(c, Vector3{0, 0, 1})), up = cross(side, c);
  int visible = 0;
  for (int i = 0; i < 24; ++i) {
    const SinCos<double> a = sincos(2 * kPi / 24 * i);
    const Vector3 d = c * sqrt(1 - sine * sine) + (side * a.cos + up * a.sin) * sine;
    visible += shows(view, eye + d * distance, kBallLabel) ? 1 : 0;
  }
  return visible / 24.0;
}

double distanceOf(const View& view, const Vector3& p) {
  return sqrt(squaredNorm(Vector3{p.x - view.robot.x, p.y - view.robot.y, 0}));
}

void judgeBall(const View& view, const Percepts& percepts, Tally& tally) {
  const Solid* ball = find(view.scene, kBallLabel);
  const Vector3 truth = ball != nullptr ? applyInverse(toPose(view.robot), ball->centre) : Vector3{};
  const double distance = controllers::horizontal(truth);
  bool found = false;
  for (const controllers::BallPercept& b : percepts.balls) {
    ++tally.reported;
    const double error = sqrt((b.x - truth.x) * (b.x - truth.x) + (b.y - truth.y) * (b.y - truth.y));
    if (ball == nullptr || error > 0.15 * distance + 0.05) {
      ++tally.wrong;
      continue;
    }
    found = true;
    const double seen = sqrt(b.x * b.x + b.y * b.y);
    tally.errors.push_back(abs(seen - distance) / distance);
    tally.angles.push_back(abs(wrapAngle(atan2(b.y, b.x) - atan2(truth.y, truth.x))));
  }
  if (ball == nullptr || distance > 3 || visibleBall(view, *ball) < 1) return;
  ++tally.seen;
  tally.found += found ? 1 : 0;
}

struct Landmark {
  int label;
  LandmarkColour colour;
  double height;
};

/// Share of the landmark's axis whose both edges are seen.
double visibleUpright(const View& view, const Solid& s, double height, int label) {
  const Vector3 eye = view.X_WC().translation, to{s.centre.x - eye.x, s.centre.y - eye.y, 0};
  const Vector3 side = normalized(Vector3{-to.y, to.x, 0}) * (0.9 * s.radius);
  int visible = 0;
  for (int i = 0; i < 20; ++i) {
    const Vector3 p{s.centre.x, s.centre.y, height * (0.03 + 0.94 * i / 19)};
    visible += shows(view, p + side, label) && shows(view, p - side, label) ? 1 : 0;
  }
  return visible / 20.0;
}

void judgeLandmarks(const View& view, const std::vector<LandmarkPercept>& percepts, std::span<const Landmark> truth,
                    double least_visible, Tally& tally) {
  std::vector<int> found(truth.size(), 0);
  for (const LandmarkPercept& p : percepts) {
    ++tally.reported;
    bool right = false;
    for (std::size_t i = 0; i < truth.size(); ++i) {
      const Solid& s = *find(view.scene, truth[i].label);
      const Vector3 t = applyInverse(toPose(view.robot), s.centre);
      const double distance = controllers::horizontal(t), bearing = atan2(t.y, t.x);
      const double angle = abs(wrapAngle(p.bearing - bearing)), error = abs(p.distance - distance) / distance;
      if (p.colour != truth[i].colour || angle > 0.06 || error > 0.35) continue;
      right = true;
      found[i] = 1;
      tally.errors.push_back(error);
      tally.angles.push_back(angle);
    }
    tally.wrong += right ? 0 : 1;
  }
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const Solid& s = *find(view.scene, truth[i].label);
    if (distanceOf(view, s.centre) > 4.5 || visibleUpright(view, s, truth[i].height, truth[i].label) < least_visible)
      continue;
    ++tally.seen;
    tally.found += found[i];
  }
}

/// Direction across the nearest line, and the distance from its middle.
struct NearestLine {
  double distance = 1e9, normal = 0;
};
NearestLine nearestLine(const client::FieldDescription& f, double x, double y) {
  NearestLine best;
  auto offer = [&](double d, double normal) {
    if (abs(d) < best.distance) best = {abs(d), normal};
  };
  const double hx = f.length / 2, hy = f.width / 2, r = sqrt(x * x + y * y);
  if (abs(y) < hy + 0.05) offer(abs(x) - hx, 0), offer(x, 0);
  if (abs(x) < hx + 0.05) offer(abs(y) - hy, kPi / 2);
  offer(r - f.centre_circle_radius, atan2(y, x));
  return best;
}

void judgeLines(const View& view, const Percepts& percepts, Tally& tally) {
  for (const controllers::LinePercept& l : percepts.lines) {
    ++tally.reported;
    const Vector3 p = toPose(view.robot) * Vector3{l.x, l.y, 0};
    const NearestLine line = nearestLine(view.scene.field, p.x, p.y);
    const double turned = wrapAngle(2 * (l.normal + view.robot.heading - line.normal)) / 2,
                 distance = sqrt(l.x * l.x + l.y * l.y);
    const bool right = line.distance < 0.03 + 0.03 * distance * distance && abs(turned) < 0.35;
    tally.wrong += right ? 0 : 1;
    if (right) tally.errors.push_back(line.distance), tally.angles.push_back(abs(turned));
  }
}

/// Places on the lines within 2 m that show in the picture: each should have a percept of that line near it.
void countLines(const View& view, const Percepts& percepts, Tally& tally) {
  const client::FieldDescription& f = view.scene.field;
  for (double x = -f.length / 2; x <= f.length / 2; x += 0.15) {
    for (double y = -f.width / 2; y <= f.width / 2; y += 0.15) {
      const NearestLine line = nearestLine(f, x, y);
      const SinCos<double> n = sincos(line.normal);
      Vector3 p{x - line.distance * n.cos, y - line.distance * n.sin, 0};  // onto the line, on one of its sides
      if (nearestLine(f, p.x, p.y).distance > 1e-6) p = {x + line.distance * n.cos, y + line.distance * n.sin, 0};
      if (line.distance > 0.1 || distanceOf(view, p) > 2 || !shows(view, p, kGroundLabel, 20)) continue;
      const Vector3 p_R = applyInverse(toPose(view.robot), p);
      ++tally.seen;
      tally.found += std::any_of(percepts.lines.begin(), percepts.lines.end(), [&](const controllers::LinePercept& l) {
        const double turned = wrapAngle(2 * (l.normal + view.robot.heading - line.normal)) / 2;
        return controllers::horizontal(p_R - Vector3{l.x, l.y, 0}) < 0.35 && abs(turned) < 0.4;
      });
    }
  }
}

void judgeRobots(const View& view, const Percepts& percepts, Tally& tally) {
  std::vector<Vector3> truth;
  std::vector<int> labels;
  for (int label = 40; label < 50; ++label) {
    if (const Solid* s = find(view.scene, label))
      truth.push_back(applyInverse(toPose(view.robot), {s->centre.x, s->centre.y, 0})), labels.push_back(label);
  }
  std::vector<int> found(truth.size(), 0);
  for (const controllers::RobotPercept& r : percepts.robots) {
    ++tally.reported;
    bool right = false;
    for (std::size_t i = 0; i < truth.size(); ++i) {
      const double d = controllers::horizontal(truth[i]),
                   error = controllers::horizontal(truth[i] - Vector3{r.x, r.y, 0});
      if (error > 0.2 + 0.1 * d) continue;
      right = true, found[i] = 1;
      tally.errors.push_back(error);
    }
    tally.wrong += right ? 0 : 1;
  }
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const double d = controllers::horizontal(truth[i]);
    if (d > 3 || d < 0.4) continue;
    int visible = 0, count = 0;
    for (const Solid& s : view.scene.solids) {
      if (s.label != labels[i]) continue;
      ++count;
      visible += shows(view, s.centre, labels[i]) ? 1 : 0;
    }
    if (visible < count) continue;  // all its parts in the picture, nothing before their centres but itself
    ++tally.seen;
    tally.found += found[i];
  }
}

}  // namespace

View randomView(std::uint64_t seed, double gain, int camera) {
  const RandomStream random(seed, "view", 0);
  std::uint64_t n = 0;
  auto in = [&](double low, double high) { return random.uniform(n++, low, high); };
  View view;
  view.scene = emptyField();
  view.scene.gain = gain;
  view.scene.noise = in(3, 5);
  view.scene.seed = seed;
  view.camera = camera;
  view.robot = {in(-2.2, 2.2), in(-1.5, 1.5), in(-kPi, kPi)};
  const double pan = in(-1, 1), tilt = in(-0.1, 0.65), roll = in(-0.06, 0.06);
  view.X_RC = camera == 0 ? headCameraPose(pan, tilt) : chestCameraPose();
  view.X_RC = Pose{rotationX(roll), {}} * view.X_RC;
  // The ball lies where this camera is likely to see it, within 3.5 m.
  const double bearing = camera == 0 ? pan + in(-0.5, 0.5) : in(-0.8, 0.8), distance = in(0.25, 3.5);
  const Vector3 ball = toPose(view.robot) * Vector3{distance * cos(bearing), distance * sin(bearing), 0};
  if (abs(ball.x) < 2.7 && abs(ball.y) < 1.95) addBall(view.scene, ball.x, ball.y);
  for (int i = 0; i < 4; ++i) {
    const PlanarPose robot{in(-2.2, 2.2), in(-1.5, 1.5), in(-kPi, kPi)};
    const bool free = abs(robot.x - view.robot.x) + abs(robot.y - view.robot.y) > 0.6 &&
                      abs(robot.x - ball.x) + abs(robot.y - ball.y) > 0.25;
    if (free) addRobot(view.scene, robot, i % 2 == 0, 40 + i);
  }
  return view;
}

client::RobotDescription observer() {
  client::RobotDescription robot;
  robot.model = "ks21";
  robot.cameras = {headCamera(), chestCamera()};
  robot.field = smallField();
  return robot;
}

Renderer synthesiser() {
  return [](const View& view, std::vector<std::uint8_t>& rgb) {
    static const SyntheticCamera cameras[] = {SyntheticCamera(headCamera()), SyntheticCamera(chestCamera())};
    cameras[view.camera].render(view.scene, view.X_WC(), rgb);
  };
}

void look(controllers::Vision& vision, const View& view, const std::vector<std::uint8_t>& rgb, Percepts& out,
          double tilt) {
  const client::CameraDescription& c = description(view.camera);
  const client::CameraPicture picture{view.camera, 0, c.width, c.height, rgb};
  client::SensorFrame frame;
  frame.pictures = {&picture, 1};
  const Pose X_RC = Pose{rotationY(tilt), {}} * view.X_RC;
  vision.process(frame, std::array{X_RC, X_RC}, out);
}

void judge(const View& view, const Percepts& percepts, Tallies& tallies) {
  judgeBall(view, percepts, tallies.ball);
  const Landmark posts[] = {{10, LandmarkColour::kYellow, 0.9},
                            {11, LandmarkColour::kYellow, 0.9},
                            {20, LandmarkColour::kBlue, 0.9},
                            {21, LandmarkColour::kBlue, 0.9}};
  const Landmark poles[] = {{30, LandmarkColour::kYellow, 0.6}, {31, LandmarkColour::kBlue, 0.6}};
  judgeLandmarks(view, percepts.posts, posts, 0.5, tallies.posts);
  judgeLandmarks(view, percepts.poles, poles, 0.8, tallies.poles);
  judgeLines(view, percepts, tallies.lines);
  countLines(view, percepts, tallies.lines);
  judgeRobots(view, percepts, tallies.robots);
}

Tallies runTrials(const Renderer& render, std::uint64_t first, int count, int camera, const Conditions& conditions) {
  controllers::Vision vision;
  vision.start(observer());
  Tallies tallies;
  controllers::Percepts percepts;
  std::vector<std::uint8_t> rgb;
  for (int i = 0; i < count; ++i) {
    View view = randomView(first + static_cast<std::uint64_t>(i), conditions.gain, camera);
    view.scene.ground_brightness = conditions.ground_brightness;
    render(view, rgb);
    look(vision, view, rgb, percepts, conditions.tilt);
    judge(view, percepts, tallies);
  }
  return tallies;
}

}  // namespace murosimf::test
