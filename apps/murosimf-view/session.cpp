#include "murosimf-view/session.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "game/game.h"
#include "murosimf-view/contacts_renderer.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

namespace {

double wallClock() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Assemblies in the order in which cameras label them, then the root, the cameras and the range sensors.
std::vector<ObjectId> drawnObjects(const World& world, const Participants& participants) {
  std::vector<ObjectId> objects = participants.free_bodies;
  objects.insert(objects.end(), participants.robots.begin(), participants.robots.end());
  objects.insert(objects.end(), participants.fixed.begin(), participants.fixed.end());
  objects.push_back(world.root());
  for (int i = 0; i < world.objectCount(); ++i) {
    const auto is = [&](const auto& model) { return world.findEntry({i}, model.name) != nullptr; };
    if (is(kCameraModel) || is(kRangeModel)) objects.push_back({i});
  }
  return objects;
}

constexpr double kMeasured = 0.5;      // wall time between two measurements of the speed [s]
constexpr double kSlowest = 1.0 / 64;  // simulated seconds a second

}  // namespace

Session::Session(Scene scene, const ViewerParts& parts, Diagnostics& diagnostics)
    : scene_(std::move(scene)), modules_(parts.modules) {
  const auto watchers = [&](const Participants& all) { return parts.renderers.attachments(all.robots); };
  simulation_ = buildGame(scene_, diagnostics, watchers, parts.modules, parts.programs);
  if (simulation_ == nullptr) return;
  game_ = std::make_unique<GameObservers>(scene_, *simulation_);
  simulation_->observe(&plots_);
  RendererRegistry all = parts.renderers;
  all.add(ContactsRenderer::entry(*simulation_));
  scan_places_ = std::make_unique<ScanPlaces>(*simulation_);
  simulation_->observe(scan_places_.get());
  all.add(ScansRenderer::entry(*simulation_, *scan_places_));
  renderings_ = std::make_unique<Renderings>(all, simulation_->world(), simulation_->linked(),
                                             drawnObjects(simulation_->world(), simulation_->participants()));
  simulation_->step();
  history_ = std::make_unique<FrameHistory>(*simulation_);
}

/// Observers must not be gone while a program still runs.
Session::~Session() {
  if (simulation_ == nullptr) return;
  try {
    simulation_->control()->finish();
  } catch (...) {  // NOLINT: nobody is left to tell
  }
}

void Session::changeSpeed(bool faster) { speed = std::clamp(faster ? 2 * speed : 0.5 * speed, kSlowest, 1 / kSlowest); }

/// False when it failed: the simulation stands still then, and the window goes on.
bool Session::step() {
  try {
    if (pull) pull->request(*simulation_, *history_);
    history_->step();
    return true;
  } catch (const std::exception& fault) {
    fault_ = fault.what();
    running = false;
    return false;
  }
}

void Session::openRecording(const std::string& file) {
  closeRecording();
  simulation_->control()->finish();
  recording_ = std::make_unique<RecordingPlayer>(file, *simulation_);
  showRecording(recording_->startTime());
}

void Session::closeRecording() {
  running = false;
  if (recording_ == nullptr) return;
  recording_.reset();
  history_->restore();
}

void Session::showRecording(double time) {
  running = false;
  recording_time_ = time;
  recording_->show(time);
}

void Session::advance(double wall_seconds, double budget) {
  if (recording_ != nullptr) {
    if (!running) return;
    recording_time_ = std::min(recording_time_ + speed * wall_seconds, recording_->endTime());
    return recording_->show(recording_time_);
  }
  if (!running || !fault_.empty()) return measure(std::exchange(ran_, false) ? wall_seconds : -1);
  const double start = wallClock(), frame = simulation_->frameLength();
  // What could not be run in time is not caught up: the window would jump.
  owed_ = std::min(owed_ + speed * wall_seconds, std::max(speed * budget, frame));
  while (owed_ >= frame && wallClock() - start < budget) {
    if (!step()) return;
    owed_ -= frame;
    simulated_ += frame;
  }
  measure(wall_seconds);
}

double Session::timeOf(long frames) const { return static_cast<double>(frames) * simulation_->frameLength(); }

void Session::run(long frames) {
  running = false;
  ran_ = true;
  owed_ = 0;
  if (recording_ != nullptr) return showRecording(recording_time_ + timeOf(frames));
  for (long i = 0; i < frames && fault_.empty() && step(); ++i) simulated_ += simulation_->frameLength();
}

/// Below 0: it is paused, and the last figures stay.
void Session::measure(double wall_seconds) {
  if (wall_seconds < 0) {
    wall_ = simulated_ = 0;
    return;
  }
  wall_ += wall_seconds;
  if (wall_ < kMeasured) return;
  figures_.factor = simulated_ / wall_;
  wall_ = simulated_ = 0;
  double sum = 0;
  for (std::size_t i = 0; i < stages_.size(); ++i) {
    const double now = simulation_->stages().seconds(static_cast<Stage>(i));
    figures_.stage_shares[i] = now - stages_[i];
    stages_[i] = now;
    sum += figures_.stage_shares[i];
  }
  for (double& share : figures_.stage_shares) share = sum > 0 ? share / sum : 0;
}

void Session::goBy(long frames) {
  running = false;
  owed_ = 0;
  if (recording_ != nullptr) return showRecording(recording_time_ + timeOf(frames));
  if (!fault_.empty()) return;
  try {
    history_->goTo(simulation_->frame() + frames);
  } catch (const std::exception& fault) {
    fault_ = fault.what();
  }
  plots_.forgetAfter(simulation_->time());
}

void Session::draw(DrawList& list) {
  const double time = recording_ == nullptr ? simulation_->time() : recording_->time();
  renderings_->draw({simulation_->frame() - 1, time}, list);
}

}  // namespace murosimf
