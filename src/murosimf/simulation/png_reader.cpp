#include "murosimf/simulation/png_reader.h"

#include <fmt/format.h>
#include <png.h>

namespace murosimf {

namespace {
constexpr png_uint_32 kLargest = 8192;  // [px] a side
}

PngPicture readPng(const std::filesystem::path& file) {
  PngPicture picture;
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_file(&image, file.c_str()) == 0) {
    picture.problem = fmt::format("is no PNG picture: {}", image.message);
    return picture;
  }
  if (image.width > kLargest || image.height > kLargest) {
    picture.problem =
        fmt::format("has {} x {} pixels, expected at most {} a side", image.width, image.height, kLargest);
    png_image_free(&image);
    return picture;
  }
  image.format = PNG_FORMAT_RGB;
  picture.rgb.resize(PNG_IMAGE_SIZE(image));
  const png_color black{0, 0, 0};
  if (png_image_finish_read(&image, &black, picture.rgb.data(), 0, nullptr) == 0) {
    picture.problem = fmt::format("cannot be read: {}", image.message);
    picture.rgb.clear();
    png_image_free(&image);
    return picture;
  }
  picture.width = static_cast<int>(image.width), picture.height = static_cast<int>(image.height);
  return picture;
}

}  // namespace murosimf
