#pragma once

/// @file Level of detail "oracle" of a camera: no picture, but what a vision could have found in it.
///
/// Percepts come at the camera's period, from the world's truth through the real lens (oracle_eye.h), with errors that
/// the scenario chooses for each kind (sight_errors.h): behaviour can be tested without, or with any quality of,
/// vision.

#include <memory>
#include <span>
#include <vector>

#include "murosimf/math/arrival_queue.h"
#include "murosimf/modules/camera/mounted_camera.h"
#include "murosimf/modules/camera/sight_distorter.h"

namespace murosimf {

struct OracleSettings {
  double period = 0.05;  ///< between looks [s]
  double phase = 0;      ///< time of the first look [s]
  ErrorsByKind errors;
};

/// What has arrived of one kind: nothing in `sightings` where nothing was seen.
struct ArrivedSights {
  SightKind kind = SightKind::kBall;
  double time = 0;  ///< of the look [s]
  std::vector<Sighting> sightings;
  std::vector<Sighting> truth;  ///< what the look really saw, for those who judge what is made of it
};

class OracleCamera final : public MountedCamera {
 public:
  /// @param landmarks  all there are; the robot itself is left out
  /// @throws std::invalid_argument as MountedCamera does.
  OracleCamera(const World& world, const SceneView& view, ObjectId robot, ObjectId camera, const CameraModel& lens,
               std::span<const Landmark> landmarks, const OracleSettings& settings, std::uint64_t seed,
               double frame_length);

  /// Those that it knows: Sighting::landmark is an index into them.
  const std::vector<Landmark>& landmarks() const { return landmarks_; }
  const CameraModel& model() const { return eye_.camera(); }
  const OracleSettings& settings() const { return settings_; }
  bool needsMotion() const override { return false; }
  void order(const RayScene& scene, const MovingCamera& place, long frame) override {
    order_ = {&scene, place.X_WC, frame};
  }
  void look() override;
  bool deliver(long frame) override;
  /// What the last deliver() let arrive, at most a look of each kind.
  std::span<const ArrivedSights> arrived() const { return std::span(arrived_).first(arrived_count_); }
  void archive(StateArchive& archive) override;

 private:
  struct Order {
    const RayScene* scene = nullptr;
    Pose X_WC;
    long frame = 0;
  };
  void noteTruth(std::span<const TrueSight> seen, const Pose& X_WC);

  std::vector<Landmark> landmarks_;
  OracleSettings settings_;
  Order order_;
  OracleEye eye_;
  SightDistorter distorter_;
  SightingsByKind told_, true_;
  std::array<ArrivalQueue<std::vector<Sighting>>, kSightKinds> queues_, true_queues_;
  std::array<ArrivedSights, kSightKinds> arrived_;
  std::size_t arrived_count_ = 0;
};

}  // namespace murosimf
