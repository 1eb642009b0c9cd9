#pragma once

/// @file Pictures as PNG files.

#include <filesystem>
#include <span>

#include "murosimf/algorithms/picture.h"

namespace murosimf {

/// Writes the colours of a picture (8 bits a channel), replacing an earlier file. Depth and labels are left out.
/// @throws std::runtime_error `FILE: cannot write a picture of W x H pixels: REASON`; nothing half-written stays.
void writePng(const std::filesystem::path& file, const Picture& picture);
/// Writes numbers as a grey picture of 16 bits, row by row.
void writePng16(const std::filesystem::path& file, int width, int height, std::span<const std::uint16_t> numbers);

}  // namespace murosimf
