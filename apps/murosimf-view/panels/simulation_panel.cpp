#include <fmt/format.h>

#include <cmath>

#include "murosimf-view/panels/all_panels.h"

namespace murosimf {

namespace {

class SimulationPanel final : public Panel {
 public:
  SimulationPanel() : Panel("Simulation", {0, 0, 0.24F, 0.42F}, true) {}

 private:
  void draw(Session& session, SceneViewport&) override {
    const Simulation& simulation = session.simulation();
    ImGui::Text("T %.3f s   frame %ld", simulation.time(), simulation.frame());
    if (const std::string score = session.game().scoreText(); !score.empty()) ImGui::TextUnformatted(score.c_str());
    if (ui::button(named("run"), session.running ? "pause" : "run")) session.running = !session.running;
    ImGui::SameLine();
    if (ui::button(named("back"), "< frame")) session.goBy(-1);
    ImGui::SameLine();
    if (ui::button(named("forward"), "frame >")) session.goBy(1);
    drawSpeed(session);
    drawHistory(session);
    ImGui::Separator();
    drawStages(session);
    drawFaults(session);
  }

  void drawSpeed(Session& session) {
    if (ui::button(named("slower"), "-")) session.changeSpeed(false);
    ImGui::SameLine();
    if (ui::button(named("faster"), "+")) session.changeSpeed(true);
    ImGui::SameLine();
    ImGui::Text("real time: wanted %.3g, reached %.2f", session.speed, session.figures().factor);
  }

  /// A slider over all that can be gone back to.
  void drawHistory(Session& session) {
    const FrameHistory& history = session.history();
    const double frame = session.simulation().frameLength();
    const auto first = static_cast<float>(static_cast<double>(history.firstFrame()) * frame);
    const auto last = static_cast<float>(static_cast<double>(history.lastFrame()) * frame);
    auto now = static_cast<float>(session.simulation().time());
    ImGui::SetNextItemWidth(-1);
    const bool moved = ImGui::SliderFloat("##history", &now, first, std::max(last, first + 1e-3F), "%.3f s");
    ui::remember(named("history"));
    if (moved) session.goBy(std::lround(static_cast<double>(now) / frame) - session.simulation().frame());
    ImGui::TextDisabled("%zu checkpoints, %.1f MiB", history.checkpointCount(),
                        static_cast<double>(history.bytes()) / (1 << 20));
  }

  static void drawStages(const Session& session) {
    ImGui::PushStyleColor(ImGuiCol_PlotHistogram, {0.62F, 0.40F, 0.10F, 1});
    for (int i = 0; i < static_cast<int>(Stage::kCount); ++i) {
      const double share = session.figures().stage_shares[static_cast<std::size_t>(i)];
      const std::string words = fmt::format("{} {:.0f} %", nameOf(static_cast<Stage>(i)), 100 * share);
      ImGui::ProgressBar(static_cast<float>(share), {-1, 13}, "");
      const ImVec2 corner = ImGui::GetItemRectMin();  // always at the left, where ImGui's own words follow the bar
      ImGui::GetWindowDrawList()->AddText({corner.x + 4, corner.y}, ImGui::GetColorU32(ImGuiCol_Text), words.c_str());
    }
    ImGui::PopStyleColor();
  }

  /// What went wrong: of the simulation, of robots, of renderers.
  static void drawFaults(Session& session) {
    const ImVec4 red{1, 0.45F, 0.4F, 1};
    if (!session.fault().empty()) ImGui::TextColored(red, "simulation failed: %s", session.fault().c_str());
    for (const StateGuard::Fault& fault : session.simulation().guard().faults()) {
      ImGui::TextColored(red, "%s frozen: %s", session.world().path(fault.robot).c_str(), fault.what.c_str());
    }
    for (const Rendering& r : session.renderings().all()) {
      if (r.fault.empty()) continue;
      ImGui::TextColored(red, "%s of %s is off: %s", session.renderings().entryOf(r).name.c_str(),
                         session.world().path(r.object).c_str(), r.fault.c_str());
    }
  }
};

}  // namespace

std::unique_ptr<Panel> makeSimulationPanel() { return std::make_unique<SimulationPanel>(); }

}  // namespace murosimf
