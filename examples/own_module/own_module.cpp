// A simulator with a module of its own: own_module SCENARIO [PATH=VALUE ...]

#include <cmath>
#include <cstdio>

#include "battery.h"
#include "charge_renderer.h"
#include "murosimf/modules/all_modules.h"
#include "murosimf/render/all_renderers.h"
#include "murosimf/scene/scenario_reader.h"
#include "murosimf/scene/world_builder.h"
#include "murosimf/world/vocabulary.h"

namespace {

/// What a window or a picture would show of the robot: bars of batteries among all else. @returns how many
std::size_t drawBars(murosimf::Simulation& simulation, murosimf::ObjectId robot) {
  using namespace murosimf;
  RendererRegistry renderers = allRenderers();
  addChargeRenderer(renderers);
  Renderings renderings(renderers, simulation.world(), simulation.linked(), {robot});
  for (const RendererEntry& entry : renderings.entries()) renderings.show(entry.name, entry.name == "charge");
  MeshLibrary meshes;
  DrawList list(meshes);
  renderings.draw({simulation.frame() - 1, simulation.time()}, list);
  const auto& solid = list.solid();
  return solid.size() <= MeshLibrary::kCylinder ? 0 : solid[MeshLibrary::kCylinder].size();
}

}  // namespace

int main(int count, char** words) {
  using namespace murosimf;
  if (count < 2) return std::fputs("own_module SCENARIO [PATH=VALUE ...]\n", stderr), 2;
  Diagnostics diagnostics;
  const auto scene = readScenario(words[1], {words + 2, words + count}, diagnostics);
  if (!scene) return std::fputs(diagnostics.text().c_str(), stderr), 2;

  ModuleRegistry modules = allModules();
  addBattery(modules);
  WorldBuilder builder(*scene, diagnostics);
  const std::unique_ptr<Simulation> simulation = builder.link(modules, {});
  if (simulation == nullptr) return std::fputs(diagnostics.text().c_str(), stderr), 2;

  // Swing one arm at 2 rad/s: the servo runs at that speed as long as it has not arrived.
  const ObjectId robot = simulation->world().find("robots.red.1");
  Handle<ServoCommand> command = simulation->linked().handle(robot, kJointCommand, subset::kJoints);
  Handle<double> position = simulation->linked().handle(robot, kJointPosition, subset::kJoints);
  const int arm = 3;  // right shoulder pitch
  const double angle = 1.5;
  command.set({.position = angle, .velocity = 2.0, .torque = 0, .kp = 1.0, .kd = 0}, arm);
  while (simulation->time() < *scene->simulation.duration) simulation->step();

  const double left = simulation->linked().handle(robot, kBatteryCharge).get();
  const ModuleChoice& battery = scene->robots[0].modules[0];
  double idle_power = 3.0, loss = 1.0;
  for (const NamedValue& parameter : battery.parameters) {
    (parameter.name == "loss" ? loss : idle_power) = std::get<double>(*parameter.value);
  }
  const double capacity = *simulation->world().find(robot, kBatteryCapacity);
  const double used = idle_power * *scene->simulation.duration + loss * angle;
  const double expected = std::fmax(1 - used / capacity, 0.0);
  std::printf("arm at %.3f rad; %.3f J used; charge %.6f, expected %.6f\n", position.get(arm), (1 - left) * capacity,
              left, expected);
  if (drawBars(*simulation, robot) != 1) return std::puts("its bar is not drawn"), 1;
  return std::fabs(left - expected) < 1e-9 ? 0 : 1;
}
