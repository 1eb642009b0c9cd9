// The command line: murosimf run | sweep | tailor | render | check | modules | compare | levels | bench.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <thread>

#include "murosimf/commands.h"
#include "murosimf/sweep_command.h"
#include "murosimf/tailor_command.h"

namespace {

using namespace murosimf;

void addRun(CLI::App& app, RunArguments& run) {
  CLI::App* command = app.add_subcommand("run", "play a scenario");
  command->add_option("scenario", run.scenario, "scenario file (.toml)")->required();
  command->add_option("--set", run.overrides, "PATH=VALUE: change any value of the scenario")->allow_extra_args(false);
  const auto shortcut = [&](const char* flag, const char* key, const char* help) {
    command->add_option_function<std::string>(
        flag, [&run, key](const std::string& value) { run.overrides.push_back(std::string(key) + "=" + value); }, help);
  };
  shortcut("--seed", "simulation.seed", "another seed, another game");
  shortcut("--threads", "simulation.threads", "threads to use; 0: all");
  shortcut("--lanes", "simulation.lanes", "robots per SIMD block: 1, 4, 8; 0: automatic");
  shortcut("--duration", "simulation.duration", "simulated seconds");
  shortcut("--pace", "simulation.pace", "simulated seconds per second of the wall clock; 0: as fast as possible");
  command->add_option("--out", run.out, "folder of the results");
  command->add_option("--record", run.record, "write a recording of every frame to this file");
  command->add_option("--video", run.video, "film the game into this file (mp4); none: no film");
  command->add_option("--checkpoint", run.checkpoint, "write a checkpoint to this file");
  command->add_option("--checkpoint-at", run.checkpoint_time, "simulated time of the checkpoint [s]; default: the end");
  command->add_option("--from", run.from, "continue from this checkpoint");
}

void addRender(CLI::App& app, RenderArguments& render) {
  CLI::App* command = app.add_subcommand("render", "take pictures of robots' cameras");
  command->add_option("scenario", render.scenario, "scenario file (.toml)")->required();
  command->add_option("--set", render.overrides, "PATH=VALUE: change any value of the scenario")
      ->allow_extra_args(false);
  command->add_option("--camera", render.cameras, "camera, as robots.red.1.camera; datasets: all where none is named")
      ->allow_extra_args(false);
  command->add_option("--at", render.at, "simulated time of the (first) picture [s]")->check(CLI::NonNegativeNumber);
  CLI::Option* as = command->add_option("--as", render.as, "what the picture shows");
  as->check(CLI::IsMember({"colour", "depth", "labels", "boxes"}));
  CLI::Option* out = command->add_option("--out", render.out, "file of the picture (.png)");
  CLI::Option* dataset = command->add_option("--dataset", render.dataset, "folder for a set of pictures (COCO)");
  dataset->excludes(as)->excludes(out);
  CLI::Option* every = command->add_option("--every", render.every, "time between a set's pictures [s]");
  every->check(CLI::PositiveNumber)->needs(dataset);
  dataset->needs(every);
  command->callback([&render] {
    if (render.dataset.empty() && render.cameras.size() != 1)
      throw CLI::ValidationError("--camera", "expected once, as --camera robots.red.1.camera");
  });
}

/// "all" is as many as the machine has.
std::vector<int> threadCounts(const std::vector<std::string>& words) {
  const int all = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  std::vector<int> counts;
  for (const std::string& word : words) {
    const int count = word == "all" ? all : std::stoi(word);
    if (std::find(counts.begin(), counts.end(), count) == counts.end()) counts.push_back(count);
  }
  return counts;
}

CLI::Option* addIsa(CLI::App& command, std::string& isa) {
  return command.add_option("--isa", isa, "registers: avx2, avx512 or auto, the widest")
      ->check(CLI::IsMember({"avx2", "avx512", "auto"}));
}

void addGame(CLI::App& bench, GameArguments& game) {
  CLI::App* command =
      bench.add_subcommand("game", "how many times faster than real time 7 against 7 robots at full detail are");
  command->add_option("--seconds", game.seconds, "simulated time")->check(CLI::Range(0.1, 1e4));
  command->add_option("--threads", game.threads, "threads to use; 0: all")->check(CLI::Range(0, 999));
  addIsa(*command, game.isa);
}

void addTable(CLI::App& bench, TableArguments& table) {
  CLI::App* command = bench.add_subcommand("table", "the largest number of walking robots in real time, row by row");
  command->add_option("--rows", table.rows, "names of rows, separated by commas; default: all")->delimiter(',');
  const auto counts = [&table](const std::vector<std::string>& words) { table.threads = threadCounts(words); };
  const CLI::Validator count(
      [](std::string& word) {
        const bool number = !word.empty() && word.size() < 4 && word.find_first_not_of("0123456789") == word.npos;
        return word == "all" || (number && std::stoi(word) > 0) ? std::string{}
                                                                : "expected 1 to 999 or all, found " + word;
      },
      "1..999|all");
  command->add_option_function<std::vector<std::string>>("--threads", counts, "numbers of threads; default: 1,all")
      ->delimiter(',')
      ->check(count);
  addIsa(*command, table.isa);
  command->add_option("--json", table.json, "write rows to this file");
  command->add_flag("--processor-time", table.processor,
                    "count processor time, where others use the machine: one thread alone");
  command->add_option("--robots", table.robots, "try this number alone; default: look for the largest")
      ->check(CLI::Range(1, 1000000));
  command->add_flag("--quick", table.quick, "a try-out of seconds: short runs, large steps");
}

void addBench(CLI::App& app, TableArguments& table, GameArguments& game) {
  table.threads = threadCounts({"1", "all"});
  CLI::App* bench = app.add_subcommand("bench", "measure how much this machine simulates in real time");
  bench->require_subcommand(1);
  addTable(*bench, table);
  addGame(*bench, game);
}

void addCheck(CLI::App& app, std::vector<std::string>& files) {
  CLI::App* command = app.add_subcommand(
      "check", "look for mistakes in scenarios (.toml), robots (.urdf) and calibrations (.yaml, .m)");
  command->add_option("files", files, "files to check")->required();
}

void addModules(CLI::App& app, std::string& scenario) {
  CLI::App* command = app.add_subcommand("modules", "print the table of modules and properties");
  command->add_option("--scenario", scenario, "print the passes that this scenario schedules instead");
}

void addCompare(CLI::App& app, std::string& a, std::string& b) {
  CLI::App* command = app.add_subcommand("compare", "say where two runs differ first");
  command->add_option("a", a, "recording or report.json of the one run")->required();
  command->add_option("b", b, "the same of the other")->required();
}

void addLevels(CLI::App& app, LevelsArguments& levels) {
  CLI::App* command = app.add_subcommand("levels", "walk at every level of detail and print the results side by side");
  command->add_option("--robots", levels.robots, "robots that walk at once")->check(CLI::Range(1, 60));
  command->add_option("--seconds", levels.seconds, "length of the walk")->check(CLI::Range(0.1, 1e4));
  command->add_option("--speed", levels.speed, "commanded [m/s]")->check(CLI::Range(0.0, 0.3));
}

/// Of all commands; one of them is asked for.
struct Arguments {
  RunArguments run;
  RenderArguments render;
  SweepArguments sweep;
  TailorArguments tailor;
  TableArguments table;
  GameArguments game;
  LevelsArguments levels;
  std::vector<std::string> files;  // to check
  std::string scenario;            // whose modules are printed
  std::string a, b;                // to be compared
};

/// In the order in which --help names them.
void addCommands(CLI::App& app, Arguments& arguments) {
  app.require_subcommand(1);
  addRun(app, arguments.run);
  addRender(app, arguments.render);
  addSweep(app, arguments.sweep);
  addTailor(app, arguments.tailor);
  addCheck(app, arguments.files);
  addModules(app, arguments.scenario);
  addCompare(app, arguments.a, arguments.b);
  addLevels(app, arguments.levels);
  addBench(app, arguments.table, arguments.game);
}

int perform(const CLI::App& app, const Arguments& arguments) {
  const CLI::App& command = *app.get_subcommands().front();
  const std::string& name = command.get_name();
  if (name == "render") return renderPictures(arguments.render);
  if (name == "sweep") return sweep(arguments.sweep);
  if (name == "tailor") return tailor(arguments.tailor);
  if (name == "check") return checkFiles(arguments.files);
  if (name == "modules") return printModules(arguments.scenario);
  if (name == "compare") return printComparison(arguments.a, arguments.b);
  if (name == "levels") return printLevels(arguments.levels);
  if (name == "bench") {
    return command.got_subcommand("game") ? printGameSpeed(arguments.game) : printTable(arguments.table);
  }
  return runScenario(arguments.run);
}

int run(int argc, char** argv) {
  CLI::App app{"murosimf: simulates teams of humanoid robots to test their control software"};
  app.set_version_flag("--version", MUROSIMF_VERSION);
  Arguments arguments;
  addCommands(app, arguments);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : kWrongInput;
  }
  return perform(app, arguments);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& fault) {
    std::fprintf(stderr, "murosimf: fault: %s\n", fault.what());
    return murosimf::kFault;
  }
}
