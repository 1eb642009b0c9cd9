// The picture on the carpet: where it is looked for, and what is wrong with it.

#include "murosimf/scene/field_texture.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "murosimf/simulation/png_reader.h"
#include "murosimf/simulation/png_writer.h"

namespace murosimf {
namespace {

namespace fs = std::filesystem;

struct Folder {
  fs::path path = fs::temp_directory_path() / ("murosimf_texture_test_" + std::to_string(::getpid()));
  Folder() { fs::create_directories(path); }
  ~Folder() { fs::remove_all(path); }
};

Picture threeByTwo() {
  Picture p;
  p.resize(3, 2);
  for (std::size_t i = 0; i < p.rgb.size(); ++i) p.rgb[i] = static_cast<std::uint8_t>(10 * i);
  return p;
}

std::string saidOf(const Folder& folder, const std::string& name) {
  FieldSettings field;
  field.texture = {name, {(folder.path / "game.toml").string(), 4, 11}};
  Diagnostics diagnostics;
  const auto texture = readFieldTexture(field, diagnostics);
  EXPECT_EQ(texture == nullptr, diagnostics.errorCount() > 0 || name.empty());
  return diagnostics.text();
}

TEST(FieldTexture, IsReadFromBesideTheScenario) {
  const Folder folder;
  writePng(folder.path / "grass.png", threeByTwo());
  const PngPicture read = readPng(folder.path / "grass.png");
  EXPECT_EQ(read.width, 3);
  EXPECT_EQ(read.height, 2);
  EXPECT_EQ(read.rgb, threeByTwo().rgb);
  EXPECT_EQ(saidOf(folder, "grass.png"), "");
  EXPECT_EQ(saidOf(folder, ""), "");
}

TEST(FieldTexture, MistakesAreToldWithTheirPlace) {
  const Folder folder;
  writePng(folder.path / "grass.png", threeByTwo());
  std::ofstream(folder.path / "text.png") << "no picture";
  std::ofstream(folder.path / "cut.png", std::ios::binary) << std::ifstream(folder.path / "grass.png").rdbuf();
  fs::resize_file(folder.path / "cut.png", fs::file_size(folder.path / "cut.png") - 20);
  const std::string where = (folder.path / "game.toml").string() + ":4:11: error: ";
  EXPECT_TRUE(saidOf(folder, "gras.png").starts_with(where + "there is no picture \"gras.png\", looked for from "));
  EXPECT_NE(saidOf(folder, "gras.png").find("did you mean \"grass.png\"?"), std::string::npos);
  EXPECT_TRUE(saidOf(folder, "text.png").starts_with(where + "texture is \"text.png\", which is no PNG picture: "));
  EXPECT_TRUE(saidOf(folder, "cut.png").starts_with(where + "texture is \"cut.png\", which cannot be read: "))
      << saidOf(folder, "cut.png");
}

}  // namespace
}  // namespace murosimf
