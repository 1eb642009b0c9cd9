#pragma once

/// @file Kind "opengl" of picture makers: pictures through OpenGL, any lens (render/gl/gl_camera_renderer.h).
///
/// Colours have 8 bits, before gain and noise too. No shadows, no anti-aliasing, no shutter, no picture on the carpet.
/// Pictures differ between drivers, and by rounding between places in an atlas; the same run gives the same ones.

#include "murosimf/modules/camera/picture_maker.h"

namespace murosimf {

/// For the cameras of one game: they share a studio (gl_studio.h), which the first one opens and the last one closes.
std::shared_ptr<const PictureMakerKind> openGlKind();

}  // namespace murosimf
