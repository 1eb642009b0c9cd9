#include "player/vision/ray_table.h"

namespace murosimf::controllers {

void RayTable::start(const client::CameraDescription& camera) {
  columns_ = (camera.width - 1) / kSpacing + 2;
  rows_ = (camera.height - 1) / kSpacing + 2;
  nodes_.clear();
  nodes_.reserve(static_cast<std::size_t>(columns_ * rows_));
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      const PlanePoint p = toRay(camera, {static_cast<double>(column * kSpacing), static_cast<double>(row * kSpacing)});
      nodes_.push_back({static_cast<float>(p.a), static_cast<float>(p.b)});
    }
  }
}

}  // namespace murosimf::controllers
