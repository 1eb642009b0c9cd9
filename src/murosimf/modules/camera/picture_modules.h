#pragma once

/// @file Picture modules: what may happen to a camera's light on its way to the bytes that control software gets.
///
/// A camera has a chain of them, in the order that its scenario names. Each is exchangeable, has parameters of its own,
/// and knows nothing of the others. To add one: write a PictureModule and name it in pictureModules(), or give an own
/// list to who builds the cameras.

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/algorithms/camera_model.h"
#include "murosimf/algorithms/light/light_picture.h"
#include "murosimf/math/state_archive.h"

namespace murosimf {

/// What a module knows of the picture that it works on.
struct PictureMoment {
  std::uint64_t key = 0;  ///< of this picture's random numbers
  double since_last = 0;  ///< time since the camera's picture before this one [s]; 0: it is the first
};

class PictureModule {
 public:
  PictureModule() = default;
  PictureModule(const PictureModule&) = delete;
  PictureModule& operator=(const PictureModule&) = delete;
  virtual ~PictureModule() = default;
  /// Changes the light. Any thread, one picture of a camera after another.
  virtual void apply(LightPicture& light, const PictureMoment& moment) = 0;
  /// State that goes on from picture to picture; nothing by default.
  virtual void archive(StateArchive& archive) { static_cast<void>(archive); }
};

/// A number that a scenario may set, as MODULE_NAME.
struct PictureParameter {
  std::string_view name, unit;
  double lowest = 0, highest = 0, value = 0;  ///< value: where the scenario says nothing
  std::string_view meaning;
};

/// Values by name, all of them.
using PictureValues = std::map<std::string, double, std::less<>>;

struct PictureModuleKind {
  std::string_view name, meaning;
  std::vector<PictureParameter> parameters;
  std::function<std::unique_ptr<PictureModule>(const CameraModel&, const PictureValues&)> make;
};

/// exposure, white_balance, vignetting, defocus, noise.
const std::vector<PictureModuleKind>& pictureModules();

}  // namespace murosimf
