#include "murosimf-view/plots.h"

#include <algorithm>

namespace murosimf {

std::optional<double> numberAt(const LinkedWorld& linked, const NumberPlace& place) {
  const auto found = std::find_if(linked.places().begin(), linked.places().end(),
                                  [&](const Place& p) { return p.assembly == place.assembly; });
  if (found == linked.places().end()) return std::nullopt;
  const ColumnLayout* layout =
      linked.batches()[static_cast<std::size_t>(found->batch)].column(place.property, place.subset);
  if (layout == nullptr || layout->ref.memory != MemoryKind::kState) return std::nullopt;
  if (place.object >= layout->objects || place.component >= layout->components) return std::nullopt;
  return linked.numberAt(*found, *layout, place.object, place.component);
}

bool Plots::has(const NumberPlace& place) const {
  return std::any_of(plots_.begin(), plots_.end(), [&](const Plot& plot) { return plot.place == place; });
}

void Plots::add(const Simulation& simulation, const NumberPlace& place, std::string name, std::string unit) {
  if (has(place) || !numberAt(simulation.linked(), place)) return;
  plots_.push_back({place, std::move(name), std::move(unit), {}, {}});
}

void Plots::forgetAfter(double time) {
  for (Plot& plot : plots_) {
    const auto end = std::upper_bound(plot.times.begin(), plot.times.end(), static_cast<float>(time) + 1e-6F);
    plot.values.resize(static_cast<std::size_t>(end - plot.times.begin()));
    plot.times.resize(plot.values.size());
  }
}

void Plots::afterFrame(Simulation& simulation) {
  for (Plot& plot : plots_) {
    const auto time = static_cast<float>(simulation.time());
    if (!plot.times.empty() && plot.times.back() >= time) continue;  // a frame that is run again
    if (plot.times.size() >= kMostSamples) {
      plot.times.erase(plot.times.begin(), plot.times.begin() + kMostSamples / 2);
      plot.values.erase(plot.values.begin(), plot.values.begin() + kMostSamples / 2);
    }
    if (const auto number = numberAt(simulation.linked(), plot.place)) {
      plot.times.push_back(time);
      plot.values.push_back(static_cast<float>(*number));
    }
  }
}

}  // namespace murosimf
