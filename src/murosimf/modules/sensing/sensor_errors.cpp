#include "murosimf/modules/sensing/sensor_errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace murosimf {

namespace {
constexpr double kLargest = 1e6;     // of offsets, deviations and quanta
constexpr double kTolerance = 1e-9;  // of ratios that are to be whole
}  // namespace

double noiseKey(std::uint64_t seed, std::string_view path) {
  return static_cast<double>(RandomStream(seed, path, hashName("sensors")).key() >> 11);
}

std::vector<ParameterInfo> SensorErrors::parameters(std::string_view unit, bool on_off) {
  std::vector<ParameterInfo> all{{"delay", "s", "from the sample to the reading: whole steps", 0, 0, 1},
                                 {"rate", "1/s", "samples a second, held between; 0: every step", 0, 0, 1e5}};
  if (on_off) return all;
  const std::initializer_list<ParameterInfo> of_numbers{
      {"offset", unit, "added to every number", 0, -kLargest, kLargest},
      {"bias", unit, "standard deviation of what else is added, drawn once a number", 0, 0, kLargest},
      {"noise", unit, "standard deviation of white noise, drawn each sample", 0, 0, kLargest},
      {"quantum", unit, "step of the reading; 0: none", 0, 0, kLargest},
      {"range", unit, "largest size of the reading; 0: no limit", 0, 0, 1e9}};
  all.insert(all.begin(), of_numbers.begin(), of_numbers.end());
  return all;
}

SensorErrors::SensorErrors(const ParameterValues& values, bool on_off)
    : delay_(values["delay"]), rate_(values["rate"]) {
  if (on_off) return;
  offset_ = values["offset"], bias_ = values["bias"];
  arguments_.noise = values["noise"];
  const double quantum = arguments_.quantum = values["quantum"], range = arguments_.largest = values["range"];
  if (quantum == 0 || range == 0) return;
  arguments_.largest = quantum * std::floor(range / quantum + kTolerance);
  if (arguments_.largest > 0) return;
  throw std::invalid_argument(
      fmt::format("range is {}; expected at least one quantum of {}, or 0 for no limit", range, quantum));
}

int SensorErrors::places(double period) const {
  return period > 0 ? 1 + static_cast<int>(std::lround(delay_ / period)) : 1;
}

void SensorErrors::refuseNone(int objects, std::string_view subset_name) {
  if (objects > 0) return;
  std::string what(subset_name);
  std::replace(what.begin(), what.end(), '_', ' ');
  throw std::invalid_argument(fmt::format("the robot has no {}; expected some whose readings could have errors", what));
}

void SensorErrors::finish(const Links& links, std::string_view name, int numbers) {
  const double period = links.period();
  if (rate_ * period > 1 + kTolerance) {
    throw std::invalid_argument(
        fmt::format("rate is {} samples a second; expected at most {}, one a step of {} s", rate_, 1 / period, period));
  }
  arguments_.samples_a_step = rate_ > 0 ? min(rate_ * period, 1.0) : 1.0;
  arguments_.stream = hashName(name);
  arguments_.numbers = numbers;
  arguments_.places = places(period);
  width_ = links.width();
  kernel_ = kernelOfWidth<SensorErrorsArguments>(width_);
}

void SensorErrors::initialise(const BlockMemory& block) const {
  const auto column = [&](ColumnRef ref) { return block.piece[static_cast<int>(ref.memory)] + ref.offset * width_; };
  for (int lane = 0; lane < width_; ++lane) {
    const std::uint64_t key = sensorKey(column(arguments_.key)[lane], mixBits(arguments_.stream));
    for (int i = 0; i < arguments_.numbers; ++i) {
      const double drawn = normalPair<double>(&key, static_cast<std::uint64_t>(i)).first;
      column(arguments_.bias)[i * width_ + lane] = fma(bias_, drawn, offset_);
    }
  }
}

void SensorErrors::adopt(const BlockMemory& one) const { *columnAt<double, double>(one, arguments_.started) = 0; }

}  // namespace murosimf
