#include "murosimf/render/gl/gl_lens.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "murosimf/algorithms/lens_curve.h"

namespace murosimf {

namespace {

double angleBetween(RaySlopes a, RaySlopes b) {
  const Vector3 p{a.x, a.y, 1}, q{b.x, b.y, 1};
  return std::atan2(norm(cross(p, q)), dot(p, q));
}

/// Looked at every few pixels: it changes slowly.
double largestDensity(const RayTable& rays) {
  const int width = rays.camera().width, height = rays.camera().height;
  constexpr int kStep = 8;
  double least = kPi;
  for (int v = 0; v + 1 < height; v += std::clamp(height - 2 - v, 1, kStep))
    for (int u = 0; u + 1 < width; u += std::clamp(width - 2 - u, 1, kStep)) {
      const RaySlopes here = rays.ray(u, v);
      least = std::min({least, angleBetween(here, rays.ray(u + 1, v)), angleBetween(here, rays.ray(u, v + 1))});
    }
  return 1 / least;
}

/// Slopes of all rays and, since a pixel is more than its ray, as much more on each side as one of 64 pixels would be.
SlopeRectangle rectangleOf(const RayTable& rays) {
  SlopeRectangle all = rays.rowRectangles().front();
  for (const SlopeRectangle& row : rays.rowRectangles()) {
    all.x_low = std::min(all.x_low, row.x_low), all.x_high = std::max(all.x_high, row.x_high);
    all.y_low = std::min(all.y_low, row.y_low), all.y_high = std::max(all.y_high, row.y_high);
  }
  const float wider = (all.x_high - all.x_low) / 64, higher = (all.y_high - all.y_low) / 64;
  return {all.x_low - wider, all.x_high + wider, all.y_low - higher, all.y_high + higher};
}

std::array<float, 3> threeOf(double a, double b, double c) {
  return {static_cast<float>(a), static_cast<float>(b), static_cast<float>(c)};
}

}  // namespace

GlLens::GlLens(const RayTable& rays) : table_(rays), seen_(rectangleOf(rays)), density_(largestDensity(rays)) {
  std::vector<float> slopes;
  for (int v = 0; v < camera().height; ++v)
    for (int u = 0; u < camera().width; ++u) {
      const RaySlopes ray = rays.ray(u, v);
      slopes.push_back(static_cast<float>(ray.x)), slopes.push_back(static_cast<float>(ray.y));
      linear_from_ = std::max(linear_from_, std::hypot(ray.x, ray.y));
    }
  linear_from_ = std::max(std::min(linear_from_, camera().linear_from), 1e-3);
  glBindTexture(GL_TEXTURE_2D, rays_.name());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RG32F, camera().width, camera().height, 0, GL_RG, GL_FLOAT, slopes.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

void GlLens::set(const GlProgram& program) const {
  const auto& k = camera().kc;
  const double a = linear_from_, w = camera().width, h = camera().height;
  const bool fisheye = camera().kind == LensKind::kFisheye;
  program.set("fisheye", fisheye ? 1 : 0);
  if (fisheye) {
    program.set("numerator", std::array<float, 4>{static_cast<float>(k[0]), static_cast<float>(k[1]),
                                                  static_cast<float>(k[2]), static_cast<float>(k[3])});
  } else {
    program.set("numerator",
                std::array<float, 4>{static_cast<float>(k[0]), static_cast<float>(k[1]), static_cast<float>(k[4]), 0});
    program.set("denominator", threeOf(k[5], k[6], k[7]));
  }
  const CurvePoint curve = curveAt(camera(), a);
  program.set("curve_beyond", threeOf(curve.value - curve.slope * a, curve.slope, a));
  const auto prism = [&](const char* name, double first, double second) {
    const OfSquare at = thinPrism(camera(), first, second, a * a);
    const double slope = 2 * a * at.derivative;
    program.set(name, std::array<float, 4>{static_cast<float>(first), static_cast<float>(second),
                                           static_cast<float>(at.value - slope * a), static_cast<float>(slope)});
  };
  prism("prism_x", fisheye ? 0 : k[8], fisheye ? 0 : k[9]);
  prism("prism_y", fisheye ? 0 : k[10], fisheye ? 0 : k[11]);
  program.set("tangential", threeOf(fisheye ? 0 : k[2], fisheye ? 0 : k[3], 0));
  // Places in the picture as OpenGL has them, times Z: from -1 to 1, row 0 first.
  program.set("clip_x",
              threeOf(2 * camera().fx / w, 2 * camera().fx * camera().skew / w, (2 * camera().cx + 1) / w - 1));
  program.set("clip_y", threeOf(0, 2 * camera().fy / h, (2 * camera().cy + 1) / h - 1));
}

bool GlLens::misses(const Vector3& p, double radius) const {
  if (p.z < -radius) return true;
  const auto beyond = [&](double across, double slope) {
    return across - slope * p.z > radius * std::sqrt(1 + slope * slope);
  };
  return beyond(p.x, seen_.x_high) || beyond(-p.x, -seen_.x_low) || beyond(p.y, seen_.y_high) ||
         beyond(-p.y, -seen_.y_low);
}

}  // namespace murosimf
