#include "murosimf/render/gl/field_tiles.h"

#include <algorithm>
#include <cmath>

namespace murosimf {

namespace {

enum class TileKind : std::uint8_t { kSky, kCarpet, kSurroundings, kPainted };

class TileSorter {
 public:
  TileSorter(const PaintedGround& ground, const MarkedCells& marked, const Pose& X_WC)
      : ground_(ground), marked_(marked), X_WC_(X_WC) {}

  TileKind kindOf(const TileRays& tile) const {
    constexpr double kHuge = 1e30;
    double x_low = kHuge, x_high = -kHuge, y_low = kHuge, y_high = -kHuge, w_low = kHuge, w_high = -kHuge;
    for (const float x : {tile.x_low, tile.x_high})
      for (const float y : {tile.y_low, tile.y_high}) {
        const Vector3 d = X_WC_.rotation * Vector3{x, y, 1};
        const double w = -d.z / X_WC_.translation.z;
        const double px = X_WC_.translation.x + d.x / w, py = X_WC_.translation.y + d.y / w;
        w_low = min(w_low, w), w_high = max(w_high, w);
        x_low = min(x_low, px), x_high = max(x_high, px), y_low = min(y_low, py), y_high = max(y_high, py);
      }
    if (w_high < -kNearHorizon) return TileKind::kSky;
    if (w_low < kNearHorizon) return TileKind::kPainted;
    // A pixel's footprint is at most a quarter of the tile's: half of it reaches over the edge.
    const double wider = 0.125 * max(x_high - x_low, y_high - y_low) + 0.01;
    return kindOf(x_low - wider, x_high + wider, y_low - wider, y_high + wider);
  }

 private:
  static constexpr double kNearHorizon = 1e-3;  // [1/m]

  TileKind kindOf(double x_low, double x_high, double y_low, double y_high) const {
    const double a = ground_.half_length, b = ground_.half_width;
    const bool inside = x_low > -a && x_high < a && y_low > -b && y_high < b;
    const bool outside = x_low > a || x_high < -a || y_low > b || y_high < -b;
    if ((!inside && !outside) || marked_.anyWithin(x_low, x_high, y_low, y_high)) return TileKind::kPainted;
    return inside ? TileKind::kCarpet : TileKind::kSurroundings;
  }

  const PaintedGround& ground_;
  const MarkedCells& marked_;
  const Pose& X_WC_;
};

/// Tiles [first, end) of a row.
void addRun(const CameraModel& camera, int row, int first, int end, float carpet, std::vector<TileVertex>& list) {
  const auto across = [&](int tile) {
    return static_cast<float>(2.0 * std::min(kTileSize * tile, camera.width) / camera.width - 1);
  };
  const auto down = [&](int tile) {
    return static_cast<float>(2.0 * std::min(kTileSize * tile, camera.height) / camera.height - 1);
  };
  const float left = across(first), right = across(end), top = down(row), bottom = down(row + 1);
  const std::array<TileVertex, 4> c{
      {{left, top, carpet}, {right, top, carpet}, {right, bottom, carpet}, {left, bottom, carpet}}};
  list.insert(list.end(), {c[0], c[1], c[2], c[0], c[2], c[3]});
}

}  // namespace

bool MarkedCells::anyWithin(double x_low, double x_high, double y_low, double y_high) const {
  const auto cellOf = [](double place, int count) {
    return static_cast<std::size_t>(std::clamp<double>(place, 0, count));
  };
  const std::size_t left = cellOf(std::floor((x_low - low_x) / edge), columns),
                    right = cellOf(std::floor((x_high - low_x) / edge) + 1, columns),
                    low = cellOf(std::floor((y_low - low_y) / edge), rows),
                    high = cellOf(std::floor((y_high - low_y) / edge) + 1, rows);
  const auto sum = [&](std::size_t row, std::size_t column) {
    return sums[row * (static_cast<std::size_t>(columns) + 1) + column];
  };
  return sum(high, right) - sum(high, left) - sum(low, right) + sum(low, left) > 0;
}

void sortTiles(const RayTable& rays, const PaintedGround& ground, const MarkedCells& marked, const Pose& X_WC,
               FieldTiles& tiles) {
  tiles.bare.clear(), tiles.painted.clear();
  const TileSorter sorter(ground, marked, X_WC);
  for (int row = 0; row < rays.tileRows(); ++row) {
    const TileRays* const of_row = rays.tiles() + row * rays.tileColumns();
    int first = 0;
    TileKind kind = sorter.kindOf(of_row[0]);
    for (int column = 1; column <= rays.tileColumns(); ++column) {
      const TileKind next = column < rays.tileColumns() ? sorter.kindOf(of_row[column]) : TileKind::kSky;
      if (next == kind && column < rays.tileColumns()) continue;
      if (kind != TileKind::kSky)
        addRun(rays.camera(), row, first, column, kind == TileKind::kCarpet ? 1.0F : 0.0F,
               kind == TileKind::kPainted ? tiles.painted : tiles.bare);
      first = column, kind = next;
    }
  }
}

}  // namespace murosimf
