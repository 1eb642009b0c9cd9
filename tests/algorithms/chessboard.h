#pragma once

/// @file A chessboard before a camera, made of boxes, at many poses: what people calibrate cameras with.

#include <cmath>
#include <optional>
#include <vector>

#include "murosimf/algorithms/ray_caster.h"
#include "murosimf/math/rotation.h"

namespace murosimf::chessboard {

inline constexpr int kColumns = 9, kRows = 6;  ///< inner corners
inline constexpr double kSquare = 0.04;        ///< [m]

/// Corner in the board's frame B: x along the columns, y along the rows, origin in the middle, z away from the camera.
inline Vector3 corner(int column, int row) {
  return {(column - 0.5 * (kColumns - 1)) * kSquare, (row - 0.5 * (kRows - 1)) * kSquare, 0.0};
}

/// Where the corners are seen, row by row; nothing unless all stand `margin` pixels within the picture.
inline std::optional<std::vector<ImagePoint>> project(const CameraModel& camera, const Pose& X_CB, double margin) {
  std::vector<ImagePoint> places;
  for (int row = 0; row < kRows; ++row)
    for (int column = 0; column < kColumns; ++column) {
      const auto place = projectPoint(camera, X_CB * corner(column, row));
      if (!place || place->u < margin || place->v < margin || place->u > camera.width - 1 - margin ||
          place->v > camera.height - 1 - margin)
        return std::nullopt;
      places.push_back(*place);
    }
  return places;
}

/// Boxes side by side, so that the board is flat and corners are seen where they are from any side.
inline RayScene scene(const Pose& X_WC, const Pose& X_CB) {
  constexpr double kThickness = 0.01;
  RayScene scene;
  scene.ambient = 1.0F;
  const Pose X_WB = X_WC * X_CB;
  const auto add = [&](double x, double y, double width, double height, float grey) {
    const Pose X_BS{{}, {x, y, 0.5 * kThickness}};
    scene.drawables.push_back({makeBox({width, height, kThickness}), X_WB * X_BS, {grey, grey, grey}});
  };
  for (int row = -1; row < kRows; ++row)
    for (int column = -1; column < kColumns; ++column) {
      const Vector3 a = corner(column, row);
      add(a.x + 0.5 * kSquare, a.y + 0.5 * kSquare, kSquare, kSquare, (row + column) % 2 == 0 ? 0.08F : 0.92F);
    }
  const double w = (kColumns + 1) * kSquare, h = (kRows + 1) * kSquare, rim = 0.5 * kSquare;
  for (const double side : {-0.5, 0.5}) {
    add(side * (w + rim), 0, rim, h + 2 * rim, 0.92F);
    add(0, side * (h + rim), w, rim, 0.92F);
  }
  return scene;
}

/// Poses all over the picture: the board's middle towards a place of it, its face to the camera and then leant over,
/// drawn towards the middle until all of it is seen.
inline std::vector<Pose> poses(const CameraModel& camera, double distance, double margin) {
  std::vector<Pose> poses;
  for (int i = 0; i < 24; ++i) {
    const int column = i % 6, row = i / 6;
    const double across = column / 5.0, down = row / 3.0;
    const double lean_x = 0.5 * std::sin(1.0 + 2.3 * i), lean_y = 0.5 * std::cos(0.4 + 1.7 * i),
                 roll = 0.25 * std::sin(5.0 * i);
    for (double share = 1.0; share > 0.0; share -= 0.04) {
      const ImagePoint place{camera.cx + share * (across * (camera.width - 1) - camera.cx),
                             camera.cy + share * (down * (camera.height - 1) - camera.cy)};
      const RaySlopes ray = unproject(camera, place);
      const Vector3 z = normalized(Vector3{ray.x, ray.y, 1.0});
      const Vector3 x = normalized(cross(Vector3{0, 1, 0}, z));
      const Rotation3 R_CB = Rotation3{x, cross(z, x), z} * rotationZ(roll) * rotationX(lean_x) * rotationY(lean_y);
      const Pose X_CB{R_CB, (distance * (1.0 + 0.3 * std::sin(3.0 * i))) * z};
      if (!project(camera, X_CB, margin)) continue;
      poses.push_back(X_CB);
      break;
    }
  }
  return poses;
}

}  // namespace murosimf::chessboard
