#pragma once

/// @file A laser scanner or distance sensor of a robot: at its period it measures how far away things are.
///
/// Looks      as cameras do, at a snapshot of the world, on the threads of control software; all rays of a scan at one
///            moment. Rays meet what is drawn (algorithms/range_caster.h), but what is fixed to the sensor's own body
///            and what it hides. A laser scanner tells each ray's distance, a distance sensor the least of its cone.
/// Errors     x the true distance of a reading, e = offset + bias N(0, 1) drawn once a sensor:
///                reading = x + e + (noise + noise_share x) N(0, 1), rounded to steps of `quantum`
///            as of other sensors (sensor_errors.h). What is farther than `largest`, before or with its error, reads
///            plus infinity, what is nearer than `least` minus infinity [ROS REP 117].
/// Random     Numbers are addressed by (seed, path of the sensor, frame, reading).
/// Delay      A scan arrives with the first sensor frame `delay` after it was taken, and keeps the time at which it was
///            taken. At most kMostOnTheWay are on their way at a time.
/// Needs      range_model, range_place, range_period, range_phase and what is wrong with its readings; hidden_rows.
/// Cost       some 5 us for 181 rays among 149 shapes, most of which spheres about them leave out.

#include <span>
#include <vector>

#include "murosimf/algorithms/range_caster.h"
#include "murosimf/math/arrival_queue.h"
#include "murosimf/modules/camera/mounted_camera.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

class RangeSensor final : public MountedCamera {
 public:
  /// @throws std::invalid_argument when a number of the sensor is missing or out of range, in words.
  RangeSensor(const World& world, const SceneView& view, ObjectId robot, ObjectId sensor, std::uint64_t seed,
              double frame_length);

  const RangeModel& model() const { return model_; }
  /// Of the scan that the last deliver() let arrive: its readings [m] and time [s].
  std::span<const double> ranges() const { return arrived_; }
  double time() const { return timeOf(arrived_frame_); }

  bool needsMotion() const override { return false; }
  void order(const RayScene& scene, const MovingCamera& place, long frame) override;
  void look() override;
  bool deliver(long frame) override;
  void archive(StateArchive& archive) override;

  static constexpr std::size_t kMostOnTheWay = 16;

 private:
  struct Order {
    const RayScene* scene = nullptr;
    Pose X_WS;
    long frame = 0;
  };
  double reading(double distance, long frame, std::size_t number) const;

  RangeModel model_;
  RangeCaster caster_;
  double error_ = 0, noise_ = 0, noise_share_ = 0, quantum_ = 0;
  std::uint64_t key_ = 0;
  Order order_;
  std::vector<double> distances_, read_;  // of a scan, before and after its errors
  ArrivalQueue<std::vector<double>> waiting_;
  std::vector<double> arrived_;
  long arrived_frame_ = 0;
};

}  // namespace murosimf
