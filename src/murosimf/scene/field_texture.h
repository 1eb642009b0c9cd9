#pragma once

/// @file The picture that a scenario lays on its carpet.

#include <memory>

#include "murosimf/algorithms/ground_texture.h"
#include "murosimf/scene/scene.h"

namespace murosimf {

/// Reads the file that field.texture names, looked for where robot files are. @returns nothing where none is named or
/// it cannot be read, which is reported
std::shared_ptr<const GroundTexture> readFieldTexture(const FieldSettings& field, Diagnostics& diagnostics);

}  // namespace murosimf
