#pragma once

/// @file Momentum of a robot from its state, body by body in the world: the second opinion on dynamics.

#include "modules/motion_world.h"
#include "murosimf/algorithms/tree_motion.h"

namespace murosimf::motion {

/// Centre of mass, linear momentum, and angular momentum about it, in the world.
struct Momentum {
  double mass = 0, kinetic_energy = 0;
  Vector3 centre, linear, angular;
};

inline Momentum momentumOf(const World& world, LinkedWorld& linked, ObjectId robot) {
  const std::vector<KernelRow> rows = kernelRows(*world.findShared(robot, kTree));
  const auto q = linked.handle(robot, kJointPosition, subset::kJoints);
  const auto dq = linked.handle(robot, kJointVelocity, subset::kJoints);
  std::vector<Pose> X{linked.handle(robot, kBasePose).get()};
  std::vector<SinCos<double>> turn;
  std::vector<double> rate, height(rows.size());
  std::vector<SpatialMotion<double>> V(rows.size());
  std::vector<Vector3> up(rows.size());
  for (std::size_t r = 1; r < rows.size(); ++r) {
    const int j = static_cast<int>(r) - 1;
    X.push_back(childPose(X[static_cast<std::size_t>(rows[r].parent)], rows[r], q.get(j)));
    turn.push_back(jointTurn(rows[r], q.get(j))), rate.push_back(dq.get(j));
  }
  V[0] = linked.handle(robot, kBaseVelocity).get();
  treeMotion(rows.data(), static_cast<int>(rows.size()),
             TreeMotion<double>{turn.data(), rate.data(), V.data(), up.data(), height.data()});
  Momentum m;
  const auto bodies = world.members(robot, subset::kBodies);
  Vector3 about_origin, first;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const RigidInertia<double> inertia = *world.find(bodies[r], kBodyInertia);
    const SpatialForce<double> body = inertia * V[r];
    const Vector3 f = X[r].rotation * body.f;
    m.mass += inertia.m, m.linear += f, m.kinetic_energy += 0.5 * dot(V[r], body);
    first += X[r].rotation * inertia.mc + X[r].translation * inertia.m;
    about_origin += X[r].rotation * body.n + cross(X[r].translation, f);
  }
  m.centre = first * (1 / m.mass);
  m.angular = about_origin - cross(m.centre, m.linear);
  return m;
}

}  // namespace murosimf::motion
