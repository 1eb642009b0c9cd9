#include "murosimf-view/panel.h"

#include <exception>

namespace murosimf {

void Panel::drawWindow(Session& session, SceneViewport& view) {
  if (!open) return;
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  constexpr float kMenu = 20;  // height of the bar above [px]
  const float height = size.y - kMenu;
  ImGui::SetNextWindowPos({place_.x * size.x + 4, kMenu + place_.y * height + 4}, ImGuiCond_FirstUseEver);
  ImGui::SetNextWindowSize({place_.width * size.x - 8, place_.height * height - 8}, ImGuiCond_FirstUseEver);
  if (ImGui::Begin(title_.c_str(), &open)) {
    try {
      if (fault_.empty()) draw(session, view);
    } catch (const std::exception& fault) {
      fault_ = fault.what();
    }
    if (!fault_.empty()) ImGui::TextWrapped("This panel failed and is switched off: %s", fault_.c_str());
  }
  ImGui::End();
}

}  // namespace murosimf
