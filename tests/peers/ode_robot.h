#pragma once

/// @file A robot in the Open Dynamics Engine: a world of its own with one body a row of the flattened tree.
///
/// Hinges are driven by torques, kp (position - q) - kd dq within the servo's torque-speed line, less viscous friction.
/// ODE has no rotors: their inertia is given to the body that the joint carries, about the joint's axis; without it the
/// gains would not be stable at 1 ms. Soles are boxes on the plane z = 0, with up to four contacts each; nothing else
/// touches anything. A step is dWorldQuickStep with 20 iterations.

#include <ode/ode.h>

#include <memory>

#include "peers/peer_scene.h"

namespace murosimf::peers {

class OdeRobot {
 public:
  /// @throws std::invalid_argument for a robot with prismatic joints.
  explicit OdeRobot(const PeerScene& scene);
  OdeRobot(const OdeRobot&) = delete;
  OdeRobot& operator=(const OdeRobot&) = delete;
  ~OdeRobot();

  /// Puts the robot there, at rest.
  void place(const Pose& X_WB, const std::vector<double>& q);
  void command(const std::vector<double>& positions) { wanted_ = positions; }
  void step();
  void read(PeerSensors& sensors) const;
  double height() const;  ///< of the base's origin
  int contacts() const { return contacts_; }

 private:
  struct Hinge {
    dJointID id = nullptr;
    ServoParameters servo;
    double damping = 0;
  };
  struct BodyOnRow {
    dBodyID id = nullptr;  ///< with its origin at the centre of mass
    Vector3 p_RC;
  };
  void addBody(std::size_t row);
  void addHinge(std::size_t row, const std::vector<Pose>& X_WR);
  void addSoles();
  std::vector<Pose> rowPoses(const Pose& X_WB, const std::vector<double>& q) const;
  void placeBodies(const std::vector<Pose>& X_WR);
  void drive();
  void collide();
  Pose rowPose(std::size_t row) const;
  Vector3 imuVelocity() const;

  PeerScene scene_;
  dWorldID world_;
  dSpaceID space_;
  dGeomID ground_;
  dJointGroupID contact_group_;
  std::vector<BodyOnRow> bodies_;
  std::vector<Hinge> hinges_;
  std::vector<dGeomID> soles_;
  std::vector<double> wanted_;
  RowPlace imu_;
  Vector3 imu_velocity_last_;
  int contacts_ = 0;
};

}  // namespace murosimf::peers
