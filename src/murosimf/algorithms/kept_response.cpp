#include "murosimf/algorithms/kept_response.h"

#include <algorithm>
#include <utility>

namespace murosimf {

KeptResponse::KeptResponse(const TreeResponse::Constants& constants) : response_(constants) {
  constexpr std::size_t kBaseNumbers = 10;
  const std::size_t rows = constants.tree.rows.size();
  now_.reserve(rows + kBaseNumbers), posture_.reserve(rows + kBaseNumbers);
  bodies_.reserve(rows), blocks_.reserve(rows * rows);
}

void KeptResponse::begin(const Vector3& p_WO, std::span<const double> posture, bool joints_yield, Places places) {
  setReference(p_WO);
  now_.assign(posture.begin(), posture.end());
  now_.push_back(joints_yield ? 1 : 0);
  joints_yield_ = joints_yield;
  places_ = std::move(places);
}

bool KeptResponse::holds(std::span<const int> bodies) const {
  if (posture_.size() != now_.size()) return false;
  for (std::size_t i = 0; i < now_.size(); ++i) {
    if (!(abs(now_[i] - posture_[i]) <= kSamePosture)) return false;
  }
  return std::all_of(bodies.begin(), bodies.end(),
                     [&](int body) { return std::find(bodies_.begin(), bodies_.end(), body) != bodies_.end(); });
}

ResponseBlocks KeptResponse::respond(std::span<const int> bodies, std::span<int> places) const {
  if (!holds(bodies)) {
    response_.place(places_(), joints_yield_);
    bodies_.assign(bodies.begin(), bodies.end());
    posture_ = now_;
    blocks_.resize(bodies.size() * bodies.size());
    response_.respond(bodies_, blocks_);
  }
  for (std::size_t i = 0; i < bodies.size(); ++i)
    places[i] = static_cast<int>(std::find(bodies_.begin(), bodies_.end(), bodies[i]) - bodies_.begin());
  return {blocks_.data(), static_cast<int>(bodies_.size())};
}

}  // namespace murosimf
