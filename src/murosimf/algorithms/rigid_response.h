#pragma once

/// @file Response of a rigid body to impulses: M_ij = E/m - [r_i]x I_W^-1 [r_j]x, r from the centre of mass to a point.
///
/// For robots with simplified dynamics: the whole robot is one rigid body, whatever body is touched.

#include "murosimf/algorithms/contact_frame.h"

namespace murosimf {

class RigidResponse final : public Response {
 public:
  /// @param p_WCom centre of mass; @param inverse_inertia_W columns of I_W^-1 about it [1/(kg m^2)], world axes
  RigidResponse(double mass, const Vector3& p_WCom, const Rotation3& inverse_inertia_W)
      : mass_(mass), p_WCom_(p_WCom), inverse_inertia_(inverse_inertia_W) {}

  void respond(std::span<const ResponsePoint> points, std::span<double> matrix) const override {
    const std::size_t n = points.size();
    for (std::size_t j = 0; j < n; ++j)
      for (int b = 0; b < 3; ++b) {
        Vector3 impulse;
        impulse[b] = 1;
        const Vector3 w = inverse_inertia_ * cross(points[j].p_W - p_WCom_, impulse);
        for (std::size_t i = 0; i < n; ++i) {
          const Vector3 v = impulse * (1 / mass_) + cross(w, points[i].p_W - p_WCom_);
          for (int a = 0; a < 3; ++a) {
            const std::size_t row = 3 * i + static_cast<std::size_t>(a), column = 3 * j + static_cast<std::size_t>(b);
            matrix[row * 3 * n + column] = v[a];
          }
        }
      }
  }

 private:
  double mass_;
  Vector3 p_WCom_;
  Rotation3 inverse_inertia_;
};

}  // namespace murosimf
