#pragma once

/// @file Pictures from PNG files.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace murosimf {

struct PngPicture {
  int width = 0, height = 0;      ///< [px]
  std::vector<std::uint8_t> rgb;  ///< 3 bytes a pixel, row 0 on top; what is transparent shows black
  std::string problem;            ///< why there is none: what was found, what was expected
};

/// Reads pictures of any PNG kind up to 8192 x 8192 pixels. Never throws for what the file holds.
PngPicture readPng(const std::filesystem::path& file);

}  // namespace murosimf
