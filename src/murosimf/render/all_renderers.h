#pragma once

/// @file The renderers of shared properties. Whoever has a property of their own adds one to the registry.

#include "murosimf/render/property_renderer.h"

namespace murosimf {

RendererRegistry allRenderers();

}  // namespace murosimf
