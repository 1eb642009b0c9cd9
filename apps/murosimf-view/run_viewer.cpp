#include "murosimf-view/run_viewer.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "game/game.h"
#include "game/picture_drawers.h"
#include "murosimf-view/viewer.h"
#include "murosimf/modules/all_modules.h"
#include "murosimf/render/all_renderers.h"
#include "murosimf/scene/scenario_reader.h"

namespace murosimf {

namespace {

constexpr int kFault = 1, kWrongInput = 2;

struct Arguments {
  std::string scenario, script;
  std::vector<std::string> overrides;
  std::vector<int> size{1280, 800};
};

/// What to return at once: 0 after help, 2 for wrong words; nothing when all is well.
std::optional<int> readArguments(int count, char** words, Arguments& arguments) {
  CLI::App app{"a window onto a game of humanoid robots"};
  app.add_option("scenario", arguments.scenario, "scenario file (.toml)")->required();
  app.add_option("--set", arguments.overrides, "PATH=VALUE: change any value of the scenario")->allow_extra_args(false);
  app.add_option("--size", arguments.size, "width and height of the window [px]")->expected(2);
  app.add_option("--script", arguments.script,
                 "commands that drive the window (docs/viewer.md); it closes at their end");
  try {
    app.parse(count, words);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : kWrongInput;
  }
  return {};
}

/// Null when something is wrong, which has been told then.
std::unique_ptr<Session> openSession(const Arguments& arguments, const ViewerParts& parts) {
  Diagnostics diagnostics;
  std::optional<Scene> scene = readScenario(arguments.scenario, arguments.overrides, diagnostics);
  std::unique_ptr<Session> session;
  if (scene) session = std::make_unique<Session>(std::move(*scene), parts, diagnostics);
  std::fputs(diagnostics.text().c_str(), stderr);
  return diagnostics.hasErrors() ? nullptr : std::move(session);
}

int show(const Arguments& arguments, const ViewerParts& parts) {
  std::vector<ScriptLine> script;
  if (!arguments.script.empty()) script = readScript(arguments.script);
  const std::unique_ptr<Session> session = openSession(arguments, parts);
  if (session == nullptr) return kWrongInput;
  std::fputs(drawerText(session->simulation()).c_str(), stderr);
  Window window(arguments.size[0], arguments.size[1], "murosimf: " + arguments.scenario);
  std::fputs(describe(identifyGl()).c_str(), stderr);
  Viewer viewer(window, *session);
  viewer.view().shadows = !identifyGl().software;
  if (!arguments.script.empty()) viewer.setScript(std::move(script));
  viewer.run();
  return session->fault().empty() ? 0 : kFault;
}

}  // namespace

ViewerParts allViewerParts() { return {allModules(), allPrograms(), allRenderers()}; }

int runViewer(int count, char** words, const ViewerParts& parts) {
  try {
    Arguments arguments;
    const std::optional<int> result = readArguments(count, words, arguments);
    return result ? *result : show(arguments, parts);
  } catch (const std::exception& fault) {
    std::fprintf(stderr, "%s: fault: %s\n", words[0], fault.what());
    return kFault;
  }
}

}  // namespace murosimf
