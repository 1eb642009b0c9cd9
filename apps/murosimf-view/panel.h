#pragma once

/// @file A panel: one window of widgets about one thing.

#include <imgui.h>

#include <string>

#include "murosimf-view/session.h"
#include "murosimf-view/targets.h"
#include "murosimf-view/view.h"

namespace murosimf {

/// Where a panel stands until somebody moves it, in shares of the window's size.
struct PanelPlace {
  float x = 0, y = 0, width = 0.25F, height = 0.5F;
};

class Panel {
 public:
  Panel(std::string title, PanelPlace place, bool shown) : open(shown), title_(std::move(title)), place_(place) {}
  virtual ~Panel() = default;
  const std::string& title() const { return title_; }
  const PanelPlace& place() const { return place_; }
  const std::string& fault() const { return fault_; }

  bool open;
  /// Its window, where it is open. What its contents throw is shown in it, and nothing else of it from then on.
  void drawWindow(Session& session, SceneViewport& view);

 protected:
  virtual void draw(Session& session, SceneViewport& view) = 0;
  /// "Title/widget", for targets.h.
  std::string named(const std::string& widget) const { return title_ + "/" + widget; }

 private:
  std::string title_, fault_;
  PanelPlace place_;
};

}  // namespace murosimf
