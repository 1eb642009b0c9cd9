#include <fmt/format.h>

#include "murosimf-view/panels/all_panels.h"

namespace murosimf {

namespace {

/// Screenshots and videos of the window.
class PicturesPanel final : public Panel {
 public:
  PicturesPanel() : Panel("Pictures", {0.6F, 0, 0.18F, 0.2F}, false) {}

 private:
  void draw(Session& session, SceneViewport& view) override {
    if (ui::button(named("screenshot"), "screenshot (F12)")) {
      view.screenshot = fmt::format("murosimf_{:.3f}s.png", session.simulation().time());
    }
    FilmStrip& film = view.film;
    if (!film.isRunning()) {
      if (ui::button(named("video"), "begin a video")) begin(session, view);
    } else {
      if (ui::button(named("video"), "end the video")) problem_ = film.stop();
      ImGui::Text("%s\n%ld pictures", film.file().c_str(), film.pictures());
    }
    if (!problem_.empty()) ImGui::TextWrapped("%s", problem_.c_str());
    ImGui::TextDisabled("into the working folder\n25 pictures a simulated second");
  }

  void begin(Session& session, SceneViewport& view) {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    problem_.clear();
    try {
      view.film.start(fmt::format("murosimf_{:.3f}s.mp4", session.simulation().time()), static_cast<int>(size.x),
                      static_cast<int>(size.y));
    } catch (const std::exception& fault) {
      problem_ = fault.what();
    }
  }

  std::string problem_;
};

}  // namespace

std::unique_ptr<Panel> makePicturesPanel() { return std::make_unique<PicturesPanel>(); }

}  // namespace murosimf
