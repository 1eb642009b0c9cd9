#pragma once

/// @file A trot with open-loop paths of the hooves: joint angles as a function of one phase and a wanted velocity.
///
/// The legs of a diagonal swing together, the diagonals in turn. A hoof that stands rides on the ground that moves
/// under the trunk: it follows exp(-xi tau), xi = (vx, vy, omega), exactly, so standing hooves agree and a robot that
/// does not slip moves by what was commanded. A swinging one returns along a cycloid laid on the moving ground: it
/// leaves and meets the ground with the ground's speed. Phase phi in [0, 1) is one cycle of two steps: diagonal 0
/// swings from phi = 0, diagonal 1 from 1/2.
///     tau(u) = T (S + sigma u - (2 S + sigma) (u - sin(2 pi u) / (2 pi))),   zeta(u) = sin(pi u)^2
/// T period, sigma swing share of the cycle, S half of what is left of it, u in [0, 1) way through the swing, tau time
/// relative to mid stance [s], zeta height over the largest one.

#include "murosimf/math/vec3.h"
#include "rappe.h"

namespace murosimf::controllers::trotter {

/// Velocity of the trunk over the ground, in its own axes.
struct TrotCommand {
  double vx = 0, vy = 0;  ///< forward, to the left [m/s]
  double omega = 0;       ///< to the left [rad/s]
  friend bool operator==(const TrotCommand&, const TrotCommand&) = default;
};

struct TrotParameters {
  double period = 0.44;         ///< T, two steps [s]
  double double_support = 0.1;  ///< share of the cycle with all hooves down
  double hip_height = 0.30;     ///< hips above the centres of standing hooves [m]
  double lift = 0.05;           ///< [m]
  double tilt_gain = 0.2;       ///< hooves are wanted on a plane that leans against the trunk's tilt [1] ...
  double rate_gain = 0.01;      ///< ... and against its angular velocity [s]
  double heading_gain = 1.5;    ///< turns back to the heading that the commands add up to [1/s]
  double start_time = 0.9;      ///< trotting on the spot first [s]
  TrotCommand lowest{-0.3, -0.25, -1.2}, highest{0.6, 0.25, 1.2};
  TrotCommand largest_change{0.4, 0.3, 1.5};  ///< per second
};

/// How the trunk leans, and what it feels of its turning.
struct TrunkMotion {
  double roll = 0, pitch = 0;            ///< [rad]
  double roll_rate = 0, pitch_rate = 0;  ///< [rad/s]
};

/// Where one leg is in its cycle.
struct LegCycle {
  double tau = 0;   ///< time of travel with the ground, 0 in mid stance [s]
  double zeta = 0;  ///< lift over the largest lift
};
LegCycle legCycle(const TrotParameters& trot, double phase, std::size_t leg);

/// Joint angles of the trot [rad]. amplitude in [0, 1] scales the lift.
JointAngles trotPose(const TrotParameters& trot, double phase, double amplitude, const TrotCommand& velocity,
                     const TrunkMotion& trunk);

}  // namespace murosimf::controllers::trotter
