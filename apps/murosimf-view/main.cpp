// murosimf-view SCENARIO: a window onto a game.

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "game/picture_drawers.h"
#include "murosimf-view/viewer.h"
#include "murosimf/render/all_renderers.h"
#include "murosimf/scene/scenario_reader.h"

namespace {

using namespace murosimf;

constexpr int kFault = 1, kWrongInput = 2;

struct Arguments {
  std::string scenario, script;
  std::vector<std::string> overrides;
  std::vector<int> size{1280, 800};
};

int show(const Arguments& arguments) {
  std::vector<ScriptLine> script;
  if (!arguments.script.empty()) script = readScript(arguments.script);
  Diagnostics diagnostics;
  std::optional<Scene> scene = readScenario(arguments.scenario, arguments.overrides, diagnostics);
  std::unique_ptr<Session> session;
  if (scene) session = std::make_unique<Session>(std::move(*scene), allRenderers(), diagnostics);
  std::fputs(diagnostics.text().c_str(), stderr);
  if (session == nullptr || diagnostics.hasErrors()) return kWrongInput;
  std::fputs(drawerText(session->simulation()).c_str(), stderr);
  Window window(arguments.size[0], arguments.size[1], "murosimf: " + arguments.scenario);
  std::fputs(describe(identifyGl()).c_str(), stderr);
  Viewer viewer(window, *session);
  viewer.view().shadows = !identifyGl().software;
  if (!arguments.script.empty()) viewer.setScript(std::move(script));
  viewer.run();
  return session->fault().empty() ? 0 : kFault;
}

int run(int argc, char** argv) {
  CLI::App app{"murosimf-view: a window onto a game of humanoid robots"};
  Arguments arguments;
  app.add_option("scenario", arguments.scenario, "scenario file (.toml)")->required();
  app.add_option("--set", arguments.overrides, "PATH=VALUE: change any value of the scenario")->allow_extra_args(false);
  app.add_option("--size", arguments.size, "width and height of the window [px]")->expected(2);
  app.add_option("--script", arguments.script,
                 "commands that drive the window (docs/viewer.md); it closes at their end");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : kWrongInput;
  }
  return show(arguments);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& fault) {
    std::fprintf(stderr, "murosimf-view: fault: %s\n", fault.what());
    return kFault;
  }
}
