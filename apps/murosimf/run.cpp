#include "murosimf/run.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "game/picture_drawers.h"
#include "murosimf/frozen_robots.h"
#include "murosimf/game_report.h"
#include "murosimf/scene/scenario_reader.h"
#include "murosimf/simulation/checkpoint.h"
#include "murosimf/simulation/overview.h"

namespace murosimf {

namespace {

double wallClock() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// The game may wait for whoever is to connect there, so people are told before it begins.
void tellAddresses(Simulation& simulation) {
  for (int i = 0; i < simulation.control()->robotCount(); ++i) {
    const client::ControlSoftware* program = simulation.control()->program(i);
    if (program != nullptr && !program->address().empty())
      fmt::print(stderr, "{}: its control software connects to {}\n",
                 simulation.world().path(simulation.control()->robot(i).port.robot()), program->address());
  }
}

/// The command line's word where it has one, else the scenario's; "none" and nothing are no file.
std::string chosenFile(const std::string& argument, const std::string& scenario) {
  const std::string file = argument.empty() ? scenario : argument;
  return file == "none" ? "" : file;
}

}  // namespace

Run::Run(const RunArguments& arguments, const Scene& scene, Diagnostics& diagnostics)
    : arguments_(arguments),
      scene_(scene),
      simulation_(buildGame(scene, diagnostics)),
      directory_(arguments.out.empty() ? *scene.output.directory : arguments.out) {
  if (simulation_ == nullptr) return;
  watch_ = std::make_unique<GameObservers>(scene_, *simulation_);
  if (!arguments_.report_only) addOutputs();
  if (*scene_.simulation.pace > 0) {
    pacer_ = std::make_unique<Pacer>(*scene_.simulation.pace, simulation_->frameLength());
  }
  if (!arguments_.from.empty()) loadCheckpoint(arguments_.from, *simulation_);
}

/// Observers must not be gone while a program still runs, as after an exception in the middle of a game.
Run::~Run() {
  if (simulation_ == nullptr) return;
  try {
    simulation_->control()->finish();
  } catch (...) {  // NOLINT: it has been thrown before, or nobody is left to tell
  }
}

/// A file named on the command line stands where it says, one named in the scenario in the run's folder.
std::filesystem::path Run::output(const std::string& file) const {
  const bool from_command_line = file == arguments_.record || file == arguments_.video;
  return from_command_line ? std::filesystem::path(file) : directory_ / file;
}

void Run::addOutputs() {
  fmt::print(stderr, "{}", drawerText(*simulation_));
  std::filesystem::create_directories(directory_);
  const std::string record = chosenFile(arguments_.record, *scene_.output.record);
  if (!record.empty()) {
    recorder_ = std::make_unique<Recorder>(output(record), *simulation_, scene_.file.string(), *scene_.simulation.seed);
    simulation_->observe(recorder_.get());
  }
  openFilm();
}

void Run::openFilm() {
  const std::string video = chosenFile(arguments_.video, *scene_.output.video);
  if (video.empty()) return;
  FilmSettings settings;
  settings.file = output(video);
  settings.caption = [this](double time) { return watch_->caption(time); };
  settings.tag_text = [this](int robot) { return watch_->tagOf(robot); };
  film_ = std::make_unique<Film>(*simulation_, std::move(settings));
  simulation_->observe(film_.get());
}

void Run::step() {
  const double start = wallClock();
  simulation_->step();
  const double seconds = wallClock() - start;
  frame_seconds_.add(seconds);
  longest_frame_ = std::max(longest_frame_, seconds);
  const bool due = arguments_.checkpoint_time >= 0 && simulation_->time() >= arguments_.checkpoint_time - 1e-9;
  if (due && !checkpoint_saved_ && !arguments_.checkpoint.empty()) {
    saveCheckpoint(arguments_.checkpoint, *simulation_, scene_.file.string());
    checkpoint_saved_ = true;
  }
}

bool Run::play(const std::function<bool()>& stop) {
  const long last_frame = std::lround(*scene_.simulation.duration / simulation_->frameLength());
  LiveLine line{LiveLine::Settings{}};
  bool stopped = false;
  tellAddresses(*simulation_);
  simulation_->start();
  const double start = wallClock();
  start_time_ = simulation_->time();
  if (pacer_ != nullptr) pacer_->start(start_time_);
  while (!stopped && simulation_->frame() < last_frame && !watch_->finished()) {
    step();
    if (pacer_ != nullptr) pacer_->wait(simulation_->time());
    if (simulation_->frame() % 10 != 0) continue;
    if (!arguments_.report_only) updateLine(line, wallClock() - start);
    stopped = stop && stop();
  }
  simulation_->control()->finish();
  wall_seconds_ = wallClock() - start;
  return !stopped;
}

void Run::updateLine(LiveLine& line, double wall_seconds) {
  if (!line.isDue(simulation_->time(), wall_seconds)) return;
  line.update(simulation_->time(), wall_seconds, simulation_->stages(), watch_->scoreText());
}

nlohmann::ordered_json Run::report() {
  const double simulated = simulation_->time() - start_time_;
  nlohmann::ordered_json report = basicReport(scene_, *simulation_, watch_->hashes(), simulated, wall_seconds_);
  report["frame_seconds"] = {{"median", frame_seconds_.percentile(0.5)},
                             {"p99", frame_seconds_.percentile(0.99)},
                             {"p999", frame_seconds_.percentile(0.999)},
                             {"longest", longest_frame_}};
  if (pacer_ != nullptr) report["pace"] = paceFigures(pacer_->report());
  if (watch_->referee() != nullptr) addMatch(report, *watch_->referee(), *watch_->match());
  if (watch_->broadcast() != nullptr) addGameController(report, *watch_->broadcast());
  if (watch_->trial() != nullptr) addTrial(report, *watch_->trial());
  if (watch_->percepts() != nullptr) addPercepts(report, *watch_->percepts(), *simulation_);
  addExchanges(report, scene_, watch_->exchanges(), *simulation_);
  addIntegration(report, watch_->integration(), *simulation_);
  report["robot_contacts"] = contactFigures(watch_->contacts().counts());
  addFrozenRobots(report, *simulation_);
  return report;
}

std::string Run::finish() {
  std::string text;
  for (const ProgramFault& fault : simulation_->control()->faults()) {
    text += fmt::format("warning: {}: control software failed at {:.3f} s and was not run again: {}\n",
                        simulation_->world().path(fault.robot), fault.time, fault.what);
  }
  text += writeFrozenRobots(*simulation_, directory_);
  if (film_ != nullptr) {
    const FilmReport film = film_->finish();
    if (!film.error.empty()) text += "warning: " + film.error + "\n";
  }
  if (recorder_ != nullptr) {
    const std::string problem = recorder_->finish();
    if (!problem.empty()) text += "warning: " + problem + "\n";
  }
  if (!arguments_.checkpoint.empty() && !checkpoint_saved_) {
    saveCheckpoint(arguments_.checkpoint, *simulation_, scene_.file.string());
  }
  if (*scene_.output.pictures) {
    writeOverview(directory_ / "overview.png", *simulation_, watch_->caption(simulation_->time()));
    writeCameraPictures(directory_, *simulation_, watch_->keeper());
  }
  const nlohmann::ordered_json written = report();
  writeReport(written, (directory_ / "report.json").string());
  return text + fmt::format("{:.1f} s simulated in {:.1f} s: {:.2f} times real time. {}\nResults: {}\n",
                            simulation_->time() - start_time_, wall_seconds_, written["real_time_factor"].get<double>(),
                            watch_->scoreText(), (directory_ / "report.json").string());
}

int runScenario(const RunArguments& arguments) {
  Diagnostics diagnostics;
  const std::optional<Scene> scene = readScenario(arguments.scenario, arguments.overrides, diagnostics);
  if (!scene) {
    fmt::print(stderr, "{}", diagnostics.text());
    return kWrongInput;
  }
  try {
    Run run(arguments, *scene, diagnostics);
    fmt::print(stderr, "{}", diagnostics.text());
    if (diagnostics.hasErrors()) return kWrongInput;
    run.play();
    fmt::print("{}", run.finish());
    return run.anyFrozen() ? kFault : 0;
  } catch (const client::CannotStart& problem) {
    fmt::print(stderr, "error: {}\n", problem.what());
    return kWrongInput;
  }
}

}  // namespace murosimf
