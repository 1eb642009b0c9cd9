#pragma once

/// @file Kernel of touch_sensor.h.

#include "murosimf/algorithms/touch_response.h"
#include "murosimf/linking/kernel.h"

namespace murosimf {

struct TouchSensorArguments {
  const int* rows = nullptr;
  int count = 0;
  ColumnRef response, acceleration, threshold, force, touch;
  bool pushed = false;  ///< whether somebody tells what free bodies do
  ColumnRef push{};
};

void addBaselineKernels(KernelSet<TouchSensorArguments>& kernels);
void addWideKernels(KernelSet<TouchSensorArguments>& kernels);

inline namespace MUROSIMF_ISA {

template <class S>
void touchSensor(const TouchSensorArguments& a, const BlockMemory& block, const StepTime&) {
  const auto* response = columnAt<TouchResponse<S>, S>(block, a.response);
  const auto* acceleration = columnAt<SpatialMotion<S>, S>(block, a.acceleration);
  const S* threshold = columnAt<S, S>(block, a.threshold);
  S *force = columnAt<S, S>(block, a.force), *touch = columnAt<S, S>(block, a.touch);
  for (int i = 0; i < a.count; ++i) {
    force[i] = response[i].force - dot(acceleration[a.rows[i]], response[i].mass);
    if (a.pushed) force[i] += columnAt<S, S>(block, a.push)[i];
    touch[i] = select(force[i] > threshold[i], S(1), S(0));
  }
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
