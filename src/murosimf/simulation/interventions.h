#pragma once

/// @file Interventions: everything that changes state from outside the physics, in one recorded queue.
///
/// The referee placing the ball, a person moving a robot: each says at which frame it acts, and all of a frame act
/// before anything else, in the order (frame, object's path, order of request). A run is repeated by scenario, seed,
/// commands and interventions.

#include <string>
#include <vector>

#include "murosimf/math/state_archive.h"
#include "murosimf/modules/contact/pair_phase.h"
#include "murosimf/modules/motion/level_exchanger.h"
#include "murosimf/modules/motion/robot_placer.h"

namespace murosimf {

/// One change.
struct Intervention {
  enum class Kind { kPlaceRobot, kPlaceBody, kExchangeLevel, kPush };
  Kind kind = Kind::kPlaceRobot;
  ObjectId object;
  PlanarPose pose;    ///< kPlaceRobot: base on the ground; kPlaceBody: x, y of the centre; kPush: where it acts
  double height = 0;  ///< kPlaceBody: of the centre; kPush: where it acts [m]
  Vector3 velocity;   ///< kPlaceBody [m/s]; kPush: the force [N]
  int level = 0;      ///< kExchangeLevel: number of the level of detail; kPush: row of the robot's body
};

class InterventionQueue {
 public:
  /// World and pair phase must live longer.
  InterventionQueue(const World& world, LinkedWorld& linked, PairPhase& pairs, const std::vector<ObjectId>& robots,
                    const std::vector<ObjectId>& free_bodies);

  /// Acts at the beginning of this frame, or of the next one that begins.
  /// @throws std::invalid_argument when a number is not finite, or for an object that cannot be placed
  void request(long frame, const Intervention& intervention);
  /// Throws what request() would throw.
  void check(const Intervention& intervention) const;
  void placeRobot(long frame, ObjectId robot, const PlanarPose& pose);
  void placeBody(long frame, ObjectId body, const Vector3& position, const Vector3& velocity = {});
  /// Gives the robot another of the levels of detail with which it was linked, as soon as the steps of all of them end
  /// together (LevelExchanger).
  void exchangeLevel(long frame, ObjectId robot, int level);
  /// Pushes a free body, or the body on a row of a robot, with a force over one frame, at a place in W. A robot whose
  /// motion is prescribed does not feel it.
  void push(long frame, ObjectId object, int row, const Vector3& p_W, const Vector3& force_W);
  /// Applies what is due.
  void apply(long frame);

  struct Logged {
    long frame = 0;
    Intervention intervention;
  };
  /// Everything applied in the frame that began last, for observers.
  const std::vector<Logged>& applied() const { return applied_; }
  void archive(StateArchive& archive) { archive(waiting_); }

 private:
  /// False while it must wait for a robot's step to end.
  bool ready(const Intervention& intervention, long frame) const;
  void act(const Intervention& intervention);
  std::size_t indexOf(ObjectId robot) const;

  const World& world_;
  PairPhase& pairs_;
  std::vector<RobotPlacer> robots_;
  std::vector<LevelExchanger> exchangers_;  // as robots_
  std::vector<ObjectId> free_bodies_;
  std::vector<Logged> waiting_, applied_;  // waiting_ in the order in which they act
};

}  // namespace murosimf
