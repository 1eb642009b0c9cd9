#include "murosimf/control/control_loop.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "murosimf/control/control_runner.h"

namespace murosimf {

MountedCamera* ControlledRobot::camera(std::size_t i) const {
  if (i < cameras.size() && cameras[i] != nullptr) return cameras[i].get();
  return i < oracles.size() ? oracles[i].get() : nullptr;
}

namespace {

void checkTiming(long period, long delay) {
  if (period < 1 || delay < 0)
    throw std::invalid_argument(
        fmt::format("control period of {} frames, delay of {}; expected at least 1 and 0", period, delay));
}

/// Gives the robot the loop's period and delay where it has none of its own.
void fillTiming(ControlledRobot& robot, const ControlTiming& timing) {
  if (robot.period == 0) robot.period = timing.period;
  if (robot.delay < 0) robot.delay = timing.delay;
  checkTiming(robot.period, robot.delay);
}

}  // namespace

ControlLoop::ControlLoop(std::vector<ControlledRobot> robots, const SceneView& view, const ControlTiming& timing,
                         double frame_length)
    : view_(view), timing_(timing), frame_length_(frame_length) {
  checkTiming(timing.period, timing.delay);
  const int count = static_cast<int>(robots.size());
  int cameras = 0;
  bool moving = false;  // some camera's picture needs motions
  bool waiting = false;
  for (ControlledRobot& robot : robots) {
    fillTiming(robot, timing);
    checkCameras(robot);
    waiting = waiting || (robot.program != nullptr && robot.program->waitsForOthers());
    for (std::size_t i = 0; i < robot.eyeCount(); ++i) {
      const MountedCamera* camera = robot.eye(i);
      if (camera == nullptr) continue;
      cameras += robot.program == nullptr ? 0 : 1;
      moving = moving || camera->needsMotion();
    }
    robots_.push_back(std::make_unique<Runner>(robotCount(), count, std::move(robot)));
    if (robots_.back()->controlled.program != nullptr) programmed_.push_back(robots_.back().get());
  }
  // A camera has at most one picture that waits for its program and one that is being rendered. Each has room for the
  // whole world: a thousand robots without software could not be held if theirs had as well.
  snapshots_ = std::make_unique<SnapshotShelf>(view, 2 * cameras, moving);
  const auto task = [this](int robot) { runTask(*robots_[static_cast<std::size_t>(robot)]); };
  pool_ = timing.paced || waiting ? makeThreadPerRobot(count, task) : makeSharedPool(timing.threads, task);
}

ControlLoop::~ControlLoop() { pool_->wait(); }

void ControlLoop::checkCameras(const ControlledRobot& robot) const {
  for (std::size_t i = 0; i < robot.eyeCount(); ++i) {
    const MountedCamera* camera = robot.eye(i);
    if (camera != nullptr && camera->period() < static_cast<double>(robot.period)) {
      throw std::invalid_argument(fmt::format("{} takes a {} every {} frames; expected at least {}, the control period",
                                              camera->path(), i < robot.cameraCount() ? "picture" : "scan",
                                              camera->period(), robot.period));
    }
  }
}

const ControlledRobot& ControlLoop::robot(int index) const {
  return robots_[static_cast<std::size_t>(index)]->controlled;
}

int ControlLoop::indexOf(ObjectId robot) const {
  for (const auto& runner : robots_) {
    if (runner->controlled.port.robot() == robot) return runner->index;
  }
  return -1;
}

void ControlLoop::setGame(int robot, const client::GameInfo& game) {
  client::GameInfo& told = robots_[static_cast<std::size_t>(robot)]->game;
  const bool placed = told.placed && !game.placed;
  const PlanarPose placed_at = told.placed_at;
  told = game;
  if (placed) told.placed = true, told.placed_at = placed_at;
}

const client::ControlReport* ControlLoop::report(int robot) const {
  const Runner& runner = *robots_[static_cast<std::size_t>(robot)];
  return runner.controlled.program == nullptr ? nullptr : &runner.controlled.program->report();
}

const client::ControlSoftware* ControlLoop::program(int robot) const {
  return robots_[static_cast<std::size_t>(robot)]->controlled.program.get();
}

std::optional<PlanarPose> ControlLoop::takeBeam(int robot) {
  Runner& runner = *robots_[static_cast<std::size_t>(robot)];
  return std::exchange(runner.beams, false) ? std::optional(runner.beam) : std::nullopt;
}

bool ControlLoop::isBusy(int robot) const { return robots_[static_cast<std::size_t>(robot)]->busy; }

void ControlLoop::applyCommands(long frame) {
  for (Runner* runner : programmed_) {
    // The frame in which an answer is due waits for it, unless the wall clock sets the pace.
    const bool due = runner->answered && runner->asked + 1 + runner->delay <= frame;
    if (due && runner->busy && !timing_.paced) pool_->wait();
    collect(*runner, frame);
    while (!runner->pending.empty() && runner->pending.front().due <= frame) {
      const client::CommandFrame& commands = runner->pending.front().commands;
      runner->refused_joints += runner->controlled.port.applyCommands(commands);
      setCameras(*runner, commands, frame);
      if (commands.beams) runner->beams = true, runner->beam = commands.beam;
      runner->pending.pop();
    }
  }
}

void ControlLoop::setCameras(Runner& runner, const client::CommandFrame& commands, long frame) {
  for (std::size_t i = 0; i < std::min(commands.camera_periods.size(), runner.controlled.cameraCount()); ++i) {
    const double period = commands.camera_periods[i];
    MountedCamera* camera = runner.controlled.camera(i);
    if (camera == nullptr || !(period >= 0)) continue;
    const double least = static_cast<double>(runner.period) * frame_length_;
    camera->lookEvery(period > 0 ? std::max(period, least) : 0, frame);
  }
}

/// Takes over what a task that has ended leaves behind: commands that can act from `next_frame` on.
void ControlLoop::collect(Runner& runner, long next_frame) {
  if (!runner.answered || runner.busy) return;
  runner.answered = false;
  for (Exposure& exposure : runner.exposures) {
    if (exposure.snapshot != kNoSnapshot) snapshots_->release(std::exchange(exposure.snapshot, kNoSnapshot));
  }
  if (runner.observer_fault != nullptr) std::rethrow_exception(std::exchange(runner.observer_fault, nullptr));
  runner.failed = runner.fault.has_value();
  if (runner.failed) return;  // half a step's commands are none
  const long due = runner.asked + 1 + runner.delay;
  if (due < next_frame) ++runner.late_commands;
  runner.pending.push(runner.commands, due);
  runner.outbox = runner.commands.message;
}

void ControlLoop::takePictures(long frame) {
  for (Runner* runner : programmed_) {
    if (!runner->runs()) continue;
    for (std::size_t i = 0; i < runner->waiting.size(); ++i) {
      const MountedCamera* camera = runner->controlled.eye(i);
      if (camera == nullptr || !camera->isDue(frame)) continue;
      Exposure& exposure = runner->waiting[i];
      if (exposure.snapshot != kNoSnapshot) snapshots_->release(exposure.snapshot);
      exposure = {snapshots_->hold(frame), frame, camera->place(view_, frame)};
    }
  }
}

void ControlLoop::deliverMessage(Runner& sender) {
  if (sender.outbox.number == 0) return;
  for (Runner* receiver : programmed_) {
    const bool mates = &sender != receiver && sender.team() == receiver->team();
    if (mates) receiver->inbox[static_cast<std::size_t>(sender.index)] = sender.outbox;
  }
  sender.outbox.number = 0;
}

void ControlLoop::findDue(long frame) {
  due_.clear();
  for (Runner* runner : programmed_) {
    if ((frame + 1) % runner->period == 0) due_.push_back(runner);
  }
}

void ControlLoop::publish(long frame) {
  takePictures(frame);
  findDue(frame);
  if (due_.empty()) return;
  if (!timing_.paced) pool_->wait();
  for (Runner* runner : due_) {
    collect(*runner, frame + 1);
    deliverMessage(*runner);
  }
  orderPictures();
  for (Runner* runner : due_) {
    if (!runner->runs()) continue;
    if (runner->answered) {
      ++runner->missed_frames;
    } else {
      launch(*runner, frame);
    }
  }
}

/// All robots' before the first one begins to look: a maker may work on the pictures of several cameras together.
void ControlLoop::orderPictures() {
  for (Runner* runner : due_) {
    if (!runner->runs() || runner->answered) continue;
    std::swap(runner->exposures, runner->waiting);
    for (std::size_t i = 0; i < runner->exposures.size(); ++i) {
      const Exposure& exposure = runner->exposures[i];
      if (exposure.snapshot == kNoSnapshot) continue;
      runner->controlled.eye(i)->order(snapshots_->scene(exposure.snapshot), exposure.place, exposure.frame);
    }
  }
  for (Runner* runner : due_) {
    if (!runner->runs() || runner->answered) continue;
    for (std::size_t i = 0; i < runner->exposures.size(); ++i)
      if (runner->exposures[i].snapshot != kNoSnapshot) runner->controlled.eye(i)->start();
  }
}

void ControlLoop::launch(Runner& runner, long frame) {
  runner.controlled.port.readSensors(static_cast<double>(frame + 1) * frame_length_, runner.sensors);
  runner.sensors.game = runner.game;
  runner.game.placed = false;
  runner.messages.clear();
  for (client::TeamMessage& message : runner.inbox) {
    if (message.number != 0) runner.messages.push_back(message);
    message.number = 0;
  }
  runner.sensors.team_messages = runner.messages;
  tellPoses(runner, frame);
  runner.asked = frame;
  runner.answered = true;
  for (ControlObserver* observer : observers_) observer->onSensors(runner.index, frame);
  runner.busy = true;
  pool_->launch(runner.index);
}

void ControlLoop::tellPoses(Runner& runner, long frame) {
  if (runner.controlled.localisation == nullptr) return;
  const std::span<const client::ToldPose> told = runner.controlled.localisation->tell(view_, frame);
  runner.sensors.own_pose = told.front();
  runner.mate_poses.clear();
  for (const client::ToldPose& mate : told.subspan(1)) {
    if (mate.valid) runner.mate_poses.push_back(mate);
  }
  runner.sensors.mate_poses = runner.mate_poses;
}

void ControlLoop::finish() {
  pool_->wait();
  for (auto& runner : robots_) {
    if (runner->observer_fault) std::rethrow_exception(std::exchange(runner->observer_fault, nullptr));
  }
}

ControlCounts ControlLoop::counts() const {
  ControlCounts sum;
  for (const auto& runner : robots_) {
    const ControlCounts& c = runner->counts;
    sum.picture_seconds += c.picture_seconds;
    sum.program_seconds += c.program_seconds;
    sum.pictures += c.pictures;
    sum.steps += c.steps;
    sum.refused_joints += runner->refused_joints;
    sum.late_commands += runner->late_commands;
    sum.missed_frames += runner->missed_frames;
    sum.failed_programs += runner->fault ? 1 : 0;
  }
  return sum;
}

std::vector<ProgramFault> ControlLoop::faults() const {
  std::vector<ProgramFault> faults;
  for (const auto& runner : robots_) {
    if (!runner->fault) continue;
    const double time = static_cast<double>(runner->asked + 1) * frame_length_;
    faults.push_back({runner->controlled.port.robot(), time, *runner->fault});
  }
  return faults;
}

void ControlLoop::archive(StateArchive& archive) {
  finish();
  for (auto& runner : robots_) {
    Runner& r = *runner;
    collect(r, r.asked);
    std::string fault = r.fault.value_or("");
    archive(r.game, r.inbox, r.outbox, r.waiting, r.pending, r.commands.joints, r.commands.message, r.asked);
    archive(r.beams, r.beam, r.failed, fault);
    r.fault = r.failed ? std::optional(fault) : std::nullopt;
    if (r.runs()) r.controlled.program->archive(archive);
    for (std::size_t i = 0; i < r.controlled.eyeCount(); ++i) {
      MountedCamera* camera = r.controlled.eye(i);
      if (camera == nullptr) continue;
      camera->archiveSchedule(archive);
      archive(*camera);
    }
    if (r.controlled.localisation != nullptr) archive(*r.controlled.localisation);
  }
  snapshots_->archive(archive);
}

}  // namespace murosimf
