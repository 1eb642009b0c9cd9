#pragma once

/// @file Draws what laser scanners and distance sensors told last: their rays, from the sensor to what they met.
///
/// Rays stand where they were cast: a scan that was on its way for a while is drawn from the sensor's place at its
/// time. A scanner's rays end in a dot where they met something, from red (near) to green (at the end of what the
/// sensor can tell); a ray that met nothing is grey and goes to that end, one that met something too near to be told is
/// magenta and goes to where telling begins. All rays of a distance sensor are as long as its one reading, errors and
/// all. Sensors of robots without control software do not scan: they get the edges of what they would look at, and a
/// robot a word.
/// Nothing is drawn while a recording is shown, which holds no scans.

#include <map>
#include <vector>

#include "murosimf/modules/sensing/range_sensor.h"
#include "murosimf/render/body_places.h"
#include "murosimf/simulation/simulation.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

/// Where each range sensor stood whenever it scanned. Observe the simulation with it before the first frame.
/// Cost: a scan, some 0.1 us and 0.1 KiB, kept so that one can go back.
class ScanPlaces final : public FrameObserver {
 public:
  explicit ScanPlaces(Simulation& simulation);
  void afterFrame(Simulation& simulation) override;

  struct Scanner {
    const RangeSensor* sensor;
    BodyPlaces carrier;
    MountPlace mount;
    std::map<long, Pose> X_WS;  // by frame
  };
  /// Null where this object is no range sensor, or one that does not scan.
  const Scanner* find(ObjectId sensor) const;

 private:
  void note(long frame);
  std::vector<Scanner> scanners_;
};

class ScansRenderer final : public PropertyRenderer {
 public:
  ScansRenderer(const RenderedObject& sensor, const Simulation& simulation, const ScanPlaces& places);
  void draw(const RenderMoment& now, DrawList& list) override;
  /// A line of the list of renderers; both must live longer.
  static RendererEntry entry(const Simulation& simulation, const ScanPlaces& places);

 private:
  void drawRay(std::size_t i, double reading, const Pose& X_WS, DrawList& list) const;
  void drawEdges(const RenderMoment& now, DrawList& list) const;

  const Simulation& simulation_;
  const ScanPlaces& places_;
  ObjectId sensor_;
  BodyPlaces carrier_;
  MountPlace mount_;
  RangeModel model_;
  bool first_;  // of its robot's: the word stands there once
};

}  // namespace murosimf
