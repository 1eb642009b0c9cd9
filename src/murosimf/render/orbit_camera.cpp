#include "murosimf/render/orbit_camera.h"

#include <algorithm>
#include <cmath>

#include "murosimf/algorithms/ray_caster.h"

namespace murosimf {

namespace {
constexpr double kLowest = 0.03;                      // [m]
constexpr double kNearest = 0.15, kFarthest = 60;     // [m]
constexpr double kSteepest = 1.55, kFlattest = -0.3;  // [rad]
}  // namespace

Pose OrbitCamera::pose() const {
  const SinCos<double> a = sincos(azimuth), e = sincos(elevation);
  Vector3 eye_W = target_W + Vector3{e.cos * a.cos, e.cos * a.sin, e.sin} * distance;
  eye_W.z = max(eye_W.z, kLowest);
  return lookAt(eye_W, target_W);
}

CameraModel OrbitCamera::model(int width, int height) const { return makePinholeCamera(width, height, angle); }

void OrbitCamera::turn(double sideways, double upwards) {
  azimuth = std::remainder(azimuth + sideways, 2 * 3.14159265358979323846);
  elevation = std::clamp(elevation + upwards, kFlattest, kSteepest);
}

void OrbitCamera::pan(double right, double down) {
  const Pose X_WC = pose();
  const double width = 2 * distance * std::tan(angle / 2);
  target_W = target_W - X_WC.rotation.x * (right * width) - X_WC.rotation.y * (down * width);
  target_W.z = std::max(0.0, target_W.z);
}

void OrbitCamera::zoom(double factor) { distance = std::clamp(distance * factor, kNearest, kFarthest); }

Vector3 rayOf(const CameraModel& camera, const Pose& X_WC, ImagePoint place) {
  return X_WC.rotation * Vector3{(place.u - camera.cx) / camera.fx, (place.v - camera.cy) / camera.fy, 1};
}

}  // namespace murosimf
