#include <epoxy/egl.h>
#include <fmt/format.h>

#include <cstring>
#include <exception>
#include <stdexcept>
#include <vector>

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
EGLDisplay displayOf(EGLenum platform, void* native) { return eglGetPlatformDisplayEXT(platform, native, nullptr); }

bool clientHas(const char* extension) { return epoxy_has_egl_extension(EGL_NO_DISPLAY, extension); }

/// Graphics cards that EGL knows, whoever made their drivers; Mesa's software counts as a device too, and is left out.
void addCards(std::vector<EGLDisplay>& displays) {
  constexpr EGLint kMost = 16;
  const bool listed = clientHas("EGL_EXT_device_enumeration") || clientHas("EGL_EXT_device_base");
  if (!listed || !clientHas("EGL_EXT_platform_device")) return;
  EGLDeviceEXT devices[kMost];
  EGLint count = 0;
  if (eglQueryDevicesEXT(kMost, devices, &count) == EGL_FALSE) return;
  for (EGLint i = 0; i < count; ++i) {
    const char* extensions = eglQueryDeviceStringEXT(devices[i], EGL_EXTENSIONS);
    const bool software = extensions != nullptr && std::strstr(extensions, "EGL_MESA_device_software") != nullptr;
    if (!software) displays.push_back(displayOf(EGL_PLATFORM_DEVICE_EXT, devices[i]));
  }
}

/// In the order in which they are tried.
std::vector<EGLDisplay> displaysWithoutScreen() {
  std::vector<EGLDisplay> displays;
  addCards(displays);
  if (clientHas("EGL_MESA_platform_surfaceless"))
    displays.push_back(displayOf(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY));
  return displays;
}

class HiddenContext final : public GlContext {
 public:
  explicit HiddenContext(EGLDisplay display) : display_(display) {
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

std::unique_ptr<GlContext> makeHiddenContext() {
  std::exception_ptr why;
  for (const EGLDisplay display : displaysWithoutScreen()) {
    try {
      return std::make_unique<HiddenContext>(display);
    } catch (const std::runtime_error&) {
      why = std::current_exception();  // a card that others may not use, for example: the next one will do
    }
  }
  if (why != nullptr) std::rethrow_exception(why);
  fail("EGL_EXT_platform_device, EGL_MESA_platform_surfaceless");
}

}  // namespace murosimf
