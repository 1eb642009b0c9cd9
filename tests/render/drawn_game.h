#pragma once

/// @file A game, ready to be drawn: for tests of pictures.

#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "game/game.h"
#include "murosimf/render/all_renderers.h"
#include "murosimf/scene/scenario_reader.h"

namespace murosimf::test {

/// The objects of a simulation in the order in which cameras label them, and the world's root at the end.
inline std::vector<ObjectId> labelledObjects(const Simulation& simulation) {
  const Participants& p = simulation.participants();
  std::vector<ObjectId> objects = p.free_bodies;
  objects.insert(objects.end(), p.robots.begin(), p.robots.end());
  objects.insert(objects.end(), p.fixed.begin(), p.fixed.end());
  objects.push_back(simulation.world().root());
  return objects;
}

/// The 3 versus 3 game after its first frame, nobody controlled.
struct DrawnGame {
  explicit DrawnGame(const RendererRegistry& registry = allRenderers(), std::vector<std::string> overrides = {})
      : list(meshes) {
    overrides.insert(overrides.end(),
                     {"robots.all.control=none", "robots.all.cameras.head=none", "robots.all.cameras.chest=none"});
    scene = readScenario("scenarios/game_3v3.toml", overrides, diagnostics);
    EXPECT_EQ(diagnostics.text(), "");
    simulation = buildGame(*scene, diagnostics,
                           [&](const Participants& participants) { return registry.attachments(participants.robots); });
    EXPECT_EQ(diagnostics.text(), "");
    renderings =
        std::make_unique<Renderings>(registry, simulation->world(), simulation->linked(), labelledObjects(*simulation));
    simulation->step();
  }
  const DrawList& draw() {
    renderings->draw({simulation->frame() - 1, simulation->time()}, list);
    return list;
  }

  Diagnostics diagnostics;
  std::optional<Scene> scene;
  std::unique_ptr<Simulation> simulation;
  std::unique_ptr<Renderings> renderings;
  MeshLibrary meshes;
  DrawList list;
};

}  // namespace murosimf::test
