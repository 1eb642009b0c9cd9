#pragma once

/// @file What stands and is painted on the field, in the team's own frame F (+x: towards the goal attacked).

#include <array>
#include <span>

#include "murosimf/control/client/robot_description.h"
#include "percepts.h"
#include "plane.h"

namespace murosimf::controllers {

enum class LandmarkKind : std::uint8_t { kPost, kPole };

/// The white line that a seen line point may belong to.
struct LineMatch {
  bool found = false;
  double offset = 0;  ///< of the point from the line, along `normal` [m]
  Point normal;       ///< unit vector across the line, in F
};

/// Landmarks and lines, computed once from the measures of the field.
///
/// Goal posts stand on the goal lines, their inner faces goal_width apart; landmark poles at the ends of the halfway
/// line. On the field as it is painted (before a team turns it) the pole at +y is yellow on top, that at -y blue.
class FieldMap {
 public:
  void start(const client::RobotDescription& robot);

  /// Everything that looks alike: two posts of a goal, or one pole.
  std::span<const Point> landmarks(LandmarkKind kind, LandmarkColour colour) const;
  /// The line nearest to p_F whose normal agrees with the unit vector `normal` (either sign) within 35 degrees.
  LineMatch nearestLine(const Point& p_F, const Point& normal) const;
  /// Is p_F on the field or not more than `margin` beyond its outer lines?
  bool contains(const Point& p_F, double margin) const;
  /// The nearest point of the carpet: field and border.
  Point nearestOnCarpet(const Point& p_F) const;
  /// Centre of the half that the team defends, looking at the goal attacked.
  PlanarPose middleOfOwnHalf() const { return {-0.5 * half_length_, 0, 0}; }

 private:
  /// A straight line along x or y: at `offset` along the normal, from `first` to `last` along the other axis.
  struct Line {
    bool along_x = false;
    double offset = 0, first = 0, last = 0;
  };
  void addLine(bool along_x, double offset, double first, double last);
  /// Before the goal at -x or +x, as `side` says.
  void addArea(double side, double length, double width);
  void matchCircle(const Point& p_F, const Point& normal, LineMatch& best) const;

  double half_length_ = 0, half_width_ = 0, border_ = 0, circle_radius_ = 0;
  std::array<std::array<Point, 2>, 2> posts_{};  ///< by colour: yellow, blue
  std::array<Point, 2> poles_{};                 ///< by colour
  bool has_poles_ = false;
  std::array<Line, 17> lines_{};
  std::size_t line_count_ = 0;
};

}  // namespace murosimf::controllers
