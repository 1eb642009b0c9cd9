#pragma once

/// @file A field and a ball, nobody on it, and a referee: what the rules' tests look at.

#include <cmath>
#include <memory>

#include "murosimf/modules/all_modules.h"
#include "murosimf/soccer/field.h"
#include "murosimf/soccer/referee.h"

namespace murosimf {

/// The kid-size field of 2007 with a FIFA ball of size 1.
inline client::FieldDescription smallField() {
  client::FieldDescription f;
  f.length = 4.5, f.width = 3.0;
  f.goal_width = 1.5, f.goal_height = 0.9, f.goal_depth = 0.5, f.post_radius = 0.05;
  f.line_width = 0.05, f.border = 0.5;
  f.centre_circle_radius = 0.6;
  f.goal_area_length = 0.5, f.goal_area_width = 2.0;
  f.penalty_mark_distance = 1.5;
  f.ball_radius = 0.07;
  f.pole_radius = 0.1, f.pole_height = 0.6;
  return f;
}

inline void addBall(World& world, double radius) {
  const ObjectId ball = world.addPath("ball");
  world.set(ball, kMass, 0.205);
  world.set(ball, kInertiaFactor, 2.0 / 3);
  world.set(ball, kBallRadius, radius);
  world.set(ball, kShapes, {{0, Pose{}, makeSphere(radius), Colour{}, "ball", true, true}});
}

inline SurfaceTable ballSurfaces() {
  SurfacePair turf;
  turf.restitution_factor = 0.35, turf.rolling_resistance = 0.05;
  SurfaceTable table;
  table.set("ball", "turf", turf);
  table.set("ball", "post", SurfacePair{});
  return table;
}

struct FreeBallMatch {
  std::shared_ptr<World> world = std::make_shared<World>();
  std::unique_ptr<Simulation> simulation;
  MatchSettings settings;
  std::unique_ptr<Referee> referee;

  explicit FreeBallMatch(MatchSettings wanted = {}) : settings(std::move(wanted)) {
    settings.field = smallField();
    world->set(world->root(), kSurfaceTable, ballSurfaces());
    addBall(*world, settings.field.ball_radius);
    Participants who{{}, {world->find("ball")}, addField(*world, settings.field, {})};
    const ModuleRegistry registry = allModules();
    Linker linker(*world, registry, {});
    attachFrame(linker, who);
    Diagnostics diagnostics;
    std::unique_ptr<LinkedWorld> linked = linker.link(diagnostics);
    simulation = std::make_unique<Simulation>(world, std::move(linked), who);
    settings.ball = world->find("ball");
    place({0, 0, settings.field.ball_radius});
    referee = makeReferee(settings, *simulation);
    simulation->observe(referee.get());
  }

  void place(const Vector3& position, const Vector3& velocity = {}) {
    simulation->interventions().placeBody(simulation->frame(), settings.ball, position, velocity);
  }
  /// From a place on the ground, rolling.
  void shoot(double x, double y, double speed_x, double speed_y) {
    place({x, y, settings.field.ball_radius}, {speed_x, speed_y, 0});
  }
  void run(double seconds) {
    for (long i = std::lround(seconds / simulation->frameLength()); i > 0; --i) simulation->step();
  }
  /// Lets the time pass until the whistle.
  void runUntilPlaying() {
    while (referee->phase() != client::GamePhase::kPlaying) simulation->step();
  }
  Vector3 ball() { return simulation->linked().handle(settings.ball, kBasePose).get().translation; }
  int count(MatchEvent::Kind kind) const {
    int n = 0;
    for (const MatchEvent& event : referee->events()) n += event.kind == kind ? 1 : 0;
    return n;
  }
};

}  // namespace murosimf
