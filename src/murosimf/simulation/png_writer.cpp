#include "murosimf/simulation/png_writer.h"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <stdexcept>

namespace murosimf {

namespace {

[[noreturn]] void fail(const std::filesystem::path& file, int width, int height, const std::string& reason) {
  throw std::runtime_error(
      fmt::format("{}: cannot write a picture of {} x {} pixels: {}", file.string(), width, height, reason));
}

/// @param enough  whether there is a number for every pixel
void write(const std::filesystem::path& file, int width, int height, png_uint_32 format, const void* pixels,
           bool enough) {
  if (width < 1 || height < 1 || !enough) fail(file, width, height, "it is empty");
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width);
  image.height = static_cast<png_uint_32>(height);
  image.format = format;
  // libpng removes what it has written when it fails.
  if (png_image_write_to_file(&image, file.c_str(), 0, pixels, 0, nullptr) == 0) {
    const std::string reason = image.message;
    png_image_free(&image);
    fail(file, width, height, reason);
  }
}

std::size_t pixelCount(int width, int height) {
  return static_cast<std::size_t>(std::max(width, 0)) * static_cast<std::size_t>(std::max(height, 0));
}

}  // namespace

void writePng(const std::filesystem::path& file, const Picture& picture) {
  const bool enough = picture.rgb.size() == 3 * pixelCount(picture.width, picture.height);
  write(file, picture.width, picture.height, PNG_FORMAT_RGB, picture.rgb.data(), enough);
}

void writePng16(const std::filesystem::path& file, int width, int height, std::span<const std::uint16_t> numbers) {
  write(file, width, height, PNG_FORMAT_LINEAR_Y, numbers.data(), numbers.size() == pixelCount(width, height));
}

}  // namespace murosimf
