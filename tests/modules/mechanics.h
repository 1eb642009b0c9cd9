#pragma once

/// @file Momentum and energy of a robot, straight from its state: what free flight conserves.

#include <vector>

#include "murosimf/algorithms/gravity.h"
#include "murosimf/algorithms/tree_motion.h"
#include "murosimf/linking/linked_world.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf::motion {

struct Mechanics {
  double mass = 0;
  Vector3 centre;           ///< of mass, in the world
  Vector3 linear, angular;  ///< momentum; angular: about the centre of mass; world axes
  double kinetic = 0;       ///< of bodies and rotors [J]
  double energy() const { return kinetic + mass * kGravity * centre.z; }
};

/// How the bodies of a robot move: poses in the world, and velocities in their own axes.
struct BodyMotions {
  std::vector<Pose> X;
  std::vector<SpatialMotion<double>> V;
  std::vector<double> rate;  ///< of joints
};

inline BodyMotions bodyMotions(const World& world, LinkedWorld& linked, ObjectId robot) {
  const std::vector<KernelRow> rows = kernelRows(*world.findShared(robot, kTree));
  const auto q = linked.handle(robot, kJointPosition, subset::kJoints);
  const auto dq = linked.handle(robot, kJointVelocity, subset::kJoints);
  BodyMotions m{{linked.handle(robot, kBasePose).get()}, std::vector<SpatialMotion<double>>(rows.size()), {}};
  std::vector<SinCos<double>> turn;
  std::vector<double> height(rows.size());
  std::vector<Vector3> up(rows.size());
  for (std::size_t r = 1; r < rows.size(); ++r) {
    const int j = static_cast<int>(r) - 1;
    m.X.push_back(childPose(m.X[static_cast<std::size_t>(rows[r].parent)], rows[r], q.get(j)));
    turn.push_back(jointTurn(rows[r], q.get(j))), m.rate.push_back(dq.get(j));
  }
  m.V[0] = linked.handle(robot, kBaseVelocity).get();
  treeMotion(rows.data(), static_cast<int>(rows.size()),
             TreeMotion<double>{turn.data(), m.rate.data(), m.V.data(), up.data(), height.data()});
  return m;
}

inline Mechanics mechanicsOf(const World& world, LinkedWorld& linked, ObjectId robot) {
  const BodyMotions motion = bodyMotions(world, linked, robot);
  const auto bodies = world.members(robot, subset::kBodies), joints = world.members(robot, subset::kJoints);
  Mechanics m;
  Vector3 about_origin, first;
  for (std::size_t r = 0; r < bodies.size(); ++r) {
    const RigidInertia<double> inertia = *world.find(bodies[r], kBodyInertia);
    const SpatialForce<double> body = inertia * motion.V[r];
    const Vector3 f = motion.X[r].rotation * body.f, p = motion.X[r].translation;
    m.mass += inertia.m, m.linear += f;
    m.kinetic += 0.5 * dot(motion.V[r], body);
    first += motion.X[r].rotation * inertia.mc + p * inertia.m;
    about_origin += motion.X[r].rotation * body.n + cross(p, f);
  }
  for (std::size_t j = 0; j < joints.size(); ++j) {
    m.kinetic += 0.5 * world.find(joints[j], kArmature).value_or(0) * motion.rate[j] * motion.rate[j];
  }
  m.centre = first * (1 / m.mass);
  m.angular = about_origin - cross(m.centre, m.linear);
  return m;
}

}  // namespace murosimf::motion
