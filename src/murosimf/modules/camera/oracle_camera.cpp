#include "murosimf/modules/camera/oracle_camera.h"

#include <cmath>
#include <utility>

namespace murosimf {

namespace {

std::vector<Landmark> allBut(ObjectId robot, std::span<const Landmark> landmarks) {
  std::vector<Landmark> others;
  for (const Landmark& landmark : landmarks) {
    if (!(landmark.object.valid() && landmark.object == robot)) others.push_back(landmark);
  }
  return others;
}

std::vector<OracleTarget> targetsOf(const SceneView& view, const std::vector<Landmark>& landmarks) {
  std::vector<OracleTarget> targets;
  for (const Landmark& l : landmarks) {
    OracleTarget& t = targets.emplace_back();
    t.kind = l.kind, t.a = l.a, t.b = l.b, t.grounded = l.grounded, t.height = l.height;
    if (!l.object.valid()) continue;
    const SceneView::Drawn drawn = view.drawnOf(l.object);
    t.first = l.shape < 0 ? drawn.first : drawn.first + l.shape;
    t.last = l.shape < 0 ? drawn.last : t.first + 1;
    t.carrier = drawn.carrier, t.X_SB = drawn.X_SB;
  }
  return targets;
}

}  // namespace

OracleCamera::OracleCamera(const World& world, const SceneView& view, ObjectId robot, ObjectId camera,
                           const CameraModel& lens, std::span<const Landmark> landmarks, const OracleSettings& settings,
                           std::uint64_t seed, double frame_length)
    : MountedCamera(world, view, robot, camera, settings.period, settings.phase, frame_length),
      landmarks_(allBut(robot, landmarks)),
      settings_(settings),
      eye_(lens, targetsOf(view, landmarks_), hidden(), settings.errors),
      distorter_(eye_, settings.errors, seed, path(), settings.period) {
  const std::size_t room = 2 * landmarks_.size() + 64;  // lines may be seen in parts
  for (std::size_t k = 0; k < kSightKinds; ++k) {
    const double delay = settings.errors[k].delay;
    const auto most = static_cast<std::size_t>(std::ceil(delay / settings.period)) + 2;
    queues_[k] = true_queues_[k] = {std::lround(delay / frame_length), most, std::vector<Sighting>(room)};
    for (std::vector<Sighting>* list : {&told_[k], &true_[k], &arrived_[k].sightings, &arrived_[k].truth})
      list->reserve(room);
  }
}

void OracleCamera::noteTruth(std::span<const TrueSight> seen, const Pose& X_WC) {
  for (std::vector<Sighting>& sightings : true_) sightings.clear();
  for (const TrueSight& sight : seen) {
    const SightKind kind = eye_.targets()[static_cast<std::size_t>(sight.target)].kind;
    true_[kindIndex(kind)].push_back({sight.target, applyInverse(X_WC, sight.p_W), applyInverse(X_WC, sight.q_W)});
  }
}

void OracleCamera::look() {
  const auto& [scene, X_WC, frame] = order_;
  const LookMoment moment{static_cast<std::uint64_t>(frame + 1), timeOf(frame), X_WC};
  const std::span<const TrueSight> seen = eye_.look(*scene, X_WC);
  distorter_.distort(eye_, seen, moment, told_);
  noteTruth(seen, X_WC);
  for (std::size_t k = 0; k < kSightKinds; ++k) {
    queues_[k].add(told_[k], frame);
    true_queues_[k].add(true_[k], frame);
  }
}

bool OracleCamera::deliver(long frame) {
  arrived_count_ = 0;
  for (std::size_t k = 0; k < kSightKinds; ++k) {
    ArrivedSights& arrived = arrived_[arrived_count_];
    const std::optional<long> taken = queues_[k].next(frame, arrived.sightings);
    if (!taken) continue;
    true_queues_[k].next(frame, arrived.truth);
    arrived.kind = static_cast<SightKind>(k);
    arrived.time = timeOf(*taken);
    ++arrived_count_;
  }
  return arrived_count_ > 0;
}

void OracleCamera::archive(StateArchive& archive) {
  const auto one = [&](std::vector<Sighting>& sightings, long& frame) { archive(sightings, frame); };
  for (std::size_t k = 0; k < kSightKinds; ++k) {
    queues_[k].archive(archive, one);
    true_queues_[k].archive(archive, one);
  }
}

}  // namespace murosimf
