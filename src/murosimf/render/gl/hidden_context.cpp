#include <epoxy/egl.h>
#include <fmt/format.h>

#include <stdexcept>

#include "murosimf/render/gl/gl_context.h"

namespace murosimf {

namespace {

[[noreturn]] void fail(const char* step) {
  throw std::runtime_error(
      fmt::format("no OpenGL without display: {} failed (EGL error {:#x}); needs Mesa's EGL and "
                  "its drivers (Debian: libegl1, libgl1-mesa-dri)",
                  step, eglGetError()));
}

/// The extension's function, not EGL 1.5's of the same name: the loader refuses that before a display exists.
EGLDisplay openDisplay() {
  if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) fail("EGL_MESA_platform_surfaceless");
  const EGLDisplay display = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (display == EGL_NO_DISPLAY) fail("eglGetPlatformDisplayEXT");
  return display;
}

class HiddenContext final : public GlContext {
 public:
  HiddenContext() : display_(openDisplay()) {
    if (eglInitialize(display_, nullptr, nullptr) == EGL_FALSE) fail("eglInitialize");
    if (eglBindAPI(EGL_OPENGL_API) == EGL_FALSE) fail("eglBindAPI");
    const EGLint wanted[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (eglChooseConfig(display_, wanted, &config, 1, &count) == EGL_FALSE || count == 0) fail("eglChooseConfig");
    const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION_KHR,
                              3,
                              EGL_CONTEXT_MINOR_VERSION_KHR,
                              3,
                              EGL_CONTEXT_OPENGL_PROFILE_MASK_KHR,
                              EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT_KHR,
                              EGL_NONE};
    context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, version);
    if (context_ == EGL_NO_CONTEXT) fail("eglCreateContext");
    makeCurrent();
  }
  ~HiddenContext() override {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display_, context_);
    // The display stays open: others of this process may use it, and Mesa gives the same one again.
  }
  HiddenContext(const HiddenContext&) = delete;
  HiddenContext& operator=(const HiddenContext&) = delete;

  void makeCurrent() override {
    if (eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_FALSE) fail("eglMakeCurrent");
  }

 private:
  EGLDisplay display_;
  EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace

std::unique_ptr<GlContext> makeHiddenContext() { return std::make_unique<HiddenContext>(); }

}  // namespace murosimf
