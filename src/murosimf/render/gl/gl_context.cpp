#include "murosimf/render/gl/gl_context.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>

namespace murosimf {

namespace {

std::string textOf(GLenum name) {
  const GLubyte* text = glGetString(name);
  return text == nullptr ? "" : reinterpret_cast<const char*>(text);
}

}  // namespace

GlIdentity identifyGl() {
  GlIdentity identity{textOf(GL_RENDERER), textOf(GL_VERSION), false};
  for (const char* word : {"llvmpipe", "softpipe", "swrast", "Software Rasterizer"}) {
    identity.software = identity.software || identity.renderer.find(word) != std::string::npos;
  }
  return identity;
}

std::string describe(const GlIdentity& identity) {
  std::string text = fmt::format("OpenGL {}: {}\n", identity.version, identity.renderer);
  if (identity.software) text += "warning: no graphics card draws but the processor, which the simulation needs too\n";
  return text;
}

}  // namespace murosimf
