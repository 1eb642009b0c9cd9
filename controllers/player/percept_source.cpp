#include "percept_source.h"

#include "vision.h"

namespace murosimf::controllers {

namespace {

class VisionSource final : public PerceptSource {
 public:
  void start(const client::RobotDescription& robot) override { vision_.start(robot); }
  void process(const client::SensorFrame& sensors, const Posture& posture, Percepts& out) override {
    vision_.process(sensors, posture, out);
  }
  void archive(client::StateArchive& archive) override { vision_.archive(archive); }

 private:
  Vision vision_;
};

}  // namespace

std::unique_ptr<PerceptSource> makeVisionSource() { return std::make_unique<VisionSource>(); }

}  // namespace murosimf::controllers
