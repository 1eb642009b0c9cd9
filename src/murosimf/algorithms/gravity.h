#pragma once

namespace murosimf {

/// Free fall's acceleration, along -z of the world [m/s^2].
inline constexpr double kGravity = 9.81;

}  // namespace murosimf
