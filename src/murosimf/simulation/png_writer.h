#pragma once

/// @file Pictures as PNG files.

#include <filesystem>

#include "murosimf/algorithms/picture.h"

namespace murosimf {

/// Writes the colours of a picture (8 bits a channel), replacing an earlier file. Depth and labels are left out.
/// @throws std::runtime_error `FILE: cannot write a picture of W x H pixels: REASON`; nothing half-written stays.
void writePng(const std::filesystem::path& file, const Picture& picture);

}  // namespace murosimf
