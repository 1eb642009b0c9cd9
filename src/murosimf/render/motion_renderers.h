#pragma once

/// @file Renderers of how an object moves: frames of its bodies, the way it has gone, its name.

#include <deque>

#include "murosimf/render/body_places.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

/// Axes of every body: x red, y green, z blue.
class FramesRenderer final : public PropertyRenderer {
 public:
  explicit FramesRenderer(const RenderedObject& object) : places_(object) {}
  void draw(const RenderMoment& now, DrawList& list) override;

 private:
  BodyPlaces places_;
};

/// Where the base has been since it is shown, over the last ten seconds.
class TrajectoryRenderer final : public PropertyRenderer {
 public:
  explicit TrajectoryRenderer(const RenderedObject& object) : places_(object) {}
  void draw(const RenderMoment& now, DrawList& list) override;

 private:
  struct Sample {
    double time;
    Vector3 p_W;
  };
  BodyPlaces places_;
  std::deque<Sample> samples_;
};

/// The object's path over its base.
class NameRenderer final : public PropertyRenderer {
 public:
  explicit NameRenderer(const RenderedObject& object) : places_(object), name_(object.world.path(object.object)) {}
  void draw(const RenderMoment& now, DrawList& list) override;

 private:
  BodyPlaces places_;
  std::string name_;
};

/// What an integrator with error control says of its last frame.
class IntegrationErrorRenderer final : public PropertyRenderer {
 public:
  explicit IntegrationErrorRenderer(const RenderedObject& object);
  static const Module& reads();
  void draw(const RenderMoment& now, DrawList& list) override;

 private:
  BodyPlaces places_;
  Handle<double> error_, substeps_;
};

/// What a camera sees: the edges of its picture, 0.4 m away. Its lens is left out but at the corners.
class CameraRenderer final : public PropertyRenderer {
 public:
  explicit CameraRenderer(const RenderedObject& object);
  void draw(const RenderMoment& now, DrawList& list) override;

 private:
  BodyPlaces places_;
  MountPlace mount_;
  std::vector<Vector3> edges_C_;
};

}  // namespace murosimf
