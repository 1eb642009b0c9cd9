#include "murosimf/modules/camera/oracle_eye.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace murosimf {

namespace {

constexpr int kSmallWidth = 160;        // [px]
constexpr int kAxisPoints = 9;          // of a thing that are tried
constexpr int kHalvings = 40;           // of a step of a line: 1e-13 m
constexpr double kShortestPart = 0.02;  // of a line that is told [m]

Vector3 between(const Vector3& a, const Vector3& b, double share) { return a + (b - a) * share; }

double horizontalDistance(const Vector3& a, const Vector3& b) {
  const double x = b.x - a.x, y = b.y - a.y;
  return sqrt(x * x + y * y);
}

Vector3 toWorld(const OracleTarget& target, const RayScene& scene, const Vector3& p_B) {
  if (target.carrier < 0) return p_B;
  return scene.drawables[static_cast<std::size_t>(target.carrier)].X_WS * (target.X_SB * p_B);
}

}  // namespace

CameraModel shrunkCamera(const CameraModel& camera, int divisor) {
  CameraModel small = camera;
  small.width = std::max(1, camera.width / divisor);
  small.height = std::max(1, camera.height / divisor);
  small.fx /= divisor, small.fy /= divisor;
  small.cx = (camera.cx + 0.5) / divisor - 0.5;
  small.cy = (camera.cy + 0.5) / divisor - 0.5;
  return small;
}

OracleEye::OracleEye(const CameraModel& camera, std::vector<OracleTarget> targets, std::vector<std::uint32_t> hidden,
                     const ErrorsByKind& errors)
    : camera_(camera),
      targets_(std::move(targets)),
      hidden_(std::move(hidden)),
      errors_(errors),
      valid_radius_(validRadius(camera)),
      divisor_(std::max(1, camera.width / kSmallWidth)),
      least_pixels_(std::max(1, static_cast<int>(kLeastPixels / (divisor_ * divisor_)))) {
  const bool hides = std::any_of(errors.begin(), errors.end(), [](const SightErrors& e) { return e.occlusion > 0.5; });
  if (hides) small_rays_ = std::make_unique<const RayTable>(shrunkCamera(camera, divisor_));
  picture_.has_depth = picture_.has_label = false;
  picture_.has_part = true;
  sights_.reserve(2 * targets_.size());
}

std::span<const TrueSight> OracleEye::look(const RayScene& scene, const Pose& X_WC) {
  const View view{&scene, X_WC};
  if (small_rays_ != nullptr) castSmallPicture(view);
  sights_.clear();
  for (int i = 0; i < static_cast<int>(targets_.size()); ++i) {
    if (targets_[static_cast<std::size_t>(i)].kind == SightKind::kLine) {
      lookForLine(view, i);
    } else {
      lookForThing(view, i);
    }
  }
  return sights_;
}

void OracleEye::castSmallPicture(const View& view) {
  castPicture(*small_rays_, *view.scene, view.X_WC, hidden_, {}, prepared_, picture_);
  pixels_.assign(view.scene->drawables.size(), 0);
  for (const std::int32_t part : picture_.part) {
    if (part >= 0) ++pixels_[static_cast<std::size_t>(part)];
  }
}

void OracleEye::lookForThing(const View& view, int target) {
  const OracleTarget& t = targets_[static_cast<std::size_t>(target)];
  const SightErrors& errors = errors_[kindIndex(t.kind)];
  Vector3 a = toWorld(t, *view.scene, t.a);
  const Vector3 b = toWorld(t, *view.scene, t.b);
  if (t.grounded) a.z = 0;
  if (horizontalDistance(a, view.X_WC.translation) > errors.range) return;
  bool in_view = false;
  for (int i = 0; i < kAxisPoints && !in_view; ++i) {
    in_view = placeOf(view, between(a, b, static_cast<double>(i) / (kAxisPoints - 1))).has_value();
  }
  if (!in_view) return;
  if (errors.occlusion > 0.5) {
    int shown = 0;
    for (int i = t.first; i < t.last; ++i) shown += pixels_[static_cast<std::size_t>(i)];
    if (shown < least_pixels_) return;
  }
  sights_.push_back({target, a, a});
}

void OracleEye::lookForLine(const View& view, int target) {
  const OracleTarget& t = targets_[static_cast<std::size_t>(target)];
  const SightErrors& errors = errors_[kindIndex(t.kind)];
  const Vector3 a = toWorld(t, *view.scene, t.a), b = toWorld(t, *view.scene, t.b);
  const int steps = std::max(2, static_cast<int>(std::ceil(norm(b - a) / kLineStep)));
  Vector3 last = a, begin = a;
  bool seen = false;
  for (int i = 0; i <= steps; ++i) {
    const Vector3 p = between(a, b, static_cast<double>(i) / steps);
    const bool now = isSeen(view, p, errors);
    if (now && !seen) begin = i == 0 ? a : endBetween(view, p, last, errors);
    const bool ends = (seen && !now) || (now && i == steps);
    const Vector3 end = now ? b : ends ? endBetween(view, last, p, errors) : p;
    if (ends && norm(end - begin) > kShortestPart) sights_.push_back({target, begin, end});
    seen = now, last = p;
  }
}

/// The last point that is seen on the way to one that is not.
Vector3 OracleEye::endBetween(const View& view, const Vector3& seen, const Vector3& unseen,
                              const SightErrors& errors) const {
  Vector3 inside = seen, outside = unseen;
  for (int i = 0; i < kHalvings; ++i) {
    const Vector3 middle = between(inside, outside, 0.5);
    (isSeen(view, middle, errors) ? inside : outside) = middle;
  }
  return inside;
}

bool OracleEye::isSeen(const View& view, const Vector3& p_W, const SightErrors& errors) const {
  if (horizontalDistance(p_W, view.X_WC.translation) > errors.range) return false;
  const std::optional<ImagePoint> place = placeOf(view, p_W);
  if (!place) return false;
  return errors.occlusion < 0.5 || showsGround(*place);
}

std::optional<ImagePoint> OracleEye::placeOf(const View& view, const Vector3& p_W) const {
  const std::optional<ImagePoint> place = projectPoint(camera_, applyInverse(view.X_WC, p_W), valid_radius_);
  return place && isInPicture(camera_, *place) ? place : std::nullopt;
}

bool OracleEye::showsGround(ImagePoint place) const {
  const int u = static_cast<int>((place.u + 0.5) / divisor_), v = static_cast<int>((place.v + 0.5) / divisor_);
  return picture_.part[picture_.index(std::clamp(u, 0, picture_.width - 1), std::clamp(v, 0, picture_.height - 1))] ==
         kGroundPart;
}

}  // namespace murosimf
