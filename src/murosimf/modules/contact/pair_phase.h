#pragma once

/// @file The pair phase of the frame: free bodies (the ball) advance against ground, posts and robots.
///
/// Joins the world's properties with the free functions of algorithms/pair_solver.h. Each frame it finds, for every
/// free body, the shapes that it may reach (bounding spheres, robots first, then their bodies), gives their straight
/// paths over the frame, and lets the solver advance.
///
/// Free bodies   need mass, inertia_factor, ball_radius and one shape (its surface name counts);
///               it adds base_pose, body_velocity and body_rate, and moves them every frame.
/// Robots        it reads body_pose and body_pose_last; shapes with `collides` touch. Their motion is prescribed: they
///               push with a capped force and do not recoil. It adds push_force of their touch sensors: the force of
///               free bodies on the shapes that the sensor feels, mean over the frame.
/// Static        objects with fixed_pose and shapes; the ground is the half-space below z = 0, surface "turf".
/// State         contacts kept from frame to frame (PairSolver::kept).

#include <vector>

#include "murosimf/algorithms/pair_solver.h"
#include "murosimf/linking/body_path.h"
#include "murosimf/linking/outside_access.h"
#include "murosimf/math/state_archive.h"

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
  /// A free body and what it touched: a robot, something fixed, or (invalid) the ground.
  struct Touch {
    ObjectId body, partner;
  };
  /// Those of the last frame.
  const std::vector<Touch>& touches() const { return touches_; }

  void archive(StateArchive& archive);

 private:
  struct Moving {
    ObjectId object;
    Handle<Pose> pose;
    Handle<Vector3> velocity, rate;
    double mass, inertia, radius;
    std::uint64_t name;
    std::string surface;
  };
  struct Obstacle {  // one shape of a robot's body or of something fixed
    ObjectId object;
    int row;
    Pose X_PS;
    Shape shape;
    double reach;  // bounding radius [m]
    std::uint64_t name;
    std::uint16_t number;
    int touch_sensor;                  // of the robot; -1: none feels it
    std::vector<SurfacePair> surface;  // per free body
  };
  struct Robot {
    ObjectId object;
    BodyPath path;
    double mass = 0, reach = 0;  // [kg]; from its base [m]
    std::vector<Obstacle> shapes;
    Handle<double> push;  // of its touch sensors
  };
  struct Partner {  // of the frame
    ObjectId object;
    int robot = -1, touch_sensor = -1;
  };

  std::vector<Obstacle> obstaclesOf(const World& world, ObjectId object) const;
  std::vector<SurfacePair> surfacesWith(const World& world, const std::string& surface) const;
  static double reachOf(const World& world, const Robot& robot);
  void reserve();
  void addGround(std::size_t body);
  void addBodies(std::size_t body, std::size_t other);
  void addFixed(std::size_t body, double reach);
  void addRobot(std::size_t body, int number, double reach, long frame);
  void addPair(std::size_t body, const Obstacle& obstacle, int robot);
  void pressSensors(double dt);

  std::vector<Moving> moving_;
  std::vector<Robot> robots_;
  std::vector<Obstacle> fixed_;
  std::vector<Pose> fixed_poses_;
  std::vector<SurfacePair> ground_;   // per free body
  std::vector<SurfacePair> between_;  // of free bodies: (1, 0), (2, 0), (2, 1), (3, 0) ...
  PairSolver solver_;
  FrameContacts frame_;
  std::vector<Partner> partners_;
  std::vector<Touch> touches_;
};

}  // namespace murosimf
