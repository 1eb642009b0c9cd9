#pragma once

/// @file Reads the calibration of a camera as programs write it that calibrate real ones:
///   OpenCV   FileStorage YAML: camera_matrix, distortion_coefficients, image_width, image_height, fisheye_model
///   ROS      camera_info YAML: K (or camera_matrix), D (or distortion_coefficients), distortion_model, width, height
///   Bouguet  Calib_Results.m: fc, cc, alpha_c, kc, nx, ny
/// A name that ends in .m is Bouguet's, every other YAML. docs/cameras.md tells which keys mean what.
///
/// Every mistake in the file is reported with its line; nothing that a file may hold makes the reader crash. Keys of
/// other matters are passed over. Whether the lens covers its picture is not looked at here: checkCamera() does.

#include <optional>
#include <string>
#include <vector>

#include "murosimf/algorithms/camera_model.h"
#include "murosimf/world/diagnostics.h"

namespace murosimf {

struct Calibration {
  CameraModel camera;
  bool has_size = false;  ///< the file tells the size of the picture; else width and height of `camera` say nothing
};

/// The calibration, or nothing when at least one error was reported.
std::optional<Calibration> readCalibrationFile(const std::string& path, Diagnostics& diagnostics);

/// The same of text that was loaded elsewhere; `file` is the name used in messages.
std::optional<Calibration> readCalibrationText(const std::string& text, const std::string& file,
                                               Diagnostics& diagnostics);

/// What numbers of a lens mean: "plumb_bob" (0, 4 or 5), "rational" (8, 12, or 14 of which two are zero), "fisheye"
/// (4); also by ROS's names; "" goes by the count and is no fisheye. Puts them into camera.kind and kc.
/// @return what is wrong, "" when nothing is
std::string setLens(CameraModel& camera, const std::string& model, const std::vector<double>& numbers);

}  // namespace murosimf
