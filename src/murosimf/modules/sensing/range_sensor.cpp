#include "murosimf/modules/sensing/range_sensor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "murosimf/math/normal_lanes.h"
#include "murosimf/math/random.h"

namespace murosimf {

namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

double numberOf(const World& world, ObjectId sensor, const Constant<double>& property, double least, double largest) {
  const std::optional<double> value = world.find(sensor, property);
  if (value && *value >= least && *value <= largest) return *value;
  throw std::invalid_argument(fmt::format("{} of {} is {}; expected a number from {:g} to {:g} {}", property.name,
                                          world.path(sensor), value ? fmt::format("{:g}", *value) : "no number", least,
                                          largest, property.unit));
}

RangeModel modelOf(const World& world, ObjectId sensor) {
  if (const RangeModel* model = world.findShared(sensor, kRangeModel)) return *model;
  throw std::invalid_argument(fmt::format("range sensor {} has no range_model", world.path(sensor)));
}

}  // namespace

RangeSensor::RangeSensor(const World& world, const SceneView& view, ObjectId robot, ObjectId sensor, std::uint64_t seed,
                         double frame_length)
    : MountedCamera(world, view, robot, sensor, numberOf(world, sensor, kRangePeriod, frame_length, 1e4),
                    numberOf(world, sensor, kRangePhase, 0, 1e7), frame_length, kRangePlace),
      model_(modelOf(world, sensor)),
      caster_(model_.directions, model_.largest, hidden()),
      noise_(numberOf(world, sensor, kRangeNoise, 0, 100)),
      noise_share_(numberOf(world, sensor, kRangeNoiseShare, 0, 10)),
      quantum_(numberOf(world, sensor, kRangeQuantum, 0, 100)),
      key_(RandomStream(seed, path(), hashName("range")).key()),
      distances_(model_.directions.size()),
      read_(static_cast<std::size_t>(model_.readings()), kNever),
      waiting_(std::lround(numberOf(world, sensor, kRangeDelay, 0, 10) / frame_length), kMostOnTheWay, read_),
      arrived_(read_) {
  const RandomStream once(seed, path(), hashName("range_bias"));
  error_ = fma(numberOf(world, sensor, kRangeBias, 0, 100), once.normal(0),
               numberOf(world, sensor, kRangeOffset, -100, 100));
}

void RangeSensor::order(const RayScene& scene, const MovingCamera& place, long frame) {
  order_ = {&scene, place.X_WC, frame};
}

void RangeSensor::look() {
  caster_.cast(*order_.scene, order_.X_WS, distances_);
  if (model_.nearest) distances_.front() = *std::min_element(distances_.begin(), distances_.end());
  for (std::size_t i = 0; i < read_.size(); ++i) read_[i] = reading(distances_[i], order_.frame, i);
  waiting_.add(read_, order_.frame);
}

double RangeSensor::reading(double distance, long frame, std::size_t number) const {
  if (distance > model_.largest) return kNever;
  if (distance < model_.least) return -kNever;
  double read = distance + error_;
  if (noise_ > 0 || noise_share_ > 0) {
    const std::uint64_t pairs = (static_cast<std::uint64_t>(model_.readings()) + 1) / 2;
    const auto pair = normalPair<double>(
        &key_, static_cast<std::uint64_t>(frame + 1) * pairs + static_cast<std::uint64_t>(number / 2));
    read = fma(fma(noise_share_, distance, noise_), number % 2 == 0 ? pair.first : pair.second, read);
  }
  if (quantum_ > 0) read = quantum_ * std::round(read / quantum_);
  return read > model_.largest ? kNever : read < model_.least ? -kNever : read;
}

/// Of several that have come, the newest.
bool RangeSensor::deliver(long frame) {
  bool any = false;
  while (const std::optional<long> taken = waiting_.next(frame, arrived_)) {
    arrived_frame_ = *taken;
    any = true;
  }
  return any;
}

void RangeSensor::archive(StateArchive& archive) {
  waiting_.archive(archive, [&](std::vector<double>& ranges, long& frame) { archive(frame, ranges); });
}

}  // namespace murosimf
