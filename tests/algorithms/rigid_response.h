#pragma once

/// @file Response of a rigid body to impulses: w = I_W^-1 (n - c x f), v_O = f/m - w x c, c from the reference O to the
/// centre of mass.
///
/// The whole robot is one rigid body, whatever body is touched.

#include <algorithm>
#include <vector>

#include "murosimf/algorithms/contact_frame.h"

namespace murosimf {

class RigidResponse final : public Response {
 public:
  /// @param p_WO reference; @param p_WCom centre of mass
  /// @param inverse_inertia_W columns of I_W^-1 about it [1/(kg m^2)], world axes
  RigidResponse(const Vector3& p_WO, double mass, const Vector3& p_WCom, const Rotation3& inverse_inertia_W)
      : Response(p_WO), mass_(mass), p_OCom_W_(p_WCom - p_WO), inverse_inertia_(inverse_inertia_W) {}

  ResponseBlocks respond(std::span<const int>, std::span<int> places) const override {
    for (std::size_t b = 0; b < 6; ++b) column(b, block_.row[b]);
    std::fill(places.begin(), places.end(), 0);
    return {&block_, 1};
  }

 private:
  void column(std::size_t b, double* numbers) const {
    Vector3 impulse[2];  // moment, force
    impulse[b / 3][static_cast<int>(b % 3)] = 1;
    const Vector3 w = inverse_inertia_ * (impulse[0] - cross(p_OCom_W_, impulse[1]));
    const Vector3 v = impulse[1] * (1 / mass_) - cross(w, p_OCom_W_);
    for (int a = 0; a < 3; ++a) numbers[a] = w[a], numbers[3 + a] = v[a];
  }

  double mass_;
  Vector3 p_OCom_W_;
  Rotation3 inverse_inertia_;
  mutable ResponseBlock block_;
};

/// How bodies answer impulses on one another: that of body i to an impulse on body j at n i + j.
inline std::vector<ResponseBlock> blocksOf(const Response& response, std::span<const int> bodies) {
  std::vector<int> places(bodies.size());
  const ResponseBlocks answer = response.respond(bodies, places);
  std::vector<ResponseBlock> blocks;
  for (const int i : places)
    for (const int j : places) blocks.push_back(answer.at(i, j));
  return blocks;
}

}  // namespace murosimf
