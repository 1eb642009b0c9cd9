#pragma once

/// @file What is counted of a heap of robots, alike in every simulator.

#include <set>
#include <utility>

#include "peers/peer_scene.h"

namespace murosimf::peers {

/// How a heap lies at one moment.
struct HeapRest {
  int points = 0;                                 ///< of contact
  std::set<std::pair<PeerBody, PeerBody>> pairs;  ///< of bodies that touch, the smaller one first
  double deepest = 0;                             ///< overlap of two shapes [m]
  double kinetic_energy = 0;                      ///< of all robots [J]

  /// One more point of contact.
  void add(const PeerBody& a, const PeerBody& b, double depth);
};

/// Adds the points of a robot's shapes that are below the ground z = 0, up to four a shape.
void addGroundContacts(const RobotBlueprint& print, int robot, const PeerState& state, HeapRest& rest);

/// Of all bodies and rotors [J]:  1/2 sum V^T I V + 1/2 sum armature dq^2.
double kineticEnergy(const RobotBlueprint& print, const PeerState& state);

}  // namespace murosimf::peers
