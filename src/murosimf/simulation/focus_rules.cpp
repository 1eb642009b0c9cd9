#include "murosimf/simulation/focus_rules.h"

#include <algorithm>

namespace murosimf {

namespace {

/// Of the base's z axis, upwards: whoever leans more may be about to fall.
constexpr double kUpright = 0.9;

double squaredDistance(const Pose& a, const Pose& b) {
  const double x = a.translation.x - b.translation.x, y = a.translation.y - b.translation.y;
  return x * x + y * y;
}

}  // namespace

FocusRules::FocusRules(Simulation& simulation, const std::vector<FocusRule>& rules) {
  LinkedWorld& linked = simulation.linked();
  for (const ObjectId robot : simulation.participants().robots) robots_.push_back(linked.handle(robot, kBasePose));
  for (const ObjectId ball : simulation.participants().free_bodies) balls_.push_back(linked.handle(ball, kBasePose));
  for (const FocusRule& rule : rules) {
    watched_.push_back({rule, LevelExchanger(linked, rule.robot), &linked.residentOf(rule.robot),
                        linked.handle(rule.robot, kBasePose)});
  }
}

bool FocusRules::isNear(const Watched& watched, double more) const {
  const Pose base = watched.base.get();
  const auto within = [&](double distance) {
    return [&base, square = (distance + more) * (distance + more)](const Handle<Pose>& other) {
      return squaredDistance(base, other.get()) < square;
    };
  };
  const FocusRule& rule = watched.rule;
  if (rule.ball > 0 && std::any_of(balls_.begin(), balls_.end(), within(rule.ball))) return true;
  // The robot finds itself among the robots.
  return rule.robots > 0 && std::count_if(robots_.begin(), robots_.end(), within(rule.robots)) > 1;
}

void FocusRules::afterFrame(Simulation& simulation) {
  for (const Watched& watched : watched_) {
    if (!watched.exchanger.ready(simulation.frame())) continue;
    const FocusRule& rule = watched.rule;
    const bool close = watched.resident->level == rule.near_level;
    const bool leans = watched.base.get().rotation.z.z < kUpright;
    const bool wanted = isNear(watched, close ? rule.margin : 0) || (close && leans);
    if (wanted == close) continue;
    simulation.interventions().exchangeLevel(simulation.frame(), rule.robot, wanted ? rule.near_level : rule.far_level);
  }
}

}  // namespace murosimf
