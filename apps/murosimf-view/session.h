#pragma once

/// @file What the window shows: a game that runs, pauses and goes back, with everything that can be drawn of it.
///
/// Knows no window: all of it can be driven by tests. Everything happens on one thread; control software and its
/// pictures run on others meanwhile. What is read between two frames is a world at rest.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "game/game_observers.h"
#include "game/scans_renderer.h"
#include "murosimf-view/plots.h"
#include "murosimf-view/pull.h"
#include "murosimf-view/run_viewer.h"
#include "murosimf/render/property_renderer.h"
#include "murosimf/simulation/frame_history.h"
#include "murosimf/simulation/recording_player.h"

namespace murosimf {

/// How fast it went, over about the last second of wall time.
struct RunFigures {
  double factor = 0;                                                           ///< simulated seconds a second
  std::array<double, static_cast<std::size_t>(Stage::kCount)> stage_shares{};  ///< of the time in frames, each
};

class Session {
 public:
  /// Builds the world and runs its first frame. Where something is wrong with the scene, diagnostics gets errors and
  /// nothing else may be called.
  Session(Scene scene, const ViewerParts& parts, Diagnostics& diagnostics);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  const Scene& scene() const { return scene_; }
  const ModuleRegistry& modules() const { return modules_; }
  Simulation& simulation() { return *simulation_; }
  const World& world() const { return simulation_->world(); }
  const GameObservers& game() const { return *game_; }
  FrameHistory& history() { return *history_; }
  Renderings& renderings() { return *renderings_; }
  Plots& plots() { return plots_; }

  bool running = false;
  double speed = 1;  ///< wanted: simulated seconds a second
  /// Doubles it or halves it, from 1/64 to 64.
  void changeSpeed(bool faster);

  /// Runs frames for this much wall time: as many as the speed asks for, and no longer than `budget` [s].
  void advance(double wall_seconds, double budget);
  /// Runs this many frames, however long that takes; pauses.
  void run(long frames);
  /// Goes forward (or back) by frames, and pauses.
  void goBy(long frames);
  const RunFigures& figures() const { return figures_; }

  ObjectId selected;     ///< an object of the world; invalid: none
  int selected_row = 0;  ///< of a robot: the body that was clicked

  std::optional<Pull> pull;  ///< acts while there is one
  std::string pull_refused;  ///< why the last attempt to pull had no effect, until the next click; empty: it had

  /// Shows a recording in the place of the simulation, until it is closed. @throws as RecordingPlayer
  void openRecording(const std::string& file);
  void closeRecording();
  /// Null while the simulation is shown.
  RecordingPlayer* recording() { return recording_.get(); }
  /// Goes to a time of the recording, and pauses.
  void showRecording(double time);

  /// What the simulation threw, after which it does not run any more; empty: nothing.
  const std::string& fault() const { return fault_; }

  /// All that is shown now.
  void draw(DrawList& list);

 private:
  bool step();
  double timeOf(long frames) const;
  void measure(double wall_seconds);

  Scene scene_;
  ModuleRegistry modules_;
  std::unique_ptr<Simulation> simulation_;
  std::unique_ptr<GameObservers> game_;
  Plots plots_;
  std::unique_ptr<ScanPlaces> scan_places_;
  std::unique_ptr<FrameHistory> history_;
  std::unique_ptr<Renderings> renderings_;
  std::unique_ptr<RecordingPlayer> recording_;
  double recording_time_ = 0;
  double owed_ = 0;  // simulated time that is still to be run [s]
  std::string fault_;
  RunFigures figures_;
  bool ran_ = false;                                                      // run() did, in this picture
  double wall_ = 0, simulated_ = 0;                                       // since the last measurement
  std::array<double, static_cast<std::size_t>(Stage::kCount)> stages_{};  // at the last measurement
};

}  // namespace murosimf
