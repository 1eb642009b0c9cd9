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

std::string nameOf(const GlIdentity& identity) {
  return fmt::format("OpenGL {}: {}", identity.version, identity.renderer);
}

std::string warningOf(const GlIdentity& identity) {
  return identity.software ? "no graphics card draws but the processor, which the simulation needs too" : "";
}

std::string describe(const GlIdentity& identity) {
  const std::string warning = warningOf(identity);
  return nameOf(identity) + '\n' + (warning.empty() ? "" : "warning: " + warning + '\n');
}

}  // namespace murosimf
