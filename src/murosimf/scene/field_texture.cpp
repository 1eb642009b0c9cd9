#include "murosimf/scene/field_texture.h"

#include <fmt/format.h>

#include "murosimf/scene/robot_reader.h"
#include "murosimf/simulation/png_reader.h"

namespace murosimf {

std::shared_ptr<const GroundTexture> readFieldTexture(const FieldSettings& field, Diagnostics& diagnostics) {
  if (field.texture->empty()) return nullptr;
  const SourceLocation& where = field.texture.where;
  const std::filesystem::path found = findDataFile(*field.texture, where.file);
  if (found.empty()) {
    diagnostics.error(where, "there is no picture " + whereLooked(*field.texture, where.file));
    return nullptr;
  }
  const PngPicture picture = readPng(found);
  if (!picture.problem.empty()) {
    diagnostics.error(where, fmt::format("texture is \"{}\", which {}", *field.texture, picture.problem));
    return nullptr;
  }
  return std::make_shared<const GroundTexture>(picture.width, picture.height, picture.rgb);
}

}  // namespace murosimf
