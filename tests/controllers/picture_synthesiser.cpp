#include "controllers/picture_synthesiser.h"

#include <algorithm>
#include <optional>

#include "murosimf/math/random.h"

namespace murosimf::test {
namespace {

constexpr double kFar = 1e9;
const Rgb kCarpet{35, 120, 50}, kPaint{235, 235, 235}, kFloor{110, 100, 90}, kSky{150, 160, 175};
const Rgb kOrange{240, 110, 20}, kYellow{230, 200, 30}, kBlue{30, 60, 190};
const Rgb kDarkGrey{60, 60, 65}, kLightGrey{170, 170, 175}, kBlack{25, 25, 25};
const Rgb kMagenta{200, 30, 120}, kCyan{30, 170, 190};

struct Hit {
  double t = kFar;
  Vector3 normal;
};

Hit hitSphere(const Solid& s, const Vector3& p, const Vector3& d) {
  const Vector3 o = p - s.centre;
  const double a = dot(d, d), b = dot(o, d), c = dot(o, o) - s.radius * s.radius, q = b * b - a * c;
  if (q < 0) return {};
  const double t = (-b - sqrt(q)) / a;
  return t > 0 ? Hit{t, normalized(o + d * t)} : Hit{};
}

Hit hitCylinder(const Solid& s, const Vector3& p, const Vector3& d) {
  const Vector3 o = p - s.centre;
  Hit best;
  const double a = d.x * d.x + d.y * d.y, b = o.x * d.x + o.y * d.y;
  const double q = b * b - a * (o.x * o.x + o.y * o.y - s.radius * s.radius);
  if (a > 0 && q >= 0) {
    const double t = (-b - sqrt(q)) / a;
    const Vector3 x = o + d * t;
    if (t > 0 && abs(x.z) <= s.half.z) best = {t, {x.x / s.radius, x.y / s.radius, 0}};
  }
  const double t = d.z < 0 ? (s.half.z - o.z) / d.z : kFar;  // the lid
  const Vector3 x = o + d * t;
  if (t > 0 && t < best.t && x.x * x.x + x.y * x.y <= s.radius * s.radius) best = {t, {0, 0, 1}};
  return best;
}

Hit hitBox(const Solid& s, const Vector3& p, const Vector3& d) {
  const Rotation3 r = rotationZ(s.heading);
  const Vector3 o = applyTransposed(r, p - s.centre), e = applyTransposed(r, d);
  double enter = 0, leave = kFar;
  int axis = -1;
  for (int i = 0; i < 3; ++i) {
    if (abs(e[i]) < 1e-12) {
      if (abs(o[i]) > s.half[i]) return {};
      continue;
    }
    const double t1 = (-s.half[i] - o[i]) / e[i], t2 = (s.half[i] - o[i]) / e[i];
    if (std::min(t1, t2) > enter) enter = std::min(t1, t2), axis = i;
    leave = std::min(leave, std::max(t1, t2));
  }
  if (axis < 0 || enter > leave) return {};
  Vector3 n;
  n[axis] = e[axis] > 0 ? -1 : 1;
  return {enter, r * n};
}

Hit hit(const Solid& s, const Vector3& p, const Vector3& d) {
  switch (s.kind) {
    case Solid::Kind::kSphere:
      return hitSphere(s, p, d);
    case Solid::Kind::kCylinder:
      return hitCylinder(s, p, d);
    default:
      return hitBox(s, p, d);
  }
}

double boundingRadius(const Solid& s) {
  return s.kind == Solid::Kind::kSphere     ? s.radius
         : s.kind == Solid::Kind::kCylinder ? sqrt(s.radius * s.radius + s.half.z * s.half.z)
                                            : norm(s.half);
}

/// Distance from the nearest line's middle to (x, y): all lines of the field are mirrored in both axes.
double distanceToLine(const client::FieldDescription& f, double x, double y) {
  const double hx = f.length / 2, hy = f.width / 2, ax = abs(x), ay = abs(y);
  auto segment = [](double px, double py, double x1, double y1, double x2, double y2) {
    const double dx = x2 - x1, dy = y2 - y1, u = ((px - x1) * dx + (py - y1) * dy) / (dx * dx + dy * dy);
    const double c = std::clamp(u, 0.0, 1.0), ex = px - x1 - c * dx, ey = py - y1 - c * dy;
    return sqrt(ex * ex + ey * ey);
  };
  double d = segment(ax, ay, hx, 0, hx, hy);
  d = std::min(d, segment(ax, ay, 0, hy, hx, hy));
  d = std::min(d, segment(ax, ay, 0, 0, 0, hy));
  d = std::min(d, abs(sqrt(x * x + y * y) - f.centre_circle_radius));
  if (f.goal_area_length > 0) {
    const double gx = hx - f.goal_area_length, gy = f.goal_area_width / 2;
    d = std::min(d, segment(ax, ay, gx, 0, gx, gy));
    d = std::min(d, segment(ax, ay, gx, gy, hx, gy));
  }
  if (f.penalty_mark_distance > 0) {  // a cross of two strokes
    const double mx = ax - (hx - f.penalty_mark_distance), w = f.line_width;
    d = std::min(d, std::max(abs(ay), abs(mx) - w / 2));
    d = std::min(d, std::max(abs(mx), ay - w / 2));
  }
  return d;
}

Rgb groundColour(const SyntheticScene& scene, double x, double y, double footprint) {
  const client::FieldDescription& f = scene.field;
  const double light = scene.ground_brightness;
  if (abs(x) > f.length / 2 + f.border || abs(y) > f.width / 2 + f.border)
    return {kFloor[0] * light, kFloor[1] * light, kFloor[2] * light};
  const double cover = std::clamp(0.5 + (f.line_width / 2 - distanceToLine(f, x, y)) / footprint, 0.0, 1.0);
  Rgb c;
  for (std::size_t i = 0; i < 3; ++i) c[i] = light * (kCarpet[i] + cover * (kPaint[i] - kCarpet[i]));
  return c;
}

Rgb shaded(const Solid& s, const Vector3& normal) {
  const double light = 0.55 + 0.45 * std::max(0.0, dot(normal, normalized(Vector3{0.3, 0.2, 0.93})));
  return {s.colour[0] * light, s.colour[1] * light, s.colour[2] * light};
}

/// Normal deviates, drawn once; pictures take them from hashed places.
const std::vector<float>& deviates() {
  static const std::vector<float> table = [] {
    std::vector<float> t(65536);
    const RandomStream random(7, "noise", 0);
    for (std::size_t i = 0; i < t.size(); ++i) t[i] = static_cast<float>(random.normal(i));
    return t;
  }();
  return table;
}

std::uint8_t exposed(double value, const SyntheticScene& scene, float deviate) {
  const double level = value * scene.gain + scene.noise * static_cast<double>(deviate) + 0.5;
  return static_cast<std::uint8_t>(std::clamp(level, 0.0, 255.0));
}

Solid cylinder(double x, double y, double z, double radius, double half_height, const Rgb& colour, int label) {
  return {Solid::Kind::kCylinder, {x, y, z}, radius, {0, 0, half_height}, 0, colour, label};
}

void addGoal(SyntheticScene& scene, double side, const Rgb& colour, int label) {
  const client::FieldDescription& f = scene.field;
  const double x = side * f.length / 2, y = f.goal_width / 2 + f.post_radius, r = f.post_radius;
  scene.solids.push_back(cylinder(x, y, f.goal_height / 2, r, f.goal_height / 2, colour, label));
  scene.solids.push_back(cylinder(x, -y, f.goal_height / 2, r, f.goal_height / 2, colour, label + 1));
  scene.solids.push_back({Solid::Kind::kBox, {x, 0, f.goal_height + r}, 0, {r, y + r, r}, 0, colour, label + 2});
}

void addPole(SyntheticScene& scene, double y, const Rgb& outer, const Rgb& inner, int label) {
  const client::FieldDescription& f = scene.field;
  const double h = f.pole_height / 6;
  for (int i = 0; i < 3; ++i) {
    scene.solids.push_back(cylinder(0, y, h * (2 * i + 1), f.pole_radius, h, i == 1 ? inner : outer, label));
  }
}

}  // namespace

client::FieldDescription smallField() {
  client::FieldDescription f;
  f.length = 4.5, f.width = 3.0;
  f.goal_width = 1.5, f.goal_height = 0.9, f.goal_depth = 0.5, f.post_radius = 0.05;
  f.line_width = 0.05, f.border = 0.5, f.centre_circle_radius = 0.6;
  f.penalty_mark_distance = 1.5;
  f.ball_radius = 0.07;
  f.pole_radius = 0.1, f.pole_height = 0.6;
  return f;
}

SyntheticScene emptyField() {
  SyntheticScene scene;
  scene.field = smallField();
  addGoal(scene, 1, kYellow, 10);
  addGoal(scene, -1, kBlue, 20);
  const double y = scene.field.width / 2;
  addPole(scene, y, kYellow, kBlue, 30);
  addPole(scene, -y, kBlue, kYellow, 31);
  return scene;
}

void addBall(SyntheticScene& scene, double x, double y, double height_of_centre, double radius) {
  scene.solids.push_back({Solid::Kind::kSphere, {x, y, height_of_centre}, radius, {}, 0, kOrange, kBallLabel});
}

void addRobot(SyntheticScene& scene, const PlanarPose& pose, bool magenta, int label) {
  const Pose X_WR = toPose(pose);
  auto box = [&](const Vector3& centre, const Vector3& edges, const Rgb& colour) {
    scene.solids.push_back({Solid::Kind::kBox, X_WR * centre, 0, edges * 0.5, pose.heading, colour, label});
  };
  const Rgb& mark = magenta ? kMagenta : kCyan;
  for (const double side : {-1.0, 1.0}) {
    box({0.01, side * 0.053, 0.0175}, {0.13, 0.08, 0.035}, kBlack);
    box({-0.01, side * 0.053, 0.14}, {0.05, 0.05, 0.21}, kDarkGrey);
    box({0.02, side * 0.1, 0.34}, {0.05, 0.045, 0.1}, mark);
    box({0.05, side * 0.1, 0.26}, {0.11, 0.03, 0.04}, kLightGrey);
  }
  box({0, 0, 0.28}, {0.09, 0.12, 0.05}, kDarkGrey);
  box({0, 0, 0.365}, {0.1, 0.14, 0.13}, kLightGrey);
  box({0, 0, 0.37}, {0.104, 0.08, 0.06}, mark);
  box({0.01, 0, 0.475}, {0.07, 0.08, 0.07}, kDarkGrey);
}

int firstHit(const SyntheticScene& scene, const Vector3& p_W, const Vector3& d_W) {
  double nearest = d_W.z < 0 ? p_W.z / -d_W.z : kFar;
  int label = d_W.z < 0 ? kGroundLabel : kSkyLabel;
  for (const Solid& s : scene.solids) {
    const Hit h = hit(s, p_W, d_W);
    if (h.t < nearest) nearest = h.t, label = s.label;
  }
  return label;
}

SyntheticCamera::SyntheticCamera(const client::CameraDescription& c) : description_(c) {
  rays_.reserve(static_cast<std::size_t>(c.width * c.height));
  for (int v = 0; v < c.height; ++v) {
    for (int u = 0; u < c.width; ++u) {
      const double yd = (v - c.cy) / c.fy, xd = (u - c.cx) / c.fx - c.skew * yd;
      double a = xd, b = yd;
      for (int i = 0; i < 60; ++i) {  // x <- (xd - tangential(x)) / radial(x), half a step at a time
        const double r2 = a * a + b * b, radial = 1 + c.kc[0] * r2 + c.kc[1] * r2 * r2 + c.kc[4] * r2 * r2 * r2;
        const double ta = 2 * c.kc[2] * a * b + c.kc[3] * (r2 + 2 * a * a);
        const double tb = c.kc[2] * (r2 + 2 * b * b) + 2 * c.kc[3] * a * b;
        a += 0.6 * ((xd - ta) / radial - a);
        b += 0.6 * ((yd - tb) / radial - b);
      }
      rays_.push_back({a, b, 1});
    }
  }
}

void SyntheticCamera::render(const SyntheticScene& scene, const Pose& X_WC, std::vector<std::uint8_t>& rgb) const {
  const int width = description_.width, height = description_.height;
  rgb.resize(static_cast<std::size_t>(3 * width * height));
  const Vector3& p = X_WC.translation;
  const RandomStream random(scene.seed, "pixels", 1);
  std::vector<const Solid*> near;
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      if (u % 32 == 0) {  // what may be seen in the next 32 pixels: bounding spheres against a cone
        near.clear();
        const Vector3 axis = normalized(X_WC.rotation * ray(std::min(u + 16, width - 1), v));
        for (const Solid& s : scene.solids) {
          const Vector3 to = s.centre - p;
          const double along = dot(to, axis), off = sqrt(std::max(0.0, dot(to, to) - along * along));
          const double radius = boundingRadius(s);
          if (off - 0.2 * std::max(along, 0.0) < radius * 1.1 && along > -radius) near.push_back(&s);
        }
      }
      const Vector3 d = X_WC.rotation * ray(u, v);
      Rgb colour = kSky;
      double nearest = kFar;
      for (const Solid* s : near) {
        const Hit h = hit(*s, p, d);
        if (h.t < nearest) nearest = h.t, colour = shaded(*s, h.normal);
      }
      if (d.z < 0 && p.z / -d.z < nearest) {
        const double t = p.z / -d.z, footprint = t / description_.fx * sqrt(norm(d) / -d.z);
        colour = groundColour(scene, p.x + t * d.x, p.y + t * d.y, footprint);
      }
      const std::size_t pixel = static_cast<std::size_t>(v * width + u);
      const std::uint64_t bits = random.bits(pixel);
      for (std::size_t i = 0; i < 3; ++i) {
        rgb[3 * pixel + i] = exposed(colour[i], scene, deviates()[(bits >> (16 * i)) & 0xffff]);
      }
    }
  }
}

client::CameraDescription headCamera() {
  return {"head", 640, 480, 554.26, 554.26, 319.5, 239.5, 0, {-0.30, 0.11, 0.0006, -0.0004, -0.015}, "head", {}, 0.05};
}

client::CameraDescription chestCamera() {
  return {"chest", 320, 240, 134.26, 134.26, 159.5, 119.5, 0, {-0.35, 0.15, 0, 0, 0}, "trunk", {}, 0.1};
}

namespace {

/// C's axes in a body's: x right = -y, y down = -z, z forward = x.
const Rotation3 kCameraAxes{{0, -1, 0}, {0, 0, -1}, {1, 0, 0}};

}  // namespace

Pose headCameraPose(double pan, double tilt) {
  const Pose X_RN{rotationZ(pan), {0, 0, 0.449}};  // neck
  const Pose X_NH{rotationY(tilt), {0.01, 0, 0}};
  return X_RN * (X_NH * Pose{kCameraAxes, {0.036, 0, 0.03}});
}

Pose chestCameraPose() { return {rotationY(20 * kPi / 180) * kCameraAxes, {0.055, 0, 0.354}}; }

}  // namespace murosimf::test
