#pragma once

/// @file The line points of one look, prepared for comparison with the map.

#include <array>
#include <span>

#include "percepts.h"
#include "plane.h"

namespace murosimf::controllers {

class LineSights {
 public:
  struct Sight {
    Point p_R;
    double distance = 0;      ///< from the robot [m]
    SinCos<double> normal{};  ///< of the direction across the line, in R
    double variance = 0;      ///< of the offset from the line [m^2]
  };

  /// Takes at most kCapacity of the points, evenly thinned out; leaves out what is no number or off any field.
  explicit LineSights(const std::vector<LinePercept>& percepts);

  std::span<const Sight> sights() const { return std::span(sights_).first(count_); }
  /// By how much the points are too many to be independent: their variances are multiplied by it already.
  double dependence() const { return dependence_; }
  /// Whether the lines seen run one way, or at right angles to it; and which way, in R [rad], modulo pi/2.
  bool haveDirection() const { return has_direction_; }
  double direction() const { return direction_; }

 private:
  static constexpr std::size_t kCapacity = 12;
  void findDirection();

  std::array<Sight, kCapacity> sights_;
  std::size_t count_ = 0;
  double dependence_ = 1, direction_ = 0;
  bool has_direction_ = false;
};

}  // namespace murosimf::controllers
