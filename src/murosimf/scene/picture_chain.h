#pragma once

/// @file A camera's chain of picture modules, from its parameters in a scenario.
///
///     [robots.all.cameras.camera]
///     chain = ["rolling_shutter", "motion_blur", "defocus", "exposure", "noise", "latency"]
///     rolling_shutter_readout = 0.02
///     defocus_deviation = 0.8
///
/// rolling_shutter and motion_blur tell how light is gathered and stand first, latency stands last; between them
/// modules work in the order in which they are named. Parameters are called MODULE_PARAMETER.

#include "murosimf/modules/camera/robot_camera.h"
#include "murosimf/scene/scene.h"

namespace murosimf {

/// The modules that are no pass over the light: rolling_shutter, motion_blur, latency; they have no make().
const std::vector<PictureModuleKind>& timingModules();

class PictureChainReader {
 public:
  PictureChainReader(const ModuleChoice& camera, Diagnostics& diagnostics)
      : camera_(camera), diagnostics_(diagnostics) {}
  /// Reads what belongs to the chain out of the camera's parameters; a chain takes the place of gain and noise. Reports
  /// what is wrong.
  void read(RobotCameraSettings& settings);
  /// Whether a parameter is dealt with here.
  static bool owns(const NamedValue& parameter);
  /// Names of all parameters that a camera could have here.
  static std::vector<std::string> knownParameters();

 private:
  void readNames(const NamedValue& chain);
  void checkPlace(const NamedValue& chain, const std::string& name);
  void readFormat(const NamedValue& format, PixelFormat& out);
  void readValue(const NamedValue& parameter, const PictureModuleKind& kind, const PictureParameter& known);
  void fill(RobotCameraSettings& settings) const;

  const ModuleChoice& camera_;
  Diagnostics& diagnostics_;
  std::vector<const PictureModuleKind*> named_;  // in their order
  std::vector<PictureValues> values_;            // as named_
};

}  // namespace murosimf
