#pragma once

/// @file The window as a whole: keys, panels, the scene, and a script that may drive all of it.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "murosimf-view/panel.h"
#include "murosimf-view/script.h"
#include "murosimf-view/session.h"
#include "murosimf-view/view.h"
#include "murosimf-view/window.h"

namespace murosimf {

class Viewer {
 public:
  Viewer(Window& window, Session& session);

  /// Until the window is closed. @returns false when the script found something amiss; see scriptFault()
  bool run();
  /// Runs these commands instead of a person's, then closes the window.
  void setScript(std::vector<ScriptLine> lines) { script_ = ScriptRunner(std::move(lines)); }

  Session& session() { return session_; }
  SceneViewport& view() { return view_; }
  Panel* panel(const std::string& title);
  /// Written when this picture is complete.
  void screenshot(std::string file) { view_.screenshot = std::move(file); }
  void press(int key);
  bool panels_shown = true;

 private:
  void drawFrame(double wall_seconds);
  void drawMenu();
  void drawPanels();
  void savePicture();

  Window& window_;
  Session& session_;
  MeshLibrary meshes_;
  SceneViewport view_;
  std::vector<std::unique_ptr<Panel>> panels_;
  std::optional<ScriptRunner> script_;
};

}  // namespace murosimf
