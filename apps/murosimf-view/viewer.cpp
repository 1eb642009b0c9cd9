#include "murosimf-view/viewer.h"

#include <epoxy/gl.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <chrono>

#include "murosimf-view/panels/all_panels.h"
#include "murosimf/simulation/png_writer.h"

namespace murosimf {

namespace {

/// Wall time that frames may take of one picture's: the rest is for drawing.
constexpr double kBudget = 0.025;

}  // namespace

Viewer::Viewer(Window& window, Session& session)
    : window_(window), session_(session), view_(meshes_), panels_(makeAllPanels()) {}

Panel* Viewer::panel(const std::string& title) {
  const auto found = std::find_if(panels_.begin(), panels_.end(), [&](const auto& p) { return p->title() == title; });
  return found == panels_.end() ? nullptr : found->get();
}

void Viewer::press(int key) {
  const long frames_a_jump = std::lround(0.1 / session_.simulation().frameLength());
  switch (key) {
    case GLFW_KEY_SPACE:
      session_.running = !session_.running;
      break;
    case GLFW_KEY_RIGHT:
      return session_.goBy(1);
    case GLFW_KEY_LEFT:
      return session_.goBy(-1);
    case GLFW_KEY_PAGE_DOWN:
      return session_.goBy(frames_a_jump);
    case GLFW_KEY_PAGE_UP:
      return session_.goBy(-frames_a_jump);
    case GLFW_KEY_EQUAL:
    case GLFW_KEY_KP_ADD:
      return session_.changeSpeed(true);
    case GLFW_KEY_MINUS:
    case GLFW_KEY_KP_SUBTRACT:
      return session_.changeSpeed(false);
    case GLFW_KEY_F1:
      panel("Help")->open = !panel("Help")->open;
      break;
    case GLFW_KEY_TAB:
      panels_shown = !panels_shown;
      break;
    case GLFW_KEY_F:
      view_.follows = session_.selected.valid();
      break;
    case GLFW_KEY_ESCAPE:
      view_.follows = false;
      session_.selected = {};
      break;
    case GLFW_KEY_F12:
      return screenshot(fmt::format("murosimf_{:.3f}s.png", session_.simulation().time()));
    default:
      break;
  }
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
