#include "percept_source.h"

#include "sights.h"
#include "vision.h"

namespace murosimf::controllers {

namespace {

/// The vision for pictures, and whatever cameras without pictures tell.
class Eyes final : public PerceptSource {
 public:
  void start(const client::RobotDescription& robot) override { vision_.start(robot); }
  void process(const client::SensorFrame& sensors, const Posture& posture, Percepts& out) override {
    vision_.process(sensors, posture, out);
    addSights(sensors.sights, posture, out);
  }
  void archive(client::StateArchive& archive) override { vision_.archive(archive); }

 private:
  Vision vision_;
};

}  // namespace

std::unique_ptr<PerceptSource> makeEyes() { return std::make_unique<Eyes>(); }

}  // namespace murosimf::controllers
