#include "controllers/cast_pictures.h"

#include <algorithm>
#include <iterator>
#include <memory>

#include "murosimf/algorithms/ray_caster.h"

namespace murosimf::test {
namespace {

CameraModel modelOf(const client::CameraDescription& c) {
  CameraModel m;
  m.width = c.width, m.height = c.height;
  m.fx = c.fx, m.fy = c.fy, m.cx = c.cx, m.cy = c.cy, m.skew = c.skew;
  m.kind = c.lens == client::LensKind::kFisheye ? LensKind::kFisheye : LensKind::kRational;
  std::copy(std::begin(c.kc), std::end(c.kc), m.kc.begin());
  m.linear_from = c.linear_from;
  return m;
}

/// A line through the points, drawn half a width longer at both ends, so that corners are closed.
PaintedLine line(double ax, double ay, double bx, double by, double width) {
  const double dx = bx - ax, dy = by - ay, share = 0.5 * width / sqrt(dx * dx + dy * dy);
  return {ax - share * dx, ay - share * dy, bx + share * dx, by + share * dy, width};
}

PaintedGround groundOf(const client::FieldDescription& f) {
  const double x = f.length / 2, y = f.width / 2, w = f.line_width;
  PaintedGround ground;
  ground.half_length = x + f.border, ground.half_width = y + f.border;
  ground.carpet = {35 / 255.0F, 120 / 255.0F, 50 / 255.0F};
  ground.surroundings = {110 / 255.0F, 100 / 255.0F, 90 / 255.0F};
  ground.paint = {235 / 255.0F, 235 / 255.0F, 235 / 255.0F};
  ground.lines = {line(-x, -y, x, -y, w), line(-x, y, x, y, w), line(-x, -y, -x, y, w), line(x, -y, x, y, w),
                  line(0, -y, 0, y, w)};
  ground.circles = {{0, 0, f.centre_circle_radius, w}};
  if (f.penalty_mark_distance > 0) {
    for (const double mark : {x - f.penalty_mark_distance, f.penalty_mark_distance - x}) {
      ground.lines.push_back({mark - w, 0, mark + w, 0, w});
      ground.lines.push_back({mark, -w, mark, w, w});
    }
  }
  return ground;
}

Drawable drawableOf(const Solid& s) {
  Drawable d;
  switch (s.kind) {
    case Solid::Kind::kSphere:
      d.shape = makeSphere(s.radius);
      break;
    case Solid::Kind::kCylinder:
      d.shape = makeCylinder(s.radius, 2 * s.half.z);
      break;
    case Solid::Kind::kBox:
      d.shape = makeBox(s.half * 2);
      break;
  }
  d.X_WS = {rotationZ(s.heading), s.centre};
  auto channel = [&](std::size_t i) { return static_cast<float>(s.colour[i] / 255); };
  d.colour = {channel(0), channel(1), channel(2)};
  return d;
}

RayScene sceneOf(const SyntheticScene& scene) {
  RayScene cast;
  cast.ground = groundOf(scene.field);
  cast.ground.brightness = static_cast<float>(scene.ground_brightness);
  cast.sky = {150 / 255.0F, 160 / 255.0F, 175 / 255.0F};
  cast.ground_shadows = true;
  for (const Solid& s : scene.solids) cast.drawables.push_back(drawableOf(s));
  return cast;
}

struct Caster {
  std::unique_ptr<RayTable> tables[2] = {std::make_unique<RayTable>(modelOf(headCamera())),
                                         std::make_unique<RayTable>(modelOf(chestCamera()))};
  PreparedScene work;
  Picture picture;
};

}  // namespace

Renderer rayCaster() {
  auto caster = std::make_shared<Caster>();
  caster->picture.has_depth = caster->picture.has_label = false;
  return [caster](const View& view, std::vector<std::uint8_t>& rgb) {
    CastOptions options;
    options.sensor.gain = static_cast<float>(view.scene.gain);
    options.sensor.deviation = static_cast<float>(view.scene.noise / 255);
    options.sensor.key = noiseKey(view.scene.seed, view.camera == 0 ? "head" : "chest", 1);
    castPicture(*caster->tables[view.camera], sceneOf(view.scene), view.X_WC(), {}, options, caster->work,
                caster->picture);
    rgb = caster->picture.rgb;
  };
}

}  // namespace murosimf::test
