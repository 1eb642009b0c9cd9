#pragma once

/// @file What a trotting robot is to do, as a scenario says it.
///
/// "0.4 0 0, 0.3 0 0.5@8, 0 0 0@14.5": from the start 0.4 m/s forward, from 8 s on 0.3 m/s forward and 0.5 rad/s to the
/// left, from 14.5 s on nothing. Three numbers, forward and to the left [m/s] and turning to the left [rad/s], and
/// behind @ the time since the start [s]; the first may stand without one. Before the first time, and without any text,
/// the robot stands. Three zeros: it stands.

#include <string_view>
#include <vector>

#include "trot.h"

namespace murosimf::controllers::trotter {

struct TrotOrder {
  double time = 0;  ///< from which it holds [s]
  TrotCommand command;
};

/// @throws std::invalid_argument what is wrong, in words
std::vector<TrotOrder> readTrotPlan(std::string_view text);

/// The order that holds at a time.
TrotCommand orderAt(const std::vector<TrotOrder>& plan, double time);

}  // namespace murosimf::controllers::trotter
