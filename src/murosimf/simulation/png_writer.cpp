#include "murosimf/simulation/png_writer.h"

#include <fmt/format.h>
#include <png.h>

#include <stdexcept>

namespace murosimf {

namespace {

[[noreturn]] void fail(const std::filesystem::path& file, const Picture& picture, const std::string& reason) {
  throw std::runtime_error(fmt::format("{}: cannot write a picture of {} x {} pixels: {}", file.string(), picture.width,
                                       picture.height, reason));
}

}  // namespace

void writePng(const std::filesystem::path& file, const Picture& picture) {
  const std::size_t pixels = static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
  if (picture.width < 1 || picture.height < 1 || picture.rgb.size() != 3 * pixels) fail(file, picture, "it is empty");
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(picture.width);
  image.height = static_cast<png_uint_32>(picture.height);
  image.format = PNG_FORMAT_RGB;
  // libpng removes what it has written when it fails.
  if (png_image_write_to_file(&image, file.c_str(), 0, picture.rgb.data(), 0, nullptr) == 0) {
    const std::string reason = image.message;
    png_image_free(&image);
    fail(file, picture, reason);
  }
}

}  // namespace murosimf
