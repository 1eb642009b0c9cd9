#include <fmt/format.h>

#include "murosimf-view/panels/all_panels.h"

namespace murosimf {

namespace {

/// Opens a recording of `murosimf run --record` and goes to any time of it.
class RecordingPanel final : public Panel {
 public:
  RecordingPanel() : Panel("Recording", {0.24F, 0, 0.36F, 0.2F}, false) {}

 private:
  void draw(Session& session, SceneViewport&) override {
    ImGui::SetNextItemWidth(-60);
    ImGui::InputTextWithHint("##file", "file of murosimf run --record", file_, sizeof(file_));
    ui::remember(named("file"));
    ImGui::SameLine();
    if (ui::button(named("open"), "open")) load(session);
    if (!problem_.empty()) ImGui::TextWrapped("%s", problem_.c_str());
    if (session.recording() != nullptr) drawTime(session);
  }

  void load(Session& session) {
    problem_.clear();
    try {
      session.openRecording(file_);
    } catch (const std::exception& fault) {
      problem_ = fault.what();
    }
  }

  void drawTime(Session& session) {
    const RecordingPlayer& recording = *session.recording();
    auto now = static_cast<float>(recording.time());
    ImGui::SetNextItemWidth(-1);
    const bool moved = ImGui::SliderFloat("##time", &now, static_cast<float>(recording.startTime()),
                                          static_cast<float>(recording.endTime()), "%.3f s");
    ui::remember(named("time"));
    if (moved) session.showRecording(static_cast<double>(now));
    if (ui::button(named("play"), session.running ? "pause" : "play")) session.running = !session.running;
    ImGui::SameLine();
    if (ui::button(named("close"), "back to the simulation")) session.closeRecording();
    ImGui::TextDisabled("levels of detail are not recorded");
  }

  char file_[512] = "";
  std::string problem_;
};

}  // namespace

std::unique_ptr<Panel> makeRecordingPanel() { return std::make_unique<RecordingPanel>(); }

}  // namespace murosimf
