// murosimf bench game: how many times faster than real time seven against seven at full detail are simulated.

#include <fmt/format.h>
#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <cstdio>
#include <stdexcept>
#include <thread>

#include "murosimf/bench/machine.h"
#include "murosimf/bench/recorded_game.h"
#include "murosimf/commands.h"

namespace murosimf {

namespace {

constexpr int kRuns = 3;
constexpr double kNoise = 0.015;  // standard deviation, share of full scale: what cameras have unless told

/// Simulated time over time of the wall clock: the median of the runs. Each of them must end as the recording did.
struct Speed {
  double factor = 0;
  long pictures = 0;
};
Speed replay(const Scene& scene, GameCommands& commands, double seconds, std::uint64_t hash) {
  std::vector<double> factors;
  Speed speed;
  for (int i = 0; i < kRuns; ++i) {
    RecordedGame game(scene, commands);
    factors.push_back(seconds / game.run(seconds));
    if (game.simulation().stateHash() != hash)
      throw std::runtime_error("the replayed game has gone another way than the recorded one");
    speed.pictures = game.simulation().control()->counts().pictures;
  }
  std::sort(factors.begin(), factors.end());
  speed.factor = factors[kRuns / 2];
  return speed;
}

/// Cameras that are off make no difference to physics.
Scene withoutCameras(Scene scene) {
  for (RobotSettings& robot : scene.robots) {
    for (ModuleChoice& camera : robot.cameras) camera.module.value = "none";
    robot.localisation.module.value = "none";
  }
  return scene;
}

}  // namespace

int printGameSpeed(const GameArguments& arguments) {
  const int lanes = lanesOf(arguments.isa);
  if (lanes < 0) {
    std::fprintf(stderr, "--isa: error: this machine has no AVX-512; expected avx2 or auto\n");
    return kWrongInput;
  }
  const int threads =
      arguments.threads > 0 ? arguments.threads : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  const oneapi::tbb::global_control limit(oneapi::tbb::global_control::max_allowed_parallelism,
                                          static_cast<std::size_t>(threads));
  std::printf("%s\n\n", machineLine(lanes).c_str());
  GameCommands commands;
  std::uint64_t hash = 0;
  const Scene told = sevenAgainstSeven({}, lanes, threads);
  {
    RecordedGame game(told, commands);
    game.run(arguments.seconds);
    hash = game.simulation().stateHash();
  }
  std::puts("| 7 versus 7, multibody, recorded control | threads | pictures | times real time |");
  std::puts("|---|---|---|---|");
  const auto print = [&](const char* name, const Scene& scene) {
    const Speed speed = replay(scene, commands, arguments.seconds, hash);
    std::printf("| %s | %d | %ld | %.2f |\n", name, threads, speed.pictures, speed.factor);
    std::fflush(stdout);
  };
  print("14 distorted cameras, 640 x 480, 30 Hz", sevenAgainstSeven(0.0, lanes, threads));
  print("the same with their sensors' noise", sevenAgainstSeven(kNoise, lanes, threads));
  print("no pictures", withoutCameras(told));
  return 0;
}

}  // namespace murosimf
