#include "percept_source.h"

#include "sights.h"
#include "vision.h"

namespace murosimf::controllers {

namespace {

/// The vision for pictures, and whatever cameras without pictures tell.
class Eyes final : public PerceptSource {
 public:
  void start(const client::RobotDescription& robot) override {
    vision_.start(robot);
    sights_.start(robot);
  }
  void process(const client::SensorFrame& sensors, const CameraPast& past, Percepts& out) override {
    X_RC_.resize(past.cameras());
    for (const client::CameraPicture& picture : sensors.pictures) {  // one of a camera, at most
      const auto camera = static_cast<std::size_t>(picture.camera);
      if (camera < X_RC_.size()) X_RC_[camera] = past.pose(camera, picture.time);
    }
    vision_.process(sensors, X_RC_, out);
    sights_.add(sensors.sights, past, out);
  }
  void archive(client::StateArchive& archive) override { vision_.archive(archive); }

 private:
  Vision vision_;
  SightReader sights_;
  std::vector<Pose> X_RC_;  // of the frame's pictures
};

}  // namespace

std::unique_ptr<PerceptSource> makeEyes() { return std::make_unique<Eyes>(); }

}  // namespace murosimf::controllers
