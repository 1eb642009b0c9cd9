#include "murosimf-view/window.h"

#include <epoxy/gl.h>
// GLFW must not bring headers of OpenGL beside libepoxy's.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <stdexcept>

namespace murosimf {

namespace {

[[noreturn]] void fail(const std::string& what) {
  const char* words = nullptr;
  glfwGetError(&words);
  throw std::runtime_error(what + (words == nullptr ? "" : std::string(": ") + words));
}

void styleWidgets() {
  ImGui::StyleColorsDark();
  ImGuiStyle& style = ImGui::GetStyle();
  style.WindowRounding = 4;
  style.FrameRounding = 3;
  style.Colors[ImGuiCol_WindowBg].w = 0.92F;
}

}  // namespace

Window::Window(int width, int height, const std::string& title) {
  if (glfwInit() == GLFW_FALSE) fail("no window: is there a display (DISPLAY, WAYLAND_DISPLAY)?");
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  window_ = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
  if (window_ == nullptr) fail("no window with OpenGL 3.3");
  glfwSetWindowUserPointer(window_, this);
  makeCurrent();
  glfwSwapInterval(1);
  glfwSetKeyCallback(window_, onKey);
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;  // leaves no file behind in whatever folder this is
  styleWidgets();
  ImGui_ImplGlfw_InitForOpenGL(window_, true);
  ImGui_ImplOpenGL3_Init("#version 330 core");
}

Window::~Window() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
  glfwDestroyWindow(window_);
  glfwTerminate();
}

void Window::makeCurrent() { glfwMakeContextCurrent(window_); }

bool Window::shouldClose() const { return glfwWindowShouldClose(window_) != 0; }

void Window::close() { glfwSetWindowShouldClose(window_, GLFW_TRUE); }

void Window::onKey(GLFWwindow* window, int key, int, int action, int) {
  if (action != GLFW_RELEASE) static_cast<Window*>(glfwGetWindowUserPointer(window))->waiting_.push_back(key);
}

void Window::beginFrame(const ScriptedMouse* mouse) {
  glfwPollEvents();
  glfwGetFramebufferSize(window_, &width_, &height_);
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  if (mouse != nullptr) {
    ImGuiIO& io = ImGui::GetIO();
    io.MousePos = {mouse->u, mouse->v};
    io.MouseDown[0] = mouse->down[0];
    io.MouseDown[1] = mouse->down[1];
    io.MouseWheel = mouse->wheel;
    io.KeyCtrl = mouse->control;
  }
  ImGui::NewFrame();
  keys_.clear();
  if (!ImGui::GetIO().WantTextInput) keys_ = waiting_;
  waiting_.clear();
}

void Window::endFrame() {
  ImGui::Render();
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

void Window::show() { glfwSwapBuffers(window_); }

}  // namespace murosimf
