#include "murosimf/sweep_command.h"

namespace murosimf {

namespace {

constexpr int kMostWorkers = 1024;

void addCommon(CLI::App& command, SweepArguments& arguments, SweepArguments::Action action) {
  command.add_option("plan", arguments.plan, "plan of the sweep (.toml)")->required();
  command.add_option("--out", arguments.out, "folder of the results, in the place of the plan's directory");
  command.parse_complete_callback([&arguments, action] { arguments.action = action; });
}

void addRunOptions(CLI::App& command, SweepArguments& arguments) {
  command.add_option("--shard", arguments.shard, "INDEX/COUNT: plays one part of the runs, 0/4 to 3/4");
  command.add_option("--workers", arguments.workers, "processes that play at once")->check(CLI::Range(1, kMostWorkers));
  command.add_option("--threads", arguments.threads, "threads of one game; 0: all")->check(CLI::Range(0, kMostWorkers));
  command.add_flag("--retry-failed", arguments.retry_failed, "play runs that failed once more");
}

}  // namespace

CLI::App* addSweep(CLI::App& app, SweepArguments& arguments) {
  CLI::App* command = app.add_subcommand("sweep", "many runs of a scenario: seeds x parameters (docs/sweeps.md)");
  command->require_subcommand(1);
  CLI::App* run = command->add_subcommand("run", "play the runs of a plan that have no result yet");
  addCommon(*run, arguments, SweepArguments::Action::kRun);
  addRunOptions(*run, arguments);
  CLI::App* collect = command->add_subcommand("collect", "write the table of the results, and a plot");
  addCommon(*collect, arguments, SweepArguments::Action::kCollect);
  collect->add_option("--program", arguments.program, "take results of the build whose hash begins so");
  CLI::App* status = command->add_subcommand("status", "tell how many runs are done, failed and missing");
  addCommon(*status, arguments, SweepArguments::Action::kStatus);
  return command;
}

}  // namespace murosimf
