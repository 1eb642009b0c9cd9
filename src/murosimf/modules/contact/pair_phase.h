#pragma once

/// @file The pair phase of the frame: contacts of all that can move with one another, and with what stands on the
/// field.
///
/// Joins the world's properties with the free functions of algorithms/pair_solver.h. Each frame it finds, for every
/// free body, the shapes that it may reach (bounding spheres, robots first, then their bodies), and where robots touch
/// robots and posts (robot_pairs.h); gives the straight paths of their bodies over the frame, and lets the solver
/// advance.
///
/// Free bodies   need mass, inertia_factor, ball_radius and one shape (its surface name counts);
///               it adds base_pose, body_velocity and body_rate, and moves them every frame.
/// Robots        it reads body_pose and body_pose_last; shapes that shape_detection.h chooses touch. Whoever takes
///               pair_force recoils (contact_robot.h); the motion of others is prescribed: they push with a capped
///               force. It adds push_force of their touch sensors: the force of what they touch here on the shapes
///               that the sensor feels, mean over the frame.
///               Only robots that are near something, or were in touch, take part in a frame (contact_robots.h).
/// Who touches   all that the world's contact_rules do not forbid, as its surface_table and they say (contact_table.h).
/// Static        objects with fixed_pose and shapes; the ground is the half-space below z = 0, surface "turf". Robots
///               meet the ground by modules of their own.
/// State         contacts kept from frame to frame (PairSolver::kept), motion of bodies that touched and how their
///               robots answer impulses (contact_robot.h).

#include <memory>
#include <vector>

#include "murosimf/algorithms/pair_solver.h"
#include "murosimf/linking/outside_access.h"
#include "murosimf/modules/contact/robot_pairs.h"

namespace murosimf {

class PairPhase {
 public:
  /// What it takes of and gives to free bodies, and to robots: attach these when linking.
  static const OutsideAccess& freeBodyAccess();
  static const OutsideAccess& robotAccess();

  /// Finds everything that can touch. @throws std::invalid_argument naming both surfaces when the table lacks a pair.
  PairPhase(const World& world, LinkedWorld& linked, std::vector<ObjectId> free_bodies, std::vector<ObjectId> robots,
            std::vector<ObjectId> fixed);

  /// Moves the free bodies over this frame. Robots' paths must have been prescribed.
  void advance(long frame, double dt);
  /// Puts a free body somewhere, not turning.
  void placeBody(ObjectId body, const Pose& X_WB, const Vector3& velocity);
  /// Pushes a free body, or a robot's body on a row, over the next frame, with a force at a place in W. Whoever does
  /// not recoil does not feel it. At most kMostPushes a frame; further ones are left out.
  static constexpr std::size_t kMostPushes = 64;
  void push(ObjectId object, int row, const Vector3& p_W, const Vector3& force_W);
  /// A free body and what it touched: a robot, something fixed, or (invalid) the ground.
  struct Touch {
    ObjectId body, partner;
  };
  /// Those of the last frame.
  const std::vector<Touch>& touches() const { return touches_; }
  /// All pairs of the last frame, for those who watch: also those that did not touch.
  const FrameContacts& contacts() const { return frame_; }
  const RobotPairs::Counts& counts() const { return robot_pairs_.counts(); }

  void archive(StateArchive& archive);

 private:
  struct Moving {
    ObjectId object;
    Handle<Pose> pose;
    Handle<Vector3> velocity, rate;
    double mass, inertia, radius;
    std::uint64_t name;
    int kind;
  };
  struct Push {
    ObjectId object;
    int row = 0;
    Vector3 p_W, force_W;
  };
  struct Partner {  // of the frame
    ObjectId object;
    int robot = -1;
  };

  void addAll(const World& world, LinkedWorld& linked, const std::vector<ObjectId>& free_bodies,
              const std::vector<ObjectId>& robots, const std::vector<ObjectId>& fixed);
  void agree();
  void reserve();
  void findPairs(long frame, double dt);
  void addGround(std::size_t body);
  void addBodies(std::size_t body, std::size_t other);
  void addFixed(std::size_t body, double reach);
  void addRobot(std::size_t body, int number, double reach);
  void addPair(std::size_t body, const Obstacle& obstacle, std::uint64_t name, int partner);
  void nameNewPartner(ObjectId object, int robot);
  void pushBodies(double dt);
  void pushRobots();
  void noteTouches();
  void pressSensors(double dt);
  void press(const ContactSide& side, std::uint16_t shape, double force);

  std::unique_ptr<ContactTable> table_;
  int ground_kind_;
  std::vector<Moving> moving_;
  ContactRobots robots_;
  std::vector<FixedObstacle> fixed_;
  RobotPairs robot_pairs_;
  PairSolver solver_;
  FrameContacts frame_;
  std::vector<Partner> partners_;
  std::vector<Touch> touches_;
  std::vector<Push> pushes_;  // of the frame
};

}  // namespace murosimf
