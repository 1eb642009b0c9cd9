#pragma once

/// @file The scene behind the widgets: drawn, orbited, clicked, pulled.

#include <memory>
#include <optional>

#include "murosimf-view/film_strip.h"
#include "murosimf-view/session.h"
#include "murosimf/render/gl/gl_renderer.h"
#include "murosimf/render/orbit_camera.h"

namespace murosimf {

class SceneViewport {
 public:
  explicit SceneViewport(MeshLibrary& meshes) : list_(meshes) {}

  OrbitCamera camera;
  bool shadows = true;
  std::string screenshot;    ///< file for the next complete picture of the window; empty: none
  FilmStrip film;            ///< of the window
  bool see_through = false;  ///< shapes, so that what lies in them is seen
  bool follows = false;      ///< the camera's target moves with the selected object

  /// Draws the session as it is now, over all of the window's picture, words too.
  void draw(Session& session, int width, int height);
  /// What the mouse does where no widget is: left orbits, right or Shift and left pan, the wheel zooms, a double click
  /// selects, Ctrl and left pull the body under the mouse.
  void handleMouse(Session& session);
  /// Where a place of the world is in the window; nothing behind the camera.
  std::optional<ImagePoint> placeOf(const Vector3& p_W) const;
  /// The part under a pixel, or 0; and the place in W where it is seen.
  struct Pick {
    std::uint32_t id = 0;
    Vector3 p_W;
  };
  Pick pick(int u, int v);

 private:
  void drawTexts() const;
  void drawRefusal(const Session& session) const;
  void drawSelection(Session& session);
  void drawPull(Session& session);
  void beginPull(Session& session);
  void movePull(Session& session) const;
  void follow(Session& session);

  DrawList list_;
  GlRenderer renderer_;
  std::unique_ptr<GlLabelTarget> labels_;
  GlView view_;
};

}  // namespace murosimf
