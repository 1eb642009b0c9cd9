#pragma once

/// @file One run of a scenario with everything that watches it.

#include <filesystem>
#include <functional>
#include <memory>

#include "game/game.h"
#include "game/game_observers.h"
#include "murosimf/commands.h"
#include "murosimf/report.h"
#include "murosimf/simulation/film.h"
#include "murosimf/simulation/live_line.h"
#include "murosimf/simulation/pacer.h"
#include "murosimf/simulation/recorder.h"

namespace murosimf {

class Run {
 public:
  /// Builds the world and opens all outputs. Where something is wrong with the input, diagnostics gets errors and the
  /// run must not be started. @throws std::runtime_error when an output cannot be opened.
  Run(const RunArguments& arguments, const Scene& scene, Diagnostics& diagnostics);
  ~Run();
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;

  /// Plays to the end of the scenario's duration.
  /// @param stop  asked every ten frames; the game ends there once it says so
  /// @return false after it was stopped
  bool play(const std::function<bool()>& stop = {});
  /// Writes report, pictures and checkpoint. @returns the lines to print
  std::string finish();
  /// What goes into report.json, of the game as far as it was played.
  nlohmann::ordered_json report();
  /// Whether the state of a robot was no number any more, which is a fault of ours or of the numbers that were chosen.
  bool anyFrozen() const { return !simulation_->guard().faults().empty(); }

 private:
  void addOutputs();
  void openFilm();
  void step();
  void updateLine(LiveLine& line, double wall_seconds);
  std::filesystem::path output(const std::string& file) const;

  RunArguments arguments_;
  const Scene& scene_;
  std::unique_ptr<Simulation> simulation_;
  std::filesystem::path directory_;
  std::unique_ptr<GameObservers> watch_;
  std::unique_ptr<Recorder> recorder_;
  std::unique_ptr<Film> film_;
  std::unique_ptr<Pacer> pacer_;
  SampleReservoir frame_seconds_{100'000};  // wall time of frames, without the pacer's sleep
  double longest_frame_ = 0;                // [s]
  double start_time_ = 0;                   // simulated [s]
  double wall_seconds_ = 0;                 // of the frames
  bool checkpoint_saved_ = false;
};

}  // namespace murosimf
