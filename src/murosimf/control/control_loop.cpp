#include "murosimf/control/control_loop.h"

#include <oneapi/tbb/task_arena.h>
#include <oneapi/tbb/task_group.h>

#include <chrono>

namespace murosimf {

namespace {

double secondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

/// One robot with everything that its task touches.
struct ControlLoop::Runner {
  struct Pending {
    client::CommandFrame commands;
    long due = 0;  // the frame at whose beginning they act
  };
  ControlledRobot controlled;
  int index = 0;
  client::SensorFrame sensors;
  client::GameInfo game;
  std::vector<client::TeamMessage> inbox;
  std::vector<client::CameraPicture> pictures;
  std::vector<std::pair<std::size_t, Pose>> due_cameras;  // with their poses X_WC
  const RayScene* scene = nullptr;
  client::CommandFrame commands;
  std::deque<Pending> pending;
  ControlCounts counts;
  std::atomic<bool> busy{false};
  bool answered = false;  // the last task's commands have not been put into `pending` yet
  long asked = 0;         // frame of the last sensor frame

  explicit Runner(ControlledRobot robot) : controlled(std::move(robot)), commands(controlled.port.emptyCommands()) {}
};

struct ControlLoop::Pool {
  oneapi::tbb::task_arena arena;
  oneapi::tbb::task_group group;
  explicit Pool(int threads) : arena(threads > 0 ? threads : oneapi::tbb::task_arena::automatic) {}
};

ControlLoop::ControlLoop(std::vector<ControlledRobot> robots, const SceneView& view, const ControlTiming& timing,
                         double frame_length)
    : view_(view),
      timing_(timing),
      frame_length_(frame_length),
      // Paced, the frame thread never waits, so somebody else must do the work.
      pool_(std::make_unique<Pool>(timing.paced && timing.threads == 1 ? 2 : timing.threads)),
      snapshots_(2, view.initialScene()) {
  for (ControlledRobot& robot : robots) {
    robots_.push_back(std::make_unique<Runner>(std::move(robot)));
    robots_.back()->index = static_cast<int>(robots_.size()) - 1;
  }
}

ControlLoop::~ControlLoop() { finish(); }

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
  robots_[static_cast<std::size_t>(robot)]->game = game;
}

const client::ControlReport* ControlLoop::report(int robot) const {
  const Runner& runner = *robots_[static_cast<std::size_t>(robot)];
  return runner.controlled.program == nullptr ? nullptr : &runner.controlled.program->report();
}

void ControlLoop::start() {
  for (auto& runner : robots_) {
    if (runner->controlled.program != nullptr) runner->controlled.program->start(runner->controlled.port.description());
  }
}

void ControlLoop::applyCommands(long frame) {
  for (auto& runner : robots_) {
    // The frame in which an answer is due waits for it, unless the wall clock sets the pace.
    const long due = runner->asked + 1 + timing_.delay;
    if (runner->answered && runner->busy && due <= frame && !timing_.paced) finish();
    if (runner->answered && !runner->busy) {
      if (due < frame) ++runner->counts.late_commands;
      runner->pending.push_back({runner->commands, due});
      runner->answered = false;
    }
    while (!runner->pending.empty() && runner->pending.front().due <= frame) {
      runner->counts.refused_joints += runner->controlled.port.applyCommands(runner->pending.front().commands);
      runner->pending.pop_front();
    }
  }
}

void ControlLoop::collectMessages() {
  for (auto& receiver : robots_) {
    receiver->inbox.clear();
    for (const auto& sender : robots_) {
      const bool mates = sender != receiver &&
                         sender->controlled.port.description().team == receiver->controlled.port.description().team;
      if (mates && sender->commands.message.number != 0) receiver->inbox.push_back(sender->commands.message);
    }
  }
}

void ControlLoop::publish(long frame) {
  if ((frame + 1) % timing_.period != 0) return;
  if (!timing_.paced) {
    finish();
    applyCommands(frame);
  }
  const bool all_free = [&] {
    for (const auto& runner : robots_) {
      if (runner->busy) return false;
    }
    return true;
  }();
  if (all_free) collectMessages();
  RayScene& scene = snapshots_[next_snapshot_];
  bool taken = false;
  for (auto& runner : robots_) {
    if (runner->controlled.program == nullptr) continue;
    if (runner->busy) {
      ++runner->counts.missed_frames;
      continue;
    }
    runner->due_cameras.clear();
    for (std::size_t i = 0; i < runner->controlled.cameras.size(); ++i) {
      const auto& camera = runner->controlled.cameras[i];
      if (camera != nullptr && camera->isDue(frame)) runner->due_cameras.emplace_back(i, camera->pose(view_, frame));
    }
    if (!runner->due_cameras.empty() && !taken) {
      view_.snapshot(frame, scene);
      taken = true;
    }
    runner->scene = &scene;
    launch(*runner, frame);
  }
  if (taken && all_free) next_snapshot_ = 1 - next_snapshot_;
}

void ControlLoop::launch(Runner& runner, long frame) {
  runner.controlled.port.readSensors(static_cast<double>(frame + 1) * frame_length_, runner.sensors);
  runner.sensors.game = runner.game;
  runner.sensors.team_messages = runner.inbox;
  runner.asked = frame;
  runner.answered = true;
  for (ControlObserver* observer : observers_) observer->onSensors(runner.index, frame);
  runner.busy = true;
  pool_->arena.execute([&] { pool_->group.run([this, &runner, frame] { runTask(runner, frame); }); });
}

void ControlLoop::runTask(Runner& runner, long frame) {
  auto start = std::chrono::steady_clock::now();
  runner.pictures.clear();
  for (const auto& [index, X_WC] : runner.due_cameras) {
    RobotCamera& camera = *runner.controlled.cameras[index];
    camera.render(*runner.scene, X_WC, frame);
    const Picture& picture = camera.picture();
    runner.pictures.push_back({static_cast<int>(index), runner.sensors.time, picture.width, picture.height,
                               std::span<const std::uint8_t>(picture.rgb)});
    ++runner.counts.pictures;
  }
  runner.counts.picture_seconds += secondsSince(start);
  start = std::chrono::steady_clock::now();
  runner.sensors.pictures = runner.pictures;
  runner.controlled.program->step(runner.sensors, runner.commands);
  runner.counts.program_seconds += secondsSince(start);
  ++runner.counts.steps;
  for (ControlObserver* observer : observers_) {
    observer->onStep(runner.index, frame, runner.sensors, runner.controlled, runner.controlled.program->report());
  }
  runner.busy = false;
}

void ControlLoop::finish() {
  pool_->arena.execute([&] { pool_->group.wait(); });
}

ControlCounts ControlLoop::counts() const {
  ControlCounts sum;
  for (const auto& runner : robots_) {
    const ControlCounts& c = runner->counts;
    sum.picture_seconds += c.picture_seconds;
    sum.program_seconds += c.program_seconds;
    sum.pictures += c.pictures;
    sum.steps += c.steps;
    sum.refused_joints += c.refused_joints;
    sum.late_commands += c.late_commands;
    sum.missed_frames += c.missed_frames;
  }
  return sum;
}

void ControlLoop::archive(StateArchive& archive) {
  finish();
  for (auto& runner : robots_) {
    std::vector<Runner::Pending> pending(runner->pending.begin(), runner->pending.end());
    std::size_t count = pending.size();
    archive(count, runner->game, runner->commands.joints, runner->commands.message, runner->asked, runner->answered);
    pending.resize(count);
    for (Runner::Pending& p : pending) archive(p.commands.joints, p.commands.message, p.due);
    runner->pending.assign(pending.begin(), pending.end());
    if (runner->controlled.program != nullptr) runner->controlled.program->archive(archive);
  }
}

}  // namespace murosimf
