#pragma once

/// @file Two ways to draw the property `shapes`: what cameras see, and what touches.

#include "murosimf/render/body_places.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

/// The shapes of an object that pass a filter.
class ShapeRenderer : public PropertyRenderer {
 public:
  void draw(const RenderMoment& now, DrawList& list) override;

 protected:
  using Filter = bool (*)(const PlacedShape&);
  ShapeRenderer(const RenderedObject& object, Filter filter);
  /// How a shape is tinted.
  virtual Tint tintOf(const PlacedShape& shape) const = 0;

 private:
  BodyPlaces places_;
  std::vector<PlacedShape> shapes_;
  std::uint32_t label_;
};

/// In its own colours, with a shadow.
class DrawnShapeRenderer final : public ShapeRenderer {
 public:
  explicit DrawnShapeRenderer(const RenderedObject& object);

 private:
  Tint tintOf(const PlacedShape& shape) const override;
};

/// What takes part in contacts: one sees through it.
class CollisionShapeRenderer final : public ShapeRenderer {
 public:
  explicit CollisionShapeRenderer(const RenderedObject& object);

 private:
  Tint tintOf(const PlacedShape& shape) const override;
};

/// Carpet and painted lines: property `ground` of the world's root.
class GroundRenderer final : public PropertyRenderer {
 public:
  explicit GroundRenderer(const RenderedObject& object);
  void draw(const RenderMoment& now, DrawList& list) override;

 private:
  PaintedGround ground_;
};

}  // namespace murosimf
