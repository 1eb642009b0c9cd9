#pragma once

/// @file Errors of sensors, one model for all: what control software reads is not what is.
///
/// Model      Of every number x that a sensor measures a sample is taken `rate` times a second:
///                s = x + b + n,   b = offset + bias N(0, 1) drawn once,   n = noise N(0, 1) drawn each time
///            rounded to steps of `quantum`, held within [-range, range] (in whole quanta) and kept until the next one;
///            the reading is what was kept `delay` ago. Noise is white: samples, numbers and robots are independent.
/// Times      Samples fall on steps of the module, rate times a second on the average, without drift. The delay is
///            rounded to whole steps. Before the first sample could have come, the reading is that first sample.
/// Random     Numbers are addressed by (noise_key of the robot, name of the module, number, frame): the same for any
///            threads and lanes, whatever other robots there are, and after a checkpoint.
/// Phase      kSense, behind all that measures.
/// Needs      noise_key of the robot: noiseKey(seed, path).
/// Adds       NAME_reading; NAME_bias; what is on its way, as state. The value itself stays as it is: servos and the
///            robot's own physics go on with it, the robot port prefers the reading.
/// Errors     a rate faster than the module's steps; a range below one quantum; a sensor that the robot does not have.
/// Exchange   When a robot's level of detail is exchanged, what was on its way is forgotten; biases stay.
/// Cost       5 operations a number; with noise about 60 more a number and sample.

#include "murosimf/linking/links.h"
#include "murosimf/modules/sensing/sensor_errors_kernel.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

/// The noise_key of a robot of a simulation with this seed.
double noiseKey(std::uint64_t seed, std::string_view path);

/// What all of them share; they differ in words alone.
class SensorErrors : public BlockModule {
 public:
  /// @param unit    of what is measured
  /// @param on_off  of sensors that are on or off: they have delay and rate alone
  static std::vector<ParameterInfo> parameters(std::string_view unit, bool on_off);
  /// Draws the biases.
  void initialise(const BlockMemory& block) const override;
  void adopt(const BlockMemory& one) const override;
  void step(const BlockMemory& block, const StepTime& time) const override { kernel_(arguments_, block, time); }

 protected:
  /// @throws std::invalid_argument when the range is less than a quantum
  SensorErrors(const ParameterValues& values, bool on_off);
  /// Values of one number that are kept: as many as are on their way, and the newest.
  int places(double period) const;
  /// @throws std::invalid_argument when there are no objects that could have errors
  static void refuseNone(int objects, std::string_view subset_name);
  void finish(const Links& links, std::string_view name, int numbers);
  SensorErrorsArguments arguments_;

 private:
  double offset_ = 0, bias_ = 0, delay_, rate_;
  int width_ = 1;
  KernelSet<SensorErrorsArguments>::Kernel kernel_ = nullptr;
};

/// The words of one sensor: T is what it measures of each object of a subset.
template <class T>
struct SensorWords {
  using Value = T;
  std::string_view name;  ///< of the module
  std::string_view of;
  Variable<T> truth, reading, bias, samples;
  Variable<double> started;
  bool on_off = false;  ///< 1 or 0: nothing that could be noisy
};

/// The module with these words.
template <const auto& kWords>
class ErrorsOf final : public SensorErrors {
  using Value = typename std::remove_cvref_t<decltype(kWords)>::Value;

 public:
  explicit ErrorsOf(const ParameterValues& values) : SensorErrors(values, kWords.on_off) {}
  static std::vector<ParameterInfo> parameters() { return SensorErrors::parameters(kWords.truth.unit, kWords.on_off); }
  void declare(Declaration& d) const override {
    d.runsIn(Phase::kSense);
    d.needs(kNoiseKey);
    d.reads(kWords.truth, kWords.of);
    d.adds(kWords.reading, kWords.of);
    d.adds(kWords.bias, kWords.of);
    d.addsHistory(kWords.samples, places(d.period()), kWords.of);
    d.adds(kWords.started);
  }
  void link(Links& links) override {
    arguments_.key = links.column(kNoiseKey);
    arguments_.truth = links.column(kWords.truth, kWords.of);
    arguments_.reading = links.column(kWords.reading, kWords.of);
    arguments_.bias = links.column(kWords.bias, kWords.of);
    arguments_.samples = links.column(kWords.samples, kWords.of);
    arguments_.started = links.column(kWords.started);
    constexpr int kNumbers = static_cast<int>(sizeof(Value) / sizeof(double));
    refuseNone(links.count(kWords.of), kWords.of);
    finish(links, kWords.name, links.count(kWords.of) * kNumbers);
  }
};

}  // namespace murosimf
