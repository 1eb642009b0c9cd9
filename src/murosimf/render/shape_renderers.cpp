#include "murosimf/render/shape_renderers.h"

#include <algorithm>
#include <iterator>
#include <numbers>

namespace murosimf {

namespace {

constexpr double kHorizon = 2e4;  // half size of the surroundings [m]

Tint lit(const Colour& c, float brightness) {
  const auto bright = [&](float x) { return std::min(1.0F, x * brightness); };
  return {bright(c.red), bright(c.green), bright(c.blue)};
}

/// A rectangle by its four corners in turn.
void paintQuad(DrawList& list, const std::array<Vector3, 4>& corners, const Tint& tint) {
  list.paint(corners[0], corners[1], corners[2], tint);
  list.paint(corners[0], corners[2], corners[3], tint);
}

void paintBox(DrawList& list, double half_x, double half_y, const Tint& tint) {
  paintQuad(list, {Vector3{-half_x, -half_y, 0}, {half_x, -half_y, 0}, {half_x, half_y, 0}, {-half_x, half_y, 0}},
            tint);
}

void paintLine(DrawList& list, const PaintedLine& line, const Tint& tint) {
  const Vector3 a{line.a_x, line.a_y, 0}, b{line.b_x, line.b_y, 0}, along = normalized(b - a);
  const Vector3 side = Vector3{-along.y, along.x, 0} * (0.5 * line.width);
  paintQuad(list, {a - side, b - side, b + side, a + side}, tint);
}

void paintCircle(DrawList& list, const PaintedCircle& circle, const Tint& tint) {
  constexpr int kSteps = 64;
  const Vector3 centre{circle.x, circle.y, 0};
  const double inner = max(0.0, circle.radius - 0.5 * circle.width), outer = circle.radius + 0.5 * circle.width;
  const auto direction = [](int step) {
    const SinCos<double> a = sincos(2 * std::numbers::pi * step / kSteps);
    return Vector3{a.cos, a.sin, 0};
  };
  for (int i = 0; i < kSteps; ++i) {
    const Vector3 u = direction(i), v = direction(i + 1);
    paintQuad(list, {centre + u * inner, centre + u * outer, centre + v * outer, centre + v * inner}, tint);
  }
}

}  // namespace

ShapeRenderer::ShapeRenderer(const RenderedObject& object, Filter filter) : places_(object), label_(object.label) {
  if (const auto* shapes = object.world.findShared(object.object, kShapes)) {
    std::copy_if(shapes->begin(), shapes->end(), std::back_inserter(shapes_), filter);
  }
}

void ShapeRenderer::draw(const RenderMoment& now, DrawList& list) {
  for (const PlacedShape& s : shapes_) {
    list.shape(s.shape, s.hull, places_.pose(s.row, now.frame) * s.X_BS, tintOf(s), partId(label_, s.row));
  }
}

DrawnShapeRenderer::DrawnShapeRenderer(const RenderedObject& object)
    : ShapeRenderer(object, [](const PlacedShape& s) { return s.drawn; }) {}

Tint DrawnShapeRenderer::tintOf(const PlacedShape& shape) const { return shape.colour; }

CollisionShapeRenderer::CollisionShapeRenderer(const RenderedObject& object)
    : ShapeRenderer(object, [](const PlacedShape& s) { return s.collides; }) {}

Tint CollisionShapeRenderer::tintOf(const PlacedShape& shape) const {
  const bool feels = shape.touch_sensor >= 0;
  return feels ? Tint{1.0F, 0.8F, 0.1F, 0.5F} : Tint{0.9F, 0.2F, 0.6F, 0.35F};
}

GroundRenderer::GroundRenderer(const RenderedObject& object)
    : ground_(*object.world.findShared(object.object, kGround)) {}

void GroundRenderer::draw(const RenderMoment&, DrawList& list) {
  const float light = ground_.brightness;
  paintBox(list, kHorizon, kHorizon, lit(ground_.surroundings, light));
  paintBox(list, ground_.half_length, ground_.half_width, lit(ground_.carpet, light));
  for (const PaintedLine& line : ground_.lines) paintLine(list, line, lit(ground_.paint, light));
  for (const PaintedCircle& circle : ground_.circles) paintCircle(list, circle, lit(ground_.paint, light));
}

}  // namespace murosimf
