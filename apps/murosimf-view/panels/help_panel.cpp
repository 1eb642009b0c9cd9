#include "murosimf-view/panels/all_panels.h"

namespace murosimf {

namespace {

struct Line {
  const char *key, *what;
};
constexpr Line kLines[] = {
    {"Space", "run or pause"},
    {"Right, Left", "one frame forward, back (held: on and on)"},
    {"Page Down, Page Up", "0.1 s forward, back"},
    {"+, -", "twice as fast, half as fast"},
    {"F1", "this help"},
    {"Tab", "hide or show all panels"},
    {"Esc", "free camera, nothing selected"},
    {"F", "follow what is selected"},
    {"F12", "screenshot into the working folder"},
    {"left mouse", "orbit"},
    {"right mouse, Shift + left", "pan"},
    {"wheel", "zoom"},
    {"double click", "select"},
    {"Ctrl + left", "pull the body under the mouse by a spring"},
};

class HelpPanel final : public Panel {
 public:
  HelpPanel() : Panel("Help", {0.3F, 0.24F, 0.4F, 0.42F}, false) {}

 private:
  void draw(Session&, SceneViewport&) override {
    if (!ImGui::BeginTable("keys", 2, ImGuiTableFlags_SizingFixedFit)) return;
    for (const Line& line : kLines) {
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(line.key);
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(line.what);
    }
    ImGui::EndTable();
  }
};

}  // namespace

std::unique_ptr<Panel> makeHelpPanel() { return std::make_unique<HelpPanel>(); }

}  // namespace murosimf
