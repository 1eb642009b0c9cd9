#pragma once

/// @file Random events in time that can be asked for in any order: they have no state.

#include "murosimf/math/random.h"

namespace murosimf {

/// A number of events from a uniform number in [0, 1), by inversion: P(n) = mean^n exp(-mean) / n!. At most 64.
int poissonCount(double uniform, double mean);

/// Whether some outage lasts at time t [s]. Outages begin by a Poisson process of `rate` [1/s], each lasts `length` [s]
/// and they may overlap, so that the share of time without sight is 1 - exp(-rate length).
/// The starts within the window of time [j length, (j + 1) length) are numbers j of the stream.
bool isOutage(const RandomStream& stream, double t, double rate, double length);

}  // namespace murosimf
