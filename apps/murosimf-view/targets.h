#pragma once

/// @file Widgets by name, so that scripts can click them: each says where it was drawn last.
///
/// ui::button("Simulation/run", "run") is ImGui's button "run"; a script's `click Simulation/run` finds it.

#include <imgui.h>

#include <map>
#include <string>

namespace murosimf::ui {

struct Place {
  float u = 0, v = 0;    ///< of the middle [px]
  long frame = -1;       ///< in which it was drawn
  bool visible = false;  ///< its middle is not scrolled away
};

inline std::map<std::string, Place>& places() {
  static std::map<std::string, Place> all;
  return all;
}

/// Call behind any widget.
inline void remember(const std::string& name) {
  const ImVec2 a = ImGui::GetItemRectMin(), b = ImGui::GetItemRectMax();
  const ImVec2 middle{0.5F * (a.x + b.x), 0.5F * (a.y + b.y)};
  const bool visible = ImGui::IsRectVisible(middle, {middle.x + 1, middle.y + 1});
  places()[name] = {middle.x, middle.y, ImGui::GetFrameCount(), visible};
}

inline bool button(const std::string& name, const char* label) {
  const bool pressed = ImGui::Button(label);
  remember(name);
  return pressed;
}
inline bool checkbox(const std::string& name, const char* label, bool* value) {
  const bool changed = ImGui::Checkbox(label, value);
  remember(name);
  return changed;
}
inline bool selectable(const std::string& name, const char* label, bool selected) {
  const bool pressed = ImGui::Selectable(label, selected);
  remember(name);
  return pressed;
}

}  // namespace murosimf::ui
