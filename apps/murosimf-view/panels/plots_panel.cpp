#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "murosimf-view/panels/all_panels.h"

namespace murosimf {

namespace {

/// What is drawn of a plot: the samples of the last seconds, and their range.
struct Range {
  std::size_t first = 0;
  float low = 0, high = 0;
};

Range rangeOf(const Plot& plot, float from) {
  Range range;
  range.first =
      static_cast<std::size_t>(std::lower_bound(plot.times.begin(), plot.times.end(), from) - plot.times.begin());
  if (range.first >= plot.values.size()) return range;
  const auto [low, high] =
      std::minmax_element(plot.values.begin() + static_cast<std::ptrdiff_t>(range.first), plot.values.end());
  range.low = *low, range.high = *high;
  const float least = std::max(1e-9F, 1e-4F * std::max(std::abs(range.low), std::abs(range.high)));
  if (range.high - range.low < least) range.low -= least, range.high += least;
  return range;
}

class PlotsPanel final : public Panel {
 public:
  PlotsPanel() : Panel("Plots", {0.24F, 0.66F, 0.54F, 0.34F}, false) {}

 private:
  void draw(Session& session, SceneViewport&) override {
    const auto& plots = session.plots().all();
    ImGui::SetNextItemWidth(160);
    ImGui::SliderFloat("seconds shown", &seconds_, 0.2F, 20, "%.1f", ImGuiSliderFlags_Logarithmic);
    ui::remember(named("seconds shown"));
    const auto now = static_cast<float>(session.simulation().time());
    ImGui::SameLine();
    ImGui::TextDisabled("until T %.2f s", static_cast<double>(now));
    if (plots.empty()) ImGui::TextDisabled("click a variable in Objects to see it here over time");
    std::optional<std::size_t> removed;
    const auto count = static_cast<float>(std::max<std::size_t>(plots.size(), 1));
    const float height = std::max(70.0F, ImGui::GetContentRegionAvail().y / count - ImGui::GetStyle().ItemSpacing.y);
    for (std::size_t i = 0; i < plots.size(); ++i) {
      ImGui::PushID(static_cast<int>(i));
      if (ui::button(named("remove " + std::to_string(i)), "x")) removed = i;
      ImGui::SameLine();
      drawPlot(plots[i], now, height);
      ImGui::PopID();
    }
    if (removed) session.plots().remove(*removed);
  }

  void drawPlot(const Plot& plot, float now, float height) const {
    const float last = plot.values.empty() ? 0 : plot.values.back();
    ImGui::Text("%s = %.5g %s", plot.name.c_str(), static_cast<double>(last), plot.unit.c_str());
    const Range range = rangeOf(plot, now - seconds_);
    const ImVec2 from = ImGui::GetCursorScreenPos();
    const ImVec2 size{ImGui::GetContentRegionAvail().x, height - 24};
    ImDrawList* canvas = ImGui::GetWindowDrawList();
    canvas->AddRectFilled(from, {from.x + size.x, from.y + size.y}, IM_COL32(25, 27, 32, 255));
    const std::size_t count = plot.values.size() - range.first;
    const auto placeOf = [&](std::size_t i) {
      const float x = 1 - (now - plot.times[i]) / seconds_;
      const float y = (plot.values[i] - range.low) / (range.high - range.low);
      return ImVec2{from.x + size.x * x, from.y + size.y * (0.95F - 0.9F * y)};
    };
    // No more points than pixels: of each pixel's samples the first one.
    const std::size_t step = std::max<std::size_t>(1, count / static_cast<std::size_t>(std::max(1.0F, size.x)));
    for (std::size_t i = range.first; i + step < plot.values.size(); i += step) {
      canvas->AddLine(placeOf(i), placeOf(i + step), IM_COL32(120, 200, 255, 255), 1.5F);
    }
    drawBound(range.high, {from.x, from.y});
    drawBound(range.low, {from.x, from.y + size.y - 14});
    ImGui::Dummy(size);
  }

  /// A number that is read across curves.
  static void drawBound(float value, const ImVec2& from) {
    const std::string words = fmt::format("{:.4g}", value);
    const ImVec2 size = ImGui::CalcTextSize(words.c_str());
    ImDrawList* canvas = ImGui::GetWindowDrawList();
    canvas->AddRectFilled(from, {from.x + size.x + 6, from.y + 14}, IM_COL32(25, 27, 32, 200));
    canvas->AddText({from.x + 3, from.y}, IM_COL32(190, 190, 190, 255), words.c_str());
  }

  float seconds_ = 5;
};

}  // namespace

std::unique_ptr<Panel> makePlotsPanel() { return std::make_unique<PlotsPanel>(); }

}  // namespace murosimf
