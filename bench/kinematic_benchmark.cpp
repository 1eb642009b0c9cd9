// Kinematic walking of a team in lanes against the same, robot by robot: the reference gait, every robot with its own
// speed and in its own phase.

#include <fmt/format.h>

#include "modules/motion_world.h"
#include "paired_ratio.h"

namespace murosimf::bench {
namespace {

constexpr int kRobots = 24;
constexpr int kCycle = 52;  // steps of 10 ms

/// Robots that walk; counts the time of their motion's passes only, not that of commanding them.
class Team {
 public:
  explicit Team(int lanes) {
    for (int i = 0; i < kRobots; ++i) {
      motion_.add("robot" + std::to_string(i), motion::ks21(), angles(i, 0));
      for (int k = 0; k < kCycle; ++k) path_.push_back(angles(i, k));
    }
    motion_.link(lanes);
    for (const ObjectId robot : motion_.robots()) {
      commands_.push_back(motion_.linked().handle(robot, kJointCommand, subset::kJoints));
    }
    memory_ = AlignedDoubles(motion_.linked().stepMemorySize());
  }
  /// One cycle of the gait. @return seconds spent in passes of this name ("": of the whole motion)
  double cycle(std::string_view module) {
    double seconds = 0;
    for (int k = 0; k < kCycle; ++k, ++frame_) {
      command(k);
      for (const Batch& batch : motion_.linked().batches()) seconds += run(batch, module);
    }
    return seconds;
  }
  int lanes() const { return motion_.linked().batches()[0].width; }
  double filling() const {
    const Batch& batch = motion_.linked().batches()[0];
    return static_cast<double>(batch.members.size()) / (batch.blockCount() * batch.width);
  }

 private:
  static std::vector<double> angles(int robot, int k) {
    const controllers::WalkCommand command{0.03 * (robot % 7), 0.02 * (robot % 3) - 0.02, 0.2 * (robot % 5) - 0.4};
    return motion::gait(0.13 * robot + static_cast<double>(k) / kCycle, command);
  }
  void command(int k) {
    for (int i = 0; i < kRobots; ++i) {
      const std::vector<double>& q = path_[static_cast<std::size_t>(i * kCycle + k)];
      for (int j = 0; j < 21; ++j) {
        commands_[static_cast<std::size_t>(i)].set({q[static_cast<std::size_t>(j)], 0, 0, 1, 0}, j);
      }
    }
  }
  double run(const Batch& batch, std::string_view module) {
    double seconds = 0;
    for (const LinkedPass& pass : batch.passes) {
      if (pass.phase != Phase::kPrescribe) continue;
      const double begin = now();
      for (int b = 0; b < batch.blockCount(); ++b) {
        pass.module->step(batch.block(b, memory_.data()), {0.01 * static_cast<double>(frame_), pass.dt, frame_});
      }
      if (module.empty() || pass.name == module) seconds += now() - begin;
    }
    return seconds;
  }

  motion::MotionWorld motion_{0.01};
  std::vector<std::vector<double>> path_;
  std::vector<Handle<ServoCommand>> commands_;
  AlignedDoubles memory_;
  long frame_ = 0;
};

Row row(const std::string& name, std::string_view module) {
  Team lanes(widestLanes()), scalar(1);
  const Comparison c = compare([&] { return lanes.cycle(module); }, [&] { return scalar.cycle(module); }, 151);
  constexpr double kNanosecondsPerStep = 1e9 / (kRobots * kCycle);
  Row result{name, c.ratio, c.ours * kNanosecondsPerStep, c.peer * kNanosecondsPerStep, "ns/step", widestIsa(), ""};
  result.text =
      fmt::format("{}, per robot: lanes W={} (filling {:.0f} %) {:.1f} times scalar ({:.0f} ns, {:.0f} ns a step)",
                  name, lanes.lanes(), 100 * lanes.filling(), c.ratio, result.ours, result.peer);
  return result;
}

}  // namespace

std::vector<Part> kinematicParts() {
  return {[]() -> std::vector<Row> {
    return {row("kinematic walking", ""), row("  of it servos", "ideal_servo"),
            row("  of it stance foot", "kinematic_walking"), row("  of it body poses", "body_poses")};
  }};
}

}  // namespace murosimf::bench
