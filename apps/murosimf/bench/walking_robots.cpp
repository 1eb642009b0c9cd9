#include "murosimf/bench/walking_robots.h"

#include <fmt/format.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <limits>
#include <set>
#include <stdexcept>
#include <thread>

#include "murosimf/bench/walking_world.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

namespace {

constexpr double kStanding = 0.15;  // [m] height of the base that nobody who stands is below
constexpr double kCameraPeriod = 0.05;
constexpr int kLeastSeen = 30;  // of what counts as seen

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

double processorTime() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Of the one camera that is on.
const Picture& pictureOf(const ControlledRobot& robot) {
  const auto on = std::find_if(robot.cameras.begin(), robot.cameras.end(), [](const auto& c) { return c != nullptr; });
  return (*on)->picture();
}

std::size_t allowed(int threads) {
  return threads > 0 ? static_cast<std::size_t>(threads) : std::max(1U, std::thread::hardware_concurrency());
}

}  // namespace

WalkingRobots::WalkingRobots(const RecordedWalk& walk, const WalkingSettings& settings, int robots)
    : walk_(walk),
      settings_(settings),
      threads_(oneapi::tbb::global_control::max_allowed_parallelism, allowed(settings.threads)),
      simulation_(buildWalkingWorld(walk, settings, robots)) {
  for (const ObjectId id : simulation_->participants().robots) {
    LinkedWorld& linked = simulation_->linked();
    Robot& robot = robots_.emplace_back();
    robot.object = id;
    robot.command = linked.handle(id, kJointCommand, subset::kJoints);
    robot.base = linked.handle(id, kBasePose);
    robot.delay = delayOf(walk, static_cast<int>(robots_.size()) - 1);
    for (int j = 0; settings.eye == Eye::kNone && j < robot.command.size(); ++j)
      robot.command.set({walk.at(-1)[static_cast<std::size_t>(j)], 0, 0, 1, 0}, j);
  }
  advance(static_cast<double>(walk.begin() + walk.stride()) * kReplayPeriod);
  for (Robot& robot : robots_) robot.start = robot.base.get();
  if (settings.eye != Eye::kNone) requireSight();
  pictures_before_ = simulation_->control()->counts().pictures;
}

WalkingRobots::~WalkingRobots() { simulation_->control()->finish(); }

void WalkingRobots::advance(double seconds) {
  const long frames = std::lround(seconds / settings_.frame), period = std::lround(kReplayPeriod / settings_.frame);
  for (long i = 0; i < frames; ++i) {
    if (settings_.eye == Eye::kNone && simulation_->frame() % period == 0) replay();
    simulation_->step();
  }
  simulation_->control()->finish();
}

double WalkingRobots::run(double seconds) {
  const auto stages = [&] {
    Shares shares;
    for (std::size_t i = 0; i < shares.stage.size(); ++i)
      shares.stage[i] = simulation_->stages().seconds(static_cast<Stage>(i));
    shares.stage[static_cast<std::size_t>(Stage::kCommands)] += replay_seconds_;
    shares.pictures = simulation_->control()->counts().picture_seconds;
    return shares;
  };
  const Shares before = stages();
  const double begin = now(), processor_begin = processorTime();
  advance(seconds);
  const double took = now() - begin;
  shares_.processor += processorTime() - processor_begin;
  const Shares after = stages();
  for (std::size_t i = 0; i < after.stage.size(); ++i) shares_.stage[i] += after.stage[i] - before.stage[i];
  shares_.pictures += after.pictures - before.pictures;
  run_seconds_ += seconds, wall_seconds_ += took;
  return took;
}

/// Positions alone change: the rest of a command stands.
void WalkingRobots::replay() {
  const double begin = now();
  const long step = std::lround(simulation_->time() / kReplayPeriod);
  constexpr std::size_t kTogether = 256, kAhead = 16;
  oneapi::tbb::parallel_for(oneapi::tbb::blocked_range<std::size_t>(0, robots_.size(), kTogether),
                            [&](const auto& range) {
                              for (std::size_t i = range.begin(); i < range.end(); ++i) {
                                if (i + kAhead < robots_.size()) robots_[i + kAhead].fetch();
                                const controllers::JointAngles& q = walk_.at(step - robots_[i].delay);
                                const LaneValues<ServoCommand> commands = robots_[i].command.values();
                                for (std::size_t j = 0; j < q.size(); ++j)
                                  commands.set(&ServoCommand::position, q[j], static_cast<int>(j));
                              }
                            });
  replay_seconds_ += now() - begin;
}

double WalkingRobots::leastWay() const {
  double least = std::numeric_limits<double>::infinity();
  for (const Robot& robot : robots_) {
    const Pose X_WB = robot.base.get();
    least = std::min(least, applyTransposed(robot.start.rotation, X_WB.translation - robot.start.translation).x);
  }
  return least;
}

void WalkingRobots::requireWalk() const {
  if (!simulation_->guard().faults().empty())
    throw std::runtime_error(fmt::format("a robot is frozen: {}", simulation_->guard().faults().front().what));
  for (const Robot& robot : robots_) {
    const double height = robot.base.get().translation.z;
    if (height < kStanding)
      throw std::runtime_error(
          fmt::format("{} has fallen: its base is {:.3f} m high", simulation_->world().path(robot.object), height));
  }
  const double way = leastWay(), wanted = walk_.velocity().vx * run_seconds_;
  if (way < 0.5 * wanted)
    throw std::runtime_error(
        fmt::format("a robot has gone {:.2f} m in {:.1f} s, expected {:.2f} m", way, run_seconds_, wanted));
  if (settings_.eye == Eye::kNone) return;
  const long made = simulation_->control()->counts().pictures - pictures_before_;
  const long due = std::lround(run_seconds_ / kCameraPeriod) * static_cast<long>(robots_.size());
  // Pictures of the last control period may still wait for the next one.
  if (made < due - static_cast<long>(robots_.size()))
    throw std::runtime_error(fmt::format("{} pictures were made, expected {}", made, due));
}

/// Every camera's last picture shows the ball and two robots, has depths and the right size.
void WalkingRobots::requireSight() const {
  for (int i = 0; i < simulation_->control()->robotCount(); ++i) {
    const Picture& picture = pictureOf(simulation_->control()->robot(i));
    std::set<std::uint16_t> robots;
    long ball = 0;
    for (const std::uint16_t label : picture.label) {
      const SeenKind kind = simulation_->view().classOf(label).kind;
      ball += kind == SeenKind::kFreeBody ? 1 : 0;
      if (kind == SeenKind::kRobot) robots.insert(label);
    }
    const bool whole = picture.width == 640 && picture.height == 480 && picture.depth.size() == picture.label.size();
    if (whole && ball >= kLeastSeen && robots.size() >= 2) continue;
    throw std::runtime_error(
        fmt::format("the camera of {} makes {} x {} pixels and sees {} pixels of the ball and {} robots; expected "
                    "640 x 480 with depths, {} pixels and 2 robots",
                    simulation_->world().path(robots_[static_cast<std::size_t>(i)].object), picture.width,
                    picture.height, ball, robots.size(), kLeastSeen));
  }
}

}  // namespace murosimf
