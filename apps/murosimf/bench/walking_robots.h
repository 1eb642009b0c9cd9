#pragma once

/// @file Many KS21 that walk in the product's own simulation, moved by a recorded gait: what is measured by
/// `murosimf bench table`.
///
/// Everything of a frame is there: interventions, commands, motion, contacts of all with all and with the field's goals
/// and ball, sensors, ports. Robots without cameras have no control software: their commands are written where a port
/// writes them, every 10 ms. Robots with a camera have a program that looks at nothing and replays the same rows, since
/// pictures are made for programs. Robots begin at different places of the stride, so that no two robots of a register
/// do the same.
///
/// Without cameras they stand on a field as large as needed, as many a square metre as 22 have on 9 m x 6 m, and walk
/// straight on. With cameras they stand on a ring about the ball and walk towards it, so that all see it and those on
/// the other side.

#include <oneapi/tbb/global_control.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "murosimf/bench/recorded_walk.h"
#include "murosimf/scene/world_builder.h"

namespace murosimf {

/// No camera; the head camera without its lens' distortion, as wide an angle; the head camera.
enum class Eye : std::uint8_t { kNone, kStraight, kDistorted };

struct WalkingSettings {
  std::string level;     ///< of detail, as scenarios call it
  double frame = 0.001;  ///< [s]
  Eye eye = Eye::kNone;
  int lanes = 0;    ///< robots a block: 4, 8; 0: as it suits the machine. Pixels likewise: 8, 16
  int threads = 1;  ///< 0: all
};

inline constexpr double kReplayPeriod = 0.01;  ///< of recorded rows [s]

class WalkingRobots {
 public:
  /// Builds the world and lets all robots begin to walk, until they go as fast as they are to.
  /// @throws std::runtime_error with what the builder says; what requireSight() throws
  WalkingRobots(const RecordedWalk& walk, const WalkingSettings& settings, int robots);
  ~WalkingRobots();
  WalkingRobots(const WalkingRobots&) = delete;
  WalkingRobots& operator=(const WalkingRobots&) = delete;

  /// Time of the wall clock that parts of the frame took [s]. Pictures: summed over threads, part of publishing on one.
  struct Shares {
    std::array<double, static_cast<std::size_t>(Stage::kCount)> stage{};
    double pictures = 0;
    double processor = 0;  ///< time of all threads together, whatever others did meanwhile
  };
  /// Goes on for so long. @return time of the wall clock [s]
  double run(double seconds);
  /// Simulated time of all runs, and what they took of the wall clock [s].
  double simulated() const { return run_seconds_; }
  double wall() const { return wall_seconds_; }
  /// Of all runs.
  const Shares& shares() const { return shares_; }
  /// Shortest way that a robot has gone forward in all runs [m].
  double leastWay() const;
  /// @throws std::runtime_error when a robot has fallen, is frozen or has gone less than half of what was commanded, or
  ///         a camera has made fewer pictures than were due
  void requireWalk() const;
  const Simulation& simulation() const { return *simulation_; }

 private:
  struct Robot {
    ObjectId object;
    Handle<ServoCommand> command;
    Handle<Pose> base;
    long delay = 0;  // steps behind the recording
    Pose start;      // when the runs begin
    /// Asks the memory for what a replay writes.
    void fetch() const { command.values().fetch(&ServoCommand::position, command.size()); }
  };
  void build(int robots);
  void advance(double seconds);
  void replay();
  void requireSight() const;

  const RecordedWalk& walk_;
  WalkingSettings settings_;
  oneapi::tbb::global_control threads_;
  std::unique_ptr<Simulation> simulation_;
  std::vector<Robot> robots_;
  Shares shares_;
  double replay_seconds_ = 0, run_seconds_ = 0, wall_seconds_ = 0;  // [s]
  long pictures_before_ = 0;                                        // of the runs
};

}  // namespace murosimf
