#include "murosimf/render/motion_renderers.h"

#include <fmt/format.h>

#include "murosimf/linking/outside_access.h"

namespace murosimf {

namespace {

constexpr double kAxisLength = 0.06;  // [m]
constexpr double kRemembered = 10;    // of a trajectory [s]
constexpr double kAboveBase = 0.3;    // of a name [m]
constexpr double kSightLength = 0.4;  // of a camera's picture [m]
constexpr double kTeleport = 0.2;     // a base does not move this far between two pictures [m]

/// The robot that carries a camera; the object itself for all else.
RenderedObject carrierOf(const RenderedObject& object) {
  return {object.world, object.linked, object.world.parent(object.object), object.label};
}

}  // namespace

void FramesRenderer::draw(const RenderMoment& now, DrawList& list) {
  for (int row = 0; row < places_.rows(); ++row) list.frame(places_.pose(row, now.frame), kAxisLength);
}

void TrajectoryRenderer::draw(const RenderMoment& now, DrawList& list) {
  while (!samples_.empty() && samples_.back().time > now.time) samples_.pop_back();  // somebody went back
  while (!samples_.empty() && samples_.front().time < now.time - kRemembered) samples_.pop_front();
  const Vector3 p_W = places_.pose(0, now.frame).translation;
  if (samples_.empty() || now.time > samples_.back().time) samples_.push_back({now.time, p_W});
  for (std::size_t i = 1; i < samples_.size(); ++i) {
    const Vector3 &a = samples_[i - 1].p_W, &b = samples_[i].p_W;
    const auto fresh = static_cast<float>(1 - (now.time - samples_[i].time) / kRemembered);
    if (norm(b - a) < kTeleport) list.line(a, b, {1.0F, 0.75F, 0.1F, 0.2F + 0.8F * fresh});
  }
}

void NameRenderer::draw(const RenderMoment& now, DrawList& list) {
  list.text(places_.pose(0, now.frame).translation + Vector3{0, 0, kAboveBase}, name_, {1, 1, 1});
}

const Module& IntegrationErrorRenderer::reads() {
  static const OutsideAccess access([](Declaration& d) {
    d.readsIfAdded(kIntegrationError);
    d.readsIfAdded(kSubsteps);
  });
  return access;
}

IntegrationErrorRenderer::IntegrationErrorRenderer(const RenderedObject& object)
    : places_(object),
      error_(object.linked.handle(object.object, kIntegrationError)),
      substeps_(object.linked.handle(object.object, kSubsteps)) {}

void IntegrationErrorRenderer::draw(const RenderMoment& now, DrawList& list) {
  if (!error_.valid()) return;
  list.text(places_.pose(0, now.frame).translation + Vector3{0, 0, kAboveBase + 0.06},
            fmt::format("error {:.1e}, {:.0f} steps", error_.get(), substeps_.valid() ? substeps_.get() : 1.0),
            {1.0F, 0.8F, 0.5F});
}

CameraRenderer::CameraRenderer(const RenderedObject& object) : places_(carrierOf(object)) {
  if (const auto* mount = object.world.findShared(object.object, kCameraPlace)) mount_ = *mount;
  const CameraModel& camera = *object.world.findShared(object.object, kCameraModel);
  const double right = camera.width - 0.5, bottom = camera.height - 0.5;
  for (const ImagePoint place : {ImagePoint{-0.5, -0.5}, {right, -0.5}, {right, bottom}, {-0.5, bottom}}) {
    const RaySlopes ray = unproject(camera, place);
    edges_C_.push_back(Vector3{ray.x, ray.y, 1} * kSightLength);
  }
}

void CameraRenderer::draw(const RenderMoment& now, DrawList& list) {
  const Pose X_WC = places_.pose(mount_.row, now.frame) * mount_.X_RM;
  const Tint tint{0.3F, 0.9F, 1.0F};
  for (std::size_t i = 0; i < edges_C_.size(); ++i) {
    const Vector3 a = X_WC * edges_C_[i], b = X_WC * edges_C_[(i + 1) % edges_C_.size()];
    list.line(X_WC.translation, a, tint);
    list.line(a, b, tint);
  }
}

}  // namespace murosimf
