#include "murosimf/render/force_renderers.h"

#include <algorithm>

#include "murosimf/linking/outside_access.h"

namespace murosimf {

namespace {

constexpr double kMetresANewton = 0.01, kShaft = 0.006;  // of arrows
constexpr double kLeastForce = 0.05;                     // that is shown [N]
constexpr double kTouches = 0.005;                       // height below which a corner counts as on the ground [m]
constexpr double kPainted = 0.003;                       // height of lines on the ground [m]

std::vector<SolePlace> solesOf(const RenderedObject& object) {
  const auto* soles = object.world.findShared(object.object, kSoles);
  return soles == nullptr ? std::vector<SolePlace>{} : *soles;
}

/// In the order (-x -y), (+x -y), (-x +y), (+x +y), as forces on corners are.
Vector3 corner(const SolePlace& sole, int k) {
  return {(k & 1) == 0 ? -sole.half_length : sole.half_length, (k & 2) == 0 ? -sole.half_width : sole.half_width, 0};
}

void drawForce(DrawList& list, const Vector3& p_W, const Vector3& f_W, const Tint& tint) {
  if (norm(f_W) < kLeastForce) return;
  list.arrow(p_W, p_W + f_W * kMetresANewton, kShaft, tint);
}

/// > 0 when a, b, c turn to the left.
double turnOf(const Vector3& a, const Vector3& b, const Vector3& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

}  // namespace

std::vector<Vector3> convexPolygon(std::vector<Vector3> points) {
  std::sort(points.begin(), points.end(),
            [](const Vector3& a, const Vector3& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  if (points.size() < 3) return points;
  std::vector<Vector3> polygon;
  for (int side = 0; side < 2; ++side) {  // lower chain, then upper chain
    const std::size_t begin = polygon.size();
    for (const Vector3& p : points) {
      while (polygon.size() >= begin + 2 && turnOf(polygon[polygon.size() - 2], polygon.back(), p) <= 0) {
        polygon.pop_back();
      }
      polygon.push_back(p);
    }
    polygon.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return polygon;
}

PairForceRenderer::PairForceRenderer(const RenderedObject& object)
    : places_(object), force_(object.linked.handle(object.object, kPairForce, subset::kBodies)) {}

void PairForceRenderer::draw(const RenderMoment& now, DrawList& list) {
  if (!force_.valid()) return;
  for (int row = 0; row < force_.size(); ++row) {
    const Pose X_WB = places_.pose(row, now.frame);
    drawForce(list, X_WB.translation, X_WB.rotation * force_.get(row).f, {0.95F, 0.2F, 0.9F});
  }
}

const Module& SolePressureRenderer::reads() {
  static const OutsideAccess access([](Declaration& d) { d.readsIfAdded(kSolePressure, subset::kSoles); });
  return access;
}

SolePressureRenderer::SolePressureRenderer(const RenderedObject& object)
    : places_(object),
      soles_(solesOf(object)),
      pressure_(object.linked.handle(object.object, kSolePressure, subset::kSoles)) {}

void SolePressureRenderer::draw(const RenderMoment& now, DrawList& list) {
  if (!pressure_.valid()) return;
  for (std::size_t s = 0; s < soles_.size(); ++s) {
    const Pose X_WS = places_.pose(soles_[s].mount.row, now.frame) * soles_[s].mount.X_RM;
    const CornerForces<> forces = pressure_.get(static_cast<int>(s));
    for (int k = 0; k < 4; ++k) drawForce(list, X_WS * corner(soles_[s], k), {0, 0, forces.of[k]}, {0.2F, 0.95F, 0.4F});
  }
}

SupportPolygonRenderer::SupportPolygonRenderer(const RenderedObject& object)
    : places_(object), soles_(solesOf(object)) {}

void SupportPolygonRenderer::draw(const RenderMoment& now, DrawList& list) {
  std::vector<Vector3> touching;
  for (const SolePlace& sole : soles_) {
    const Pose X_WS = places_.pose(sole.mount.row, now.frame) * sole.mount.X_RM;
    for (int k = 0; k < 4; ++k) {
      const Vector3 p_W = X_WS * corner(sole, k);
      if (p_W.z < kTouches) touching.push_back({p_W.x, p_W.y, kPainted});
    }
  }
  const std::vector<Vector3> polygon = convexPolygon(touching);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector3& next = polygon[(i + 1) % polygon.size()];
    list.rod(polygon[i], next, 0.003, {0.1F, 0.9F, 0.9F});
    if (i >= 2) list.paint(polygon[0], polygon[i - 1], polygon[i], {0.1F, 0.9F, 0.9F, 0.35F});
  }
}

}  // namespace murosimf
