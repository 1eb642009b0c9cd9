#pragma once

/// @file An OpenGL 3.3 core context: somebody's window, or hidden, without any display.

#include <memory>
#include <string>

namespace murosimf {

class GlContext {
 public:
  virtual ~GlContext() = default;
  /// All calls of OpenGL by this thread mean this context from now on.
  virtual void makeCurrent() = 0;
};

/// A context without window or display, through EGL: on the first graphics card that lets us, else on Mesa's
/// surfaceless platform. For tests and pictures. It is made current.
/// @throws std::runtime_error saying which step failed last
std::unique_ptr<GlContext> makeHiddenContext();

/// What draws, of the current context.
struct GlIdentity {
  std::string renderer, version;
  bool software = false;  ///< the processor draws (llvmpipe, softpipe, swrast): some hundred times slower than a card
};
GlIdentity identifyGl();

/// "OpenGL 4.5: llvmpipe (LLVM 15.0.6)".
std::string nameOf(const GlIdentity& identity);
/// What is to be said where no graphics card draws; else empty.
std::string warningOf(const GlIdentity& identity);
/// Both, a line each.
std::string describe(const GlIdentity& identity);

}  // namespace murosimf
