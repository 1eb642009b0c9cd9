#include "murosimf-view/viewer.h"

#include <epoxy/gl.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>

#include "murosimf-view/panels/all_panels.h"
#include "murosimf/simulation/png_writer.h"

namespace murosimf {

namespace {

/// Wall time that frames may take of one picture's: the rest is for drawing.
constexpr double kBudget = 0.025;

using KeyAction = void (*)(Viewer&);

void jump(Viewer& viewer, double seconds) {
  viewer.session().goBy(std::lround(seconds / viewer.session().simulation().frameLength()));
}

void goFree(Viewer& viewer) {
  viewer.view().follows = false;
  viewer.session().selected = {};
}

/// What keys do, as docs/viewer.md lists them.
const std::map<int, KeyAction>& keyActions() {
  static const KeyAction faster = [](Viewer& v) { v.session().changeSpeed(true); };
  static const KeyAction slower = [](Viewer& v) { v.session().changeSpeed(false); };
  static const std::map<int, KeyAction> all{
      {GLFW_KEY_SPACE, [](Viewer& v) { v.session().running = !v.session().running; }},
      {GLFW_KEY_RIGHT, [](Viewer& v) { v.session().goBy(1); }},
      {GLFW_KEY_LEFT, [](Viewer& v) { v.session().goBy(-1); }},
      {GLFW_KEY_PAGE_DOWN, [](Viewer& v) { jump(v, 0.1); }},
      {GLFW_KEY_PAGE_UP, [](Viewer& v) { jump(v, -0.1); }},
      {GLFW_KEY_EQUAL, faster},
      {GLFW_KEY_KP_ADD, faster},
      {GLFW_KEY_MINUS, slower},
      {GLFW_KEY_KP_SUBTRACT, slower},
      {GLFW_KEY_F1, [](Viewer& v) { v.panel("Help")->open = !v.panel("Help")->open; }},
      {GLFW_KEY_TAB, [](Viewer& v) { v.panels_shown = !v.panels_shown; }},
      {GLFW_KEY_F, [](Viewer& v) { v.view().follows = v.session().selected.valid(); }},
      {GLFW_KEY_ESCAPE, goFree},
      {GLFW_KEY_F12,
       [](Viewer& v) { v.screenshot(fmt::format("murosimf_{:.3f}s.png", v.session().simulation().time())); }}};
  return all;
}

}  // namespace

Viewer::Viewer(Window& window, Session& session)
    : window_(window), session_(session), view_(meshes_), panels_(makeAllPanels()) {}

Panel* Viewer::panel(const std::string& title) {
  const auto found = std::find_if(panels_.begin(), panels_.end(), [&](const auto& p) { return p->title() == title; });
  return found == panels_.end() ? nullptr : found->get();
}

void Viewer::press(int key) {
  const auto known = keyActions().find(key);
  if (known != keyActions().end()) known->second(*this);
}

void Viewer::drawMenu() {
  if (!ImGui::BeginMainMenuBar()) return;
  if (ImGui::BeginMenu("Panels")) {
    for (const auto& p : panels_) {
      ImGui::MenuItem(p->title().c_str(), nullptr, &p->open);
      ui::remember("menu/" + p->title());
    }
    ImGui::EndMenu();
  }
  ui::remember("menu/Panels");
  ImGui::TextDisabled("%s   F1 help   Space run   Left/Right one frame", session_.scene().file.filename().c_str());
  ImGui::EndMainMenuBar();
}

void Viewer::drawPanels() {
  if (!panels_shown) return;
  drawMenu();
  for (const auto& p : panels_) p->drawWindow(session_, view_);
}

/// Of the window as it is now, where somebody wants one.
void Viewer::savePicture() {
  const double time = session_.simulation().time();
  const bool filmed = view_.film.isDue(time);
  if (view_.screenshot.empty() && !filmed) return;
  Picture picture;
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  readColours(window_.width(), window_.height(), picture);
  if (filmed) view_.film.add(picture, time);
  if (!view_.screenshot.empty()) writePng(view_.screenshot, picture);
  view_.screenshot.clear();
}

void Viewer::drawFrame(double wall_seconds) {
  window_.beginFrame(script_ ? &script_->mouse() : nullptr);
  for (const int key : window_.keys()) press(key);
  session_.advance(wall_seconds, kBudget);
  view_.handleMouse(session_);
  view_.draw(session_, window_.width(), window_.height());
  drawPanels();
  window_.endFrame();
  savePicture();
  window_.show();
}

bool Viewer::run() {
  using Clock = std::chrono::steady_clock;
  Clock::time_point last = Clock::now();
  while (!window_.shouldClose()) {
    const Clock::time_point now = Clock::now();
    drawFrame(std::chrono::duration<double>(now - last).count());
    last = now;
    if (script_ && !script_->next(*this)) window_.close();
  }
  return true;
}

}  // namespace murosimf
