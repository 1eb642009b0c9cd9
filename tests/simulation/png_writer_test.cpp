#include "murosimf/simulation/png_writer.h"

#include <gtest/gtest.h>
#include <png.h>

#include "simulation/bouncing_balls.h"

namespace murosimf {
namespace {

/// A picture in which every byte is another one than its neighbours.
Picture patterned(int width, int height) {
  Picture picture;
  picture.has_depth = picture.has_label = false;
  picture.resize(width, height);
  for (std::size_t i = 0; i < picture.rgb.size(); ++i) picture.rgb[i] = static_cast<std::uint8_t>(i * 37 + i / 256);
  return picture;
}

Picture readPng(const std::filesystem::path& file) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  EXPECT_NE(png_image_begin_read_from_file(&image, file.c_str()), 0) << image.message;
  EXPECT_EQ(image.format, static_cast<png_uint_32>(PNG_FORMAT_RGB));
  Picture picture;
  picture.resize(static_cast<int>(image.width), static_cast<int>(image.height));
  EXPECT_NE(png_image_finish_read(&image, nullptr, picture.rgb.data(), 0, nullptr), 0) << image.message;
  return picture;
}

TEST(PngWriter, AnotherReaderSeesTheSameBytes) {
  const test::Folder folder;
  for (const auto& [width, height] : {std::pair{1, 1}, {7, 3}, {320, 240}}) {
    const Picture picture = patterned(width, height);
    writePng(folder / "p.png", picture);
    const Picture read = readPng(folder / "p.png");
    EXPECT_EQ(read.width, width);
    EXPECT_EQ(read.height, height);
    EXPECT_EQ(read.rgb, picture.rgb);
  }
}

TEST(PngWriter, SaysWhichFileAndWhy) {
  const test::Folder folder;
  const std::filesystem::path file = folder / "missing" / "p.png";
  const std::string error = test::errorOf([&] { writePng(file, patterned(4, 5)); });
  EXPECT_NE(error.find(file.string() + ": cannot write a picture of 4 x 5 pixels"), std::string::npos) << error;
  EXPECT_NE(error.find("No such file"), std::string::npos) << error;
  EXPECT_NE(test::errorOf([&] { writePng(folder / "p.png", Picture{}); }).find("it is empty"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(folder / "p.png"));
}

}  // namespace
}  // namespace murosimf
