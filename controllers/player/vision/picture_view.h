#pragma once

/// @file One picture with what is needed to measure in it: pixels, rays, the camera's pose, the field's colours.

#include <optional>

#include "murosimf/control/client/robot_frames.h"
#include "murosimf/math/transform.h"
#include "player/vision/colours.h"
#include "player/vision/ray_table.h"

namespace murosimf::controllers {

struct PictureView {
  const std::uint8_t* rgb = nullptr;
  int camera = 0, width = 0, height = 0;
  const client::CameraDescription* description = nullptr;
  const RayTable* rays = nullptr;
  FieldColours colours;
  Pose X_RC;  ///< camera in the robot's ground frame

  bool inside(int u, int v) const { return u >= 0 && v >= 0 && u < width && v < height; }
  const std::uint8_t* pixel(int u, int v) const { return rgb + 3 * (v * width + u); }
  Colour colour(int u, int v) const { return classify(pixel(u, v), colours); }

  /// Direction of the ray through (u, v), in R; its part along the optical axis is 1.
  Vector3 direction(double u, double v) const { return direction(rays->ray(u, v)); }
  Vector3 direction(const PlanePoint& p) const { return X_RC.rotation * Vector3{p.a, p.b, 1}; }

  /// Where a ray from the camera meets the plane at this height; nothing at or above the horizon.
  std::optional<Vector3> meetPlane(const Vector3& direction_R, double plane_height) const {
    const double drop = X_RC.translation.z - plane_height;
    if (drop <= 0 || direction_R.z > -0.02 * sqrt(squaredNorm(direction_R))) return std::nullopt;
    return X_RC.translation + direction_R * (drop / -direction_R.z);
  }
  std::optional<Vector3> ground(double u, double v) const { return meetPlane(direction(u, v), 0); }

  /// The pixel that shows a point of R; the point must lie in front of the camera.
  PixelPoint project(const Vector3& p_R) const {
    const Vector3 p_C = applyInverse(X_RC, p_R);
    return toPixel(*description, {p_C.x / p_C.z, p_C.y / p_C.z});
  }
};

/// Horizontal length [m].
inline double horizontal(const Vector3& p) { return sqrt(p.x * p.x + p.y * p.y); }

/// Where a coloured area ends when one walks out of it on a straight line.
struct Edge {
  enum class End : std::uint8_t { kFound, kBorder, kTooFar };
  End end = End::kTooFar;
  PixelPoint at;                    ///< between pixels
  Colour outside = Colour::kOther;  ///< two pixels further on
};

/// Walks from (u, v) inside the area along the unit step (du, dv), at most `reach` pixels, until the signal has fallen
/// below half of its mean so far, twice running (once may be noise). The edge is where it crosses the middle between
/// the levels just inside and just outside.
Edge walkToEdge(const PictureView& view, const Signal& signal, PixelPoint from, double du, double dv, int reach);

}  // namespace murosimf::controllers
