#pragma once

/// @file A window of the operating system with OpenGL and Dear ImGui in it.

#include <string>
#include <vector>

#include "murosimf/render/gl/gl_context.h"

struct GLFWwindow;

namespace murosimf {

class Window final : public GlContext {
 public:
  /// @throws std::runtime_error saying what is missing: a display, OpenGL 3.3
  Window(int width, int height, const std::string& title);
  ~Window() override;
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  void makeCurrent() override;
  bool shouldClose() const;
  void close();
  /// Takes the events that came, and begins a picture of widgets. `mouse`: in place of the real one, from a script.
  struct ScriptedMouse {
    float u = 0, v = 0;
    bool down[2] = {false, false};
    float wheel = 0;
    bool control = false;
  };
  void beginFrame(const ScriptedMouse* mouse = nullptr);
  /// Draws the widgets over what has been drawn. Call show() then.
  void endFrame();
  void show();

  int width() const { return width_; }  ///< of the picture [px]
  int height() const { return height_; }
  /// Keys pressed since the last frame that no widget takes: GLFW's numbers.
  const std::vector<int>& keys() const { return keys_; }

 private:
  static void onKey(GLFWwindow* window, int key, int scancode, int action, int modifiers);
  GLFWwindow* window_ = nullptr;
  int width_ = 0, height_ = 0;
  std::vector<int> keys_, waiting_;
};

}  // namespace murosimf
