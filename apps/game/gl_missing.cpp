// Stands in for modules/camera/gl where OpenGL's part is not built.

#include "murosimf/modules/camera/gl/gl_picture_maker.h"

namespace murosimf {

std::shared_ptr<const PictureMakerKind> openGlKind() {
  auto kind = std::make_shared<PictureMakerKind>();
  kind->name = "opengl";
  kind->missing = "this program was built without OpenGL; `make deps-view` installs what it needs, then `make build`";
  return kind;
}

}  // namespace murosimf
