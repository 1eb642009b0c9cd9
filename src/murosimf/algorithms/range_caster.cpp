#include "murosimf/algorithms/range_caster.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "murosimf/algorithms/ray_distance.h"

namespace murosimf {

namespace {
constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kSlack = 1e-9;  // [m] by which a ray may pass outside of a sphere and still be looked at
}  // namespace

RangeCaster::RangeCaster(std::vector<Vector3> directions, double largest, std::vector<std::uint32_t> hidden)
    : directions_(std::move(directions)),
      largest_(largest),
      hidden_(std::move(hidden)),
      flat_(std::all_of(directions_.begin(), directions_.end(), [](const Vector3& d) { return d.z == 0; })) {}

void RangeCaster::cast(const RayScene& scene, const Pose& X_WS, std::span<double> distances) const {
  std::fill(distances.begin(), distances.end(), kNever);
  castGround(X_WS, distances);
  for (const Drawable& thing : scene.drawables) {
    if (std::find(hidden_.begin(), hidden_.end(), thing.owner) == hidden_.end()) castThing(thing, X_WS, distances);
  }
  for (double& distance : distances) {
    if (distance > largest_) distance = kNever;
  }
}

void RangeCaster::castGround(const Pose& X_WS, std::span<double> distances) const {
  const double height = X_WS.translation.z;
  const Vector3 up = applyTransposed(X_WS.rotation, Vector3{0, 0, 1});
  for (std::size_t i = 0; i < distances.size(); ++i) {
    const double sinking = -dot(directions_[i], up);
    if (sinking > 0 && height >= 0) distances[i] = height / sinking;
  }
}

void RangeCaster::castThing(const Drawable& thing, const Pose& X_WS, std::span<double> distances) const {
  const Vector3 centre = applyTransposed(X_WS.rotation, thing.X_WS.translation - X_WS.translation);
  const double radius = boundingRadius(outlineOf(thing)) + kSlack, far = radius + largest_;
  const double square = squaredNorm(centre);
  if (square > far * far || (flat_ && abs(centre.z) > radius)) return;
  const Pose X_TS = inverse(thing.X_WS) * X_WS;
  for (std::size_t i = 0; i < distances.size(); ++i) {
    const double along = dot(directions_[i], centre);
    if (along < -radius || along - radius > distances[i] || square - along * along > radius * radius) continue;
    const Vector3 d = X_TS.rotation * directions_[i];
    const double distance =
        thing.mesh ? rayDistance(*thing.mesh, X_TS.translation, d) : rayDistance(thing.shape, X_TS.translation, d);
    distances[i] = min(distances[i], distance);
  }
}

}  // namespace murosimf
