#include "murosimf/modules/sensing/force_sensor.h"

#include <fmt/format.h>

#include <stdexcept>

#include "murosimf/linking/links.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

namespace {
constexpr Variable<Vector3> kForceBeyond{"force_beyond", "N", "that a body with all that hangs on it needs",
                                         Storage::kStep};
}  // namespace

void ForceSensor::declare(Declaration& d) const {
  d.runsIn(Phase::kEvaluate);
  d.needs(kTree);
  d.needs(kBodyInertia, subset::kBodies);
  d.needs(kForcePlace, subset::kForceSensors);
  d.reads(kJointTurn, subset::kJoints);
  d.reads(kBodyTwist, subset::kBodies);
  d.reads(kBodyAcceleration, subset::kBodies);
  d.reads(kBodyForce, subset::kBodies);
  d.reads(kContactTouch, subset::kBodies);
  d.readsIfAdded(kContactInertia, subset::kBodies);
  d.adds(kForceBeyond, subset::kBodies);
  d.adds(kSensedForce, subset::kForceSensors);
}

/// From the last one inward, so that each has what hangs on it when its turn comes.
void ForceSensor::findBodiesBeyond() {
  std::vector<bool> inside(rows_.size(), false);
  for (const ForceSensorPlace& place : places_) inside[static_cast<std::size_t>(place.row)] = true;
  for (std::size_t i = 1; i < rows_.size(); ++i) {
    if (inside[static_cast<std::size_t>(rows_[i].parent)]) inside[i] = true;
  }
  for (std::size_t i = rows_.size(); i-- > 1;) {
    if (inside[i]) beyond_.push_back({static_cast<int>(i), inside[static_cast<std::size_t>(rows_[i].parent)]});
  }
}

void ForceSensor::link(Links& links) {
  rows_ = kernelRows(links.shared(kTree));
  for (int i = 0; i < links.count(subset::kForceSensors); ++i) {
    const MountPlace place = links.shared(kForcePlace, subset::kForceSensors, i);
    if (place.row < 1 || place.row >= static_cast<int>(rows_.size())) {
      throw std::invalid_argument(
          fmt::format("force sensor {} on row {}; expected one from 1 to {}", i, place.row, rows_.size() - 1));
    }
    places_.push_back({place.row, kernelPose(place.X_RM)});
  }
  findBodiesBeyond();
  ForceSensorArguments& a = arguments_;
  a.rows = rows_.data();
  a.beyond = beyond_.data(), a.bodies_beyond = static_cast<int>(beyond_.size());
  a.places = places_.data(), a.sensors = static_cast<int>(places_.size());
  a.turn = links.column(kJointTurn, subset::kJoints);
  a.inertia = links.column(kBodyInertia, subset::kBodies);
  a.twist = links.column(kBodyTwist, subset::kBodies);
  a.acceleration = links.column(kBodyAcceleration, subset::kBodies);
  a.force = links.column(kBodyForce, subset::kBodies);
  a.contact_touch = links.column(kContactTouch, subset::kBodies);
  a.contacts = links.has(kContactInertia, subset::kBodies);
  if (a.contacts) a.contact_inertia = links.column(kContactInertia, subset::kBodies);
  a.force_beyond = links.column(kForceBeyond, subset::kBodies);
  a.sensed = links.column(kSensedForce, subset::kForceSensors);
  kernel_ = kernelOfWidth<ForceSensorArguments>(links.width());
}

}  // namespace murosimf
