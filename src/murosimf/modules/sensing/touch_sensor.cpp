#include "murosimf/modules/sensing/touch_sensor.h"

#include <fmt/format.h>

#include <stdexcept>

#include "murosimf/linking/links.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

void TouchSensor::declare(Declaration& d) const {
  d.runsIn(Phase::kEvaluate);
  d.needs(kShapes);
  d.needs(kTouchThreshold, subset::kTouchSensors);
  d.readsSum(kTouchResponse, subset::kTouchSensors);
  d.reads(kBodyAcceleration, subset::kBodies);
  d.readsIfAdded(kPushForce, subset::kTouchSensors);
  d.adds(kTouchForce, subset::kTouchSensors);
  d.adds(kTouch, subset::kTouchSensors);
}

void TouchSensor::link(Links& links) {
  rows_.assign(static_cast<std::size_t>(links.count(subset::kTouchSensors)), -1);
  for (const PlacedShape& shape : links.shared(kShapes)) {
    if (shape.touch_sensor >= 0 && shape.collides) rows_.at(static_cast<std::size_t>(shape.touch_sensor)) = shape.row;
  }
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (rows_[i] < 0) throw std::invalid_argument(fmt::format("no shape that collides has touch sensor {}", i));
  }
  arguments_ = {rows_.data(),
                static_cast<int>(rows_.size()),
                links.column(kTouchResponse, subset::kTouchSensors),
                links.column(kBodyAcceleration, subset::kBodies),
                links.column(kTouchThreshold, subset::kTouchSensors),
                links.column(kTouchForce, subset::kTouchSensors),
                links.column(kTouch, subset::kTouchSensors)};
  arguments_.pushed = links.has(kPushForce, subset::kTouchSensors);
  if (arguments_.pushed) arguments_.push = links.column(kPushForce, subset::kTouchSensors);
  kernel_ = kernelOfWidth<TouchSensorArguments>(links.width());
}

}  // namespace murosimf
