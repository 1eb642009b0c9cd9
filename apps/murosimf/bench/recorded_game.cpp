#include "murosimf/bench/recorded_game.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <stdexcept>

#include "game/game.h"
#include "game/match_setup.h"
#include "murosimf/scene/scenario_reader.h"
#include "player/player.h"

namespace murosimf {

namespace {

/// The reference player, whose commands are kept.
class RecordingPlayer final : public client::ControlSoftware {
 public:
  explicit RecordingPlayer(std::vector<std::vector<client::JointCommand>>& kept)
      : player_(controllers::makePlayer()), kept_(kept) {}
  void start(const client::RobotDescription& robot) override { player_->start(robot); }
  void step(const client::SensorFrame& sensors, client::CommandFrame& commands) override {
    player_->step(sensors, commands);
    kept_.push_back(commands.joints);
  }
  const client::ControlReport& report() const override { return player_->report(); }
  void archive(client::StateArchive& archive) override { player_->archive(archive); }

 private:
  std::unique_ptr<client::ControlSoftware> player_;
  std::vector<std::vector<client::JointCommand>>& kept_;
};

/// Looks at nothing; goes on with the last step where the recording ends.
class Replayer final : public client::ControlSoftware {
 public:
  explicit Replayer(const std::vector<std::vector<client::JointCommand>>& kept) : kept_(kept) {}
  void start(const client::RobotDescription&) override {}
  void step(const client::SensorFrame&, client::CommandFrame& commands) override {
    commands.joints = kept_[std::min(next_, kept_.size() - 1)];
    ++next_;
  }
  const client::ControlReport& report() const override { return report_; }
  void archive(client::StateArchive& archive) override { archive(next_); }

 private:
  const std::vector<std::vector<client::JointCommand>>& kept_;
  std::size_t next_ = 0;
  client::ControlReport report_;
};

/// Where red's robots stand when it kicks off; blue's stand across, its first two outside the circle.
constexpr PlanarPose kPlaces[] = {{-4.3, 0, 0},  {-3, 1.2, 0},   {-3, -1.2, 0}, {-1.8, 2, 0},
                                  {-1.8, -2, 0}, {-1.0, 0.8, 0}, {-0.3, 0, 0}};
constexpr double kOutside = 0.9;  // [m] from the centre

std::string robotText(const char* team, int number) {
  const PlanarPose& place = kPlaces[number - 1];
  const bool red = std::string_view(team) == "red";
  const double x = red ? place.x : -std::min(place.x, -kOutside), y = red ? place.y : -place.y;
  return fmt::format("[robots.{}.{}]\nrole = \"{}\"\npose = [{}, {}, {}]\n", team, number,
                     number == 1  ? "keeper"
                     : number < 6 ? "defender"
                                  : "striker",
                     x, y, red ? 0 : kPi);
}

}  // namespace

Scene sevenAgainstSeven(std::optional<double> noise, int lanes, int threads) {
  std::string text = fmt::format(
      "[simulation]\nlanes = {}\nthreads = {}\n[field]\npreset = \"2025_kid\"\n[robots.all]\n"
      "file = \"robots/ks21.urdf\"\nlevel = \"full\"\ncontrol = \"player\"\nlocalisation = \"oracle\"\n"
      "cameras = {{head = {}, chest = \"none\"}}\n",
      lanes, threads, noise ? fmt::format("{{period = {}, noise = {}}}", 1.0 / 30, *noise) : "\"oracle\"");
  for (const char* team : {"red", "blue"}) {
    for (int number = 1; number <= static_cast<int>(std::size(kPlaces)); ++number) text += robotText(team, number);
  }
  Diagnostics diagnostics;
  auto scene = readScenarioText(text, "game.toml", {}, diagnostics);
  if (!scene) throw std::runtime_error(diagnostics.text());
  return *scene;
}

RecordedGame::RecordedGame(const Scene& scene, GameCommands& commands) {
  const bool recording = commands.empty();
  if (recording) commands.resize(scene.robots.size());
  std::size_t next = 0;
  const auto program = [&]() -> std::unique_ptr<client::ControlSoftware> {
    auto& kept = commands[next++];
    if (recording) return std::make_unique<RecordingPlayer>(kept);
    return std::make_unique<Replayer>(kept);
  };
  Diagnostics diagnostics;
  simulation_ = buildGame(scene, diagnostics, {}, allModules(), {{"player", program}});
  if (simulation_ == nullptr) throw std::runtime_error(diagnostics.text());
  referee_ = makeReferee(matchSettings(scene, simulation_->world()), *simulation_);
  simulation_->observe(referee_.get());
}

RecordedGame::~RecordedGame() { simulation_->control()->finish(); }

double RecordedGame::run(double seconds) {
  const auto now = [] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  };
  const double begin = now();
  for (long i = std::lround(seconds / simulation_->frameLength()); i > 0; --i) simulation_->step();
  simulation_->control()->finish();
  return now() - begin;
}

}  // namespace murosimf
