#pragma once

/// @file One number for a picture, and the picture as a file for those who want to see what has changed.

#include <fstream>

#include "murosimf/algorithms/picture.h"

namespace murosimf::picture_hash {

/// Of colour, depth and label [FNV-1a].
inline std::uint64_t hashOf(const Picture& picture) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  const auto add = [&](const void* data, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i)
      hash = (hash ^ static_cast<const unsigned char*>(data)[i]) * 0x100000001b3ULL;
  };
  add(picture.rgb.data(), picture.rgb.size());
  add(picture.depth.data(), picture.depth.size() * sizeof(float));
  add(picture.label.data(), picture.label.size() * sizeof(std::uint16_t));
  return hash;
}

/// Its colours as a portable pixel map.
inline void writePpm(const std::string& file, const Picture& picture) {
  std::ofstream stream(file, std::ios::binary);
  stream << "P6 " << picture.width << ' ' << picture.height << " 255\n";
  stream.write(reinterpret_cast<const char*>(picture.rgb.data()), static_cast<std::streamsize>(picture.rgb.size()));
}

}  // namespace murosimf::picture_hash
