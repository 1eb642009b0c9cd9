#pragma once

/// @file Renderers of what holds a robot up and what pushes it. Arrows: 1 m for 100 N.

#include "murosimf/render/body_places.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

/// Property `pair_force`: what other robots, balls, posts and people do to each body; of a moment only its force shows.
class PairForceRenderer final : public PropertyRenderer {
 public:
  explicit PairForceRenderer(const RenderedObject& object);
  void draw(const RenderMoment& now, DrawList& list) override;

 private:
  BodyPlaces places_;
  Handle<SpatialForce<double>> force_;
};

/// Property `sole_pressure`: the ground's normal forces on the corners of the soles.
class SolePressureRenderer final : public PropertyRenderer {
 public:
  explicit SolePressureRenderer(const RenderedObject& object);
  static const Module& reads();
  void draw(const RenderMoment& now, DrawList& list) override;

 private:
  BodyPlaces places_;
  std::vector<SolePlace> soles_;
  Handle<CornerForces<>> pressure_;
};

/// Property `soles`: the smallest convex polygon on the ground about all corners of soles that are within 5 mm of it.
class SupportPolygonRenderer final : public PropertyRenderer {
 public:
  explicit SupportPolygonRenderer(const RenderedObject& object);
  void draw(const RenderMoment& now, DrawList& list) override;

 private:
  BodyPlaces places_;
  std::vector<SolePlace> soles_;
};

/// Corners of the smallest convex polygon about points, counterclockwise; z is not looked at [Andrew 1979].
std::vector<Vector3> convexPolygon(std::vector<Vector3> points);

}  // namespace murosimf
