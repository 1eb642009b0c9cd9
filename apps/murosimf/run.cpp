#include "murosimf/run.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>

#include "murosimf/frozen_robots.h"
#include "murosimf/game_report.h"
#include "murosimf/match_setup.h"
#include "murosimf/scene/scenario_reader.h"
#include "murosimf/simulation/checkpoint.h"
#include "murosimf/simulation/live_line.h"
#include "murosimf/simulation/overview.h"

namespace murosimf {

namespace {

double wallClock() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
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
  std::filesystem::create_directories(directory_);
  addObservers();
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

void Run::addObservers() {
  ControlLoop& control = *simulation_->control();
  const MatchSettings match = matchSettings(scene_, simulation_->world());
  if (*scene_.referee.enabled) {
    referee_ = std::make_unique<Referee>(match, *simulation_);
    simulation_->observe(referee_.get());
    percepts_ = std::make_unique<PerceptStatistics>(match, *simulation_);
    control.observe(percepts_.get());
    simulation_->observe(percepts_.get());
    match_ = std::make_unique<MatchStatistics>(*referee_, *simulation_, percepts_.get());
    simulation_->observe(match_.get());
  }
  keeper_ = std::make_unique<PerceptKeeper>(control);
  control.observe(keeper_.get());
  exchanges_ = std::make_unique<ExchangeStatistics>(*simulation_);
  simulation_->observe(exchanges_.get());
  integration_ = std::make_unique<IntegrationStatistics>(*simulation_);
  simulation_->observe(integration_.get());
  simulation_->observe(&contacts_);
  simulation_->observe(&hashes_);
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
  settings.caption = [this](double time) {
    return referee_ == nullptr ? fmt::format("T {:.2f}", time)
                               : gameCaption(time, referee_->score(Team::kRed), referee_->score(Team::kBlue));
  };
  settings.tag_text = [this](int robot) { return tagOf(robot); };
  film_ = std::make_unique<Film>(*simulation_, std::move(settings));
  simulation_->observe(film_.get());
}

/// What a robot is at, and how hard its motion is to integrate where its integrator chooses its steps.
std::string Run::tagOf(int robot) const {
  if (simulation_->guard().frozen(static_cast<std::size_t>(robot))) return "frozen";
  const std::string activity(keeper_->activity(robot));
  const int substeps = integration_->substeps(robot);
  if (substeps == 0) return activity;
  return fmt::format("{} {} steps, error {:.0e}", activity, substeps, integration_->error(robot));
}

std::string Run::scoreText() const {
  return referee_ == nullptr
             ? ""
             : fmt::format("red {} : {} blue", referee_->score(Team::kRed), referee_->score(Team::kBlue));
}

void Run::step() {
  simulation_->step();
  const bool due = arguments_.checkpoint_time >= 0 && simulation_->time() >= arguments_.checkpoint_time - 1e-9;
  if (due && !checkpoint_saved_ && !arguments_.checkpoint.empty()) {
    saveCheckpoint(arguments_.checkpoint, *simulation_, scene_.file.string());
    checkpoint_saved_ = true;
  }
}

void Run::play() {
  const long last_frame = std::lround(*scene_.simulation.duration / simulation_->frameLength());
  LiveLine line{LiveLine::Settings{}};
  const double start = wallClock();
  start_time_ = simulation_->time();
  if (pacer_ != nullptr) pacer_->start(start_time_);
  while (simulation_->frame() < last_frame) {
    step();
    if (pacer_ != nullptr) pacer_->wait(simulation_->time());
    if (simulation_->frame() % 10 != 0) continue;
    const double wall = wallClock() - start;
    if (line.isDue(simulation_->time(), wall)) {
      line.update(simulation_->time(), wall, simulation_->stages(), scoreText());
    }
  }
  simulation_->control()->finish();
  wall_seconds_ = wallClock() - start;
}

nlohmann::ordered_json Run::report() {
  const double simulated = simulation_->time() - start_time_;
  nlohmann::ordered_json report = basicReport(scene_, *simulation_, hashes_, simulated, wall_seconds_);
  if (pacer_ != nullptr) report["pace"] = paceFigures(pacer_->report());
  if (referee_ != nullptr) addMatch(report, *referee_, *match_);
  if (percepts_ != nullptr) addPercepts(report, *percepts_, *simulation_);
  addExchanges(report, scene_, *exchanges_, *simulation_);
  addIntegration(report, *integration_, *simulation_);
  report["robot_contacts"] = contactFigures(contacts_.counts());
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
    const std::string caption = referee_ == nullptr ? fmt::format("T {:.2f}", simulation_->time())
                                                    : gameCaption(simulation_->time(), referee_->score(Team::kRed),
                                                                  referee_->score(Team::kBlue));
    writeOverview(directory_ / "overview.png", *simulation_, caption);
    writeCameraPictures(directory_, *simulation_, *keeper_);
  }
  const nlohmann::ordered_json written = report();
  writeReport(written, (directory_ / "report.json").string());
  return text + fmt::format("{:.1f} s simulated in {:.1f} s: {:.2f} times real time. {}\nResults: {}\n",
                            simulation_->time() - start_time_, wall_seconds_, written["real_time_factor"].get<double>(),
                            scoreText(), (directory_ / "report.json").string());
}

int runScenario(const RunArguments& arguments) {
  Diagnostics diagnostics;
  const std::optional<Scene> scene = readScenario(arguments.scenario, arguments.overrides, diagnostics);
  if (!scene) {
    fmt::print(stderr, "{}", diagnostics.text());
    return kWrongInput;
  }
  Run run(arguments, *scene, diagnostics);
  fmt::print(stderr, "{}", diagnostics.text());
  if (diagnostics.hasErrors()) return kWrongInput;
  run.play();
  fmt::print("{}", run.finish());
  return run.anyFrozen() ? kFault : 0;
}

}  // namespace murosimf
