#include "game/picture_drawers.h"

#include <fmt/format.h>

#include <algorithm>

namespace murosimf {

std::vector<DrawnCameras> drawnCameras(const Simulation& simulation) {
  std::vector<DrawnCameras> all;
  const ControlLoop& control = *simulation.control();
  for (int i = 0; i < control.robotCount(); ++i) {
    for (const auto& camera : control.robot(i).cameras) {
      if (camera == nullptr) continue;
      const std::string& module = camera->settings().maker->name;
      auto place = std::find_if(all.begin(), all.end(), [&](const DrawnCameras& d) { return d.module == module; });
      if (place == all.end()) place = all.insert(place, {module, camera->maker().drawer(), 0});
      ++place->cameras;
    }
  }
  return all;
}

std::string drawerText(const Simulation& simulation) {
  std::string text;
  for (const auto& [module, drawer, cameras] : drawnCameras(simulation)) {
    if (drawer.name.empty()) continue;
    text += fmt::format("pictures of {} camera{} by {}\n", cameras, cameras == 1 ? "" : "s", drawer.name);
    if (!drawer.warning.empty()) text += fmt::format("warning: {}\n", drawer.warning);
  }
  return text;
}

}  // namespace murosimf
