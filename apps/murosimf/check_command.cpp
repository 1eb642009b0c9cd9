#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>

#include "game/game.h"
#include "murosimf/commands.h"
#include "murosimf/linking/schedule.h"
#include "murosimf/modules/all_modules.h"
#include "murosimf/robot/calibration_file.h"
#include "murosimf/robot/urdf_reader.h"
#include "murosimf/scene/scenario_reader.h"

namespace murosimf {

namespace {

/// A scenario is right when it can be read, its robots can, and everything links.
void checkScenario(const std::string& file, Diagnostics& diagnostics) {
  const std::optional<Scene> scene = readScenario(file, {}, diagnostics);
  if (scene) buildGame(*scene, diagnostics);
}

/// A calibration is right when it can be read and sees all of the picture whose size it tells.
void checkCalibration(const std::string& file, Diagnostics& diagnostics) {
  const std::optional<Calibration> calibration = readCalibrationFile(file, diagnostics);
  if (!calibration || !calibration->has_size) return;
  try {
    checkCamera(calibration->camera);
  } catch (const std::invalid_argument& problem) {
    diagnostics.error({file, 0, 0}, problem.what());
  }
}

}  // namespace

int checkFiles(const std::vector<std::string>& files) {
  Diagnostics diagnostics;
  for (const std::string& file : files) {
    const std::string suffix = std::filesystem::path(file).extension().string();
    if (suffix == ".toml") {
      checkScenario(file, diagnostics);
    } else if (suffix == ".urdf") {
      readUrdf(file, diagnostics);
    } else if (suffix == ".yaml" || suffix == ".yml" || suffix == ".m") {
      checkCalibration(file, diagnostics);
    } else {
      diagnostics.error({file, 0, 0}, fmt::format("file name ends with \"{}\"; expected .toml (scenario), .urdf "
                                                  "(robot), or .yaml, .yml or .m (calibration of a camera)",
                                                  suffix));
    }
  }
  fmt::print(stderr, "{}", diagnostics.text());
  if (diagnostics.hasErrors()) return kWrongInput;
  fmt::print("{} file{}: no mistakes found\n", files.size(), files.size() == 1 ? "" : "s");
  return 0;
}

int printModules(const std::string& scenario) {
  if (scenario.empty()) {
    fmt::print("{}", moduleTable(allModules(), frameAttachments({})));
    return 0;
  }
  Diagnostics diagnostics;
  const std::optional<Scene> scene = readScenario(scenario, {}, diagnostics);
  const std::unique_ptr<Simulation> simulation = scene ? buildGame(*scene, diagnostics) : nullptr;
  fmt::print(stderr, "{}", diagnostics.text());
  if (simulation == nullptr) return kWrongInput;
  fmt::print("{}", passTable(simulation->linked()));
  return 0;
}

}  // namespace murosimf
