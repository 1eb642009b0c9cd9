#pragma once

/// @file Numbers over time: any component of any variable of any assembly, a sample a frame.

#include <string>
#include <vector>

#include "murosimf/simulation/simulation.h"

namespace murosimf {

/// Where a number stands: "robots.red.1", "joint_position", "joints", object 3, component 0.
struct NumberPlace {
  ObjectId assembly;
  std::string property, subset;
  int object = 0, component = 0;
  friend bool operator==(const NumberPlace&, const NumberPlace&) = default;
};

/// The number there now; nothing when the assembly has no such variable at its present level of detail.
std::optional<double> numberAt(const LinkedWorld& linked, const NumberPlace& place);

struct Plot {
  NumberPlace place;
  std::string name, unit;
  std::vector<float> times, values;  ///< [s]
};

class Plots final : public FrameObserver {
 public:
  static constexpr std::size_t kMostSamples = 20000;

  void add(const Simulation& simulation, const NumberPlace& place, std::string name, std::string unit);
  void remove(std::size_t index) { plots_.erase(plots_.begin() + static_cast<std::ptrdiff_t>(index)); }
  bool has(const NumberPlace& place) const;
  const std::vector<Plot>& all() const { return plots_; }
  /// When somebody has gone back in time.
  void forgetAfter(double time);
  void afterFrame(Simulation& simulation) override;

 private:
  std::vector<Plot> plots_;
};

}  // namespace murosimf
