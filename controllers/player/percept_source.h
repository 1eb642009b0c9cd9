#pragma once

/// @file Where percepts come from: the vision and cameras that tell what they see, or in tests an exact substitute.

#include <memory>

#include "camera_past.h"
#include "murosimf/control/client/robot_description.h"
#include "murosimf/control/client/state_archive.h"
#include "percepts.h"

namespace murosimf::controllers {

class PerceptSource {
 public:
  virtual ~PerceptSource() = default;
  virtual void start(const client::RobotDescription& robot) = 0;
  /// Clears `out` and fills it with what the frame's pictures show and its sights tell, in R of now however late they
  /// come. Called only for frames that have some.
  virtual void process(const client::SensorFrame& sensors, const CameraPast& past, Percepts& out) = 0;
  virtual void archive(client::StateArchive& archive) = 0;
};

/// The vision of vision.h, and the sights of cameras of level "oracle".
std::unique_ptr<PerceptSource> makeEyes();

}  // namespace murosimf::controllers
