#include "game/scans_renderer.h"

#include <algorithm>
#include <cmath>

#include "murosimf/control/control_loop.h"

namespace murosimf {

namespace {

constexpr double kDot = 0.008;   // radius of what marks the end of a ray [m]
constexpr double kAbove = 0.25;  // of a word over the sensor [m]

RenderedObject carrierOf(const RenderedObject& sensor) {
  return {sensor.world, sensor.linked, sensor.world.parent(sensor.object), sensor.label};
}

MountPlace mountOf(const World& world, ObjectId sensor) {
  const MountPlace* mount = world.findShared(sensor, kRangePlace);
  return mount == nullptr ? MountPlace{} : *mount;
}

/// From red at 0 to green at 1.
Tint nearToFar(double share) {
  const auto s = static_cast<float>(std::clamp(share, 0.0, 1.0));
  return {std::min(1.0F, 2 - 2 * s), std::min(1.0F, 2 * s), 0.1F, 0.8F};
}

}  // namespace

ScanPlaces::ScanPlaces(Simulation& simulation) {
  const World& world = simulation.world();
  for (int r = 0; simulation.control() != nullptr && r < simulation.control()->robotCount(); ++r) {
    const ControlledRobot& robot = simulation.control()->robot(r);
    if (robot.program == nullptr) continue;
    for (const std::unique_ptr<RangeSensor>& sensor : robot.ranges) {
      const RenderedObject object{world, simulation.linked(), sensor->object()};
      scanners_.push_back({sensor.get(), BodyPlaces(carrierOf(object)), mountOf(world, sensor->object()), {}});
    }
  }
  note(-1);
}

void ScanPlaces::afterFrame(Simulation& simulation) { note(simulation.frame() - 1); }

void ScanPlaces::note(long frame) {
  for (Scanner& s : scanners_)
    if (s.sensor->isDue(frame)) s.X_WS[frame] = s.carrier.pose(s.mount.row, frame) * s.mount.X_RM;
}

const ScanPlaces::Scanner* ScanPlaces::find(ObjectId sensor) const {
  const auto at = std::find_if(scanners_.begin(), scanners_.end(),
                               [&](const Scanner& scanner) { return scanner.sensor->object() == sensor; });
  return at == scanners_.end() ? nullptr : &*at;
}

ScansRenderer::ScansRenderer(const RenderedObject& sensor, const Simulation& simulation, const ScanPlaces& places)
    : simulation_(simulation),
      places_(places),
      sensor_(sensor.object),
      carrier_(carrierOf(sensor)),
      mount_(mountOf(sensor.world, sensor.object)),
      model_(*sensor.world.findShared(sensor.object, kRangeModel)),
      first_(sensor.world.members(sensor.world.parent(sensor.object), subset::kRangeSensors)[0] == sensor.object) {}

RendererEntry ScansRenderer::entry(const Simulation& simulation, const ScanPlaces& places) {
  return {"scans",
          std::string(kRangeModel.name),
          std::string(subset::kSelf),
          "rays of range sensors, of robots with control software; red: near, green: far, grey: nothing there",
          false,
          [&](const RenderedObject& sensor) { return std::make_unique<ScansRenderer>(sensor, simulation, places); }};
}

void ScansRenderer::draw(const RenderMoment& now, DrawList& list) {
  if (now.time != simulation_.time()) return;
  const ScanPlaces::Scanner* scanner = places_.find(sensor_);
  if (scanner == nullptr) return drawEdges(now, list);
  const std::span<const double> ranges = scanner->sensor->ranges();
  const long frame = std::lround(scanner->sensor->time() / simulation_.frameLength()) - 1;
  const auto place = scanner->X_WS.find(frame);
  if (place == scanner->X_WS.end()) return;  // none has come yet
  for (std::size_t i = 0; i < model_.directions.size(); ++i)
    drawRay(i, ranges[model_.nearest ? 0 : i], place->second, list);
}

void ScansRenderer::drawRay(std::size_t i, double reading, const Pose& X_WS, DrawList& list) const {
  const bool met = std::isfinite(reading);
  const double length = met ? reading : reading > 0 ? model_.largest : model_.least;
  const Vector3 end_W = X_WS * (model_.directions[i] * length);
  const Tint tint = met           ? nearToFar(reading / model_.largest)
                    : reading > 0 ? Tint{0.7F, 0.7F, 0.7F, 0.15F}
                                  : Tint{1.0F, 0.1F, 0.9F};
  list.line(X_WS.translation, end_W, tint);
  if (met && !model_.nearest) list.sphere(end_W, kDot, {tint.red, tint.green, tint.blue});
}

void ScansRenderer::drawEdges(const RenderMoment& now, DrawList& list) const {
  const Pose X_WS = carrier_.pose(mount_.row, now.frame) * mount_.X_RM;
  const Tint grey{0.7F, 0.7F, 0.7F, 0.5F};
  for (const Vector3& direction : {model_.directions.front(), model_.directions.back()})
    list.line(X_WS.translation, X_WS * (direction * model_.largest), grey);
  const Vector3 above_W = X_WS.translation + Vector3{0, 0, kAbove};
  if (first_) list.text(above_W, "no control software: no scans", {1, 1, 1});
}

}  // namespace murosimf
