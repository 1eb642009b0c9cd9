// The part of ControlLoop that runs on the programs' threads.

#include <chrono>

#include "murosimf/control/control_runner.h"

namespace murosimf {

namespace {

double secondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Calls the program; the text of what it threw, if it did.
template <class Call>
std::optional<std::string> faultOf(const Call& call) {
  try {
    call();
    return std::nullopt;
  } catch (const client::CannotStart&) {
    throw;
  } catch (const std::exception& fault) {
    return fault.what();
  } catch (...) {
    return "an exception without a text";
  }
}

}  // namespace

void ControlLoop::start() {
  for (Runner* runner : programmed_) {
    ControlledRobot& robot = runner->controlled;
    runner->asked = -1;
    try {
      runner->fault = faultOf([&] { robot.program->start(robot.port.description()); });
    } catch (const client::CannotStart& problem) {
      throw client::CannotStart(runner->team() + " " + std::to_string(robot.port.description().number) + ": " +
                                problem.what());
    }
  }
  for (Runner* runner : programmed_) {
    if (!runner->fault)
      runner->fault = faultOf([&] { runner->controlled.program->startCameras(runner->commands.camera_periods); });
    runner->failed = runner->fault.has_value();
    setCameras(*runner, runner->commands, 0);
  }
}

void ControlLoop::runTask(Runner& runner) {
  try {
    render(runner);
    stepProgram(runner);
    for (ControlObserver* observer : observers_) {
      if (runner.fault) break;
      observer->onStep(runner.index, runner.asked, runner.sensors, runner.controlled,
                       runner.controlled.program->report());
    }
  } catch (...) {
    runner.observer_fault = std::current_exception();
  }
  runner.busy = false;
}

void ControlLoop::render(Runner& runner) {
  const auto start = std::chrono::steady_clock::now();
  runner.pictures.clear();
  runner.sights.clear();
  for (std::size_t i = 0; i < runner.exposures.size(); ++i) {
    if (runner.exposures[i].snapshot == kNoSnapshot) continue;
    runner.controlled.eye(i)->look();
    if (i < runner.controlled.cameraCount()) ++runner.counts.pictures;
  }
  for (std::size_t i = 0; i < runner.controlled.cameraCount(); ++i) {
    deliverPicture(runner, i);
    deliverSights(runner, i);
  }
  deliverScans(runner);
  runner.counts.picture_seconds += secondsSince(start);
}

/// One picture a step: a camera's period is no shorter than the program's.
void ControlLoop::deliverPicture(Runner& runner, std::size_t camera) {
  const auto& cameras = runner.controlled.cameras;
  RobotCamera* source = camera < cameras.size() ? cameras[camera].get() : nullptr;
  if (source == nullptr || !source->deliver(runner.asked)) return;
  const Picture& picture = source->picture();
  runner.pictures.push_back({static_cast<int>(camera), source->time(), picture.width, picture.height, source->bytes(),
                             static_cast<client::PixelFormat>(source->settings().format)});
}

void ControlLoop::deliverSights(Runner& runner, std::size_t camera) {
  const auto& oracles = runner.controlled.oracles;
  OracleCamera* source = camera < oracles.size() ? oracles[camera].get() : nullptr;
  if (source == nullptr || !source->deliver(runner.asked)) return;
  for (const ArrivedSights& arrived : source->arrived()) {
    std::vector<client::SeenThing>& things = runner.things[camera][kindIndex(arrived.kind)];
    things.clear();
    things.reserve(arrived.sightings.capacity());
    for (const Sighting& sighting : arrived.sightings) {
      const Landmark& landmark = source->landmarks()[static_cast<std::size_t>(sighting.landmark)];
      things.push_back({sighting.p_C, sighting.q_C, landmark.mark, landmark.number});
    }
    runner.sights.push_back(
        {static_cast<int>(camera), static_cast<client::ThingKind>(arrived.kind), arrived.time, things});
  }
}

void ControlLoop::deliverScans(Runner& runner) {
  runner.scans.clear();
  const auto& sensors = runner.controlled.ranges;
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    if (sensors[i]->deliver(runner.asked))
      runner.scans.push_back({static_cast<int>(i), sensors[i]->time(), sensors[i]->ranges()});
  }
}

void ControlLoop::stepProgram(Runner& runner) {
  const auto start = std::chrono::steady_clock::now();
  runner.sensors.pictures = runner.pictures;
  runner.sensors.sights = runner.sights;
  runner.sensors.scans = runner.scans;
  runner.commands.joints.resize(runner.controlled.port.description().joints.size());
  runner.commands.camera_periods.assign(runner.controlled.port.description().cameras.size(), client::kCameraAsIs);
  runner.fault = faultOf([&] { runner.controlled.program->step(runner.sensors, runner.commands); });
  runner.counts.program_seconds += secondsSince(start);
  ++runner.counts.steps;
}

}  // namespace murosimf
