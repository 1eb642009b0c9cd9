#pragma once

/// @file Which shapes of two robots may touch soon: lists that stay right while the robots hardly move [Verlet 1967].
///
/// Two shapes that were a distance g apart cannot touch before their travels (shape_travel.h) have grown by g together.
/// Those farther apart than kMargin are not listed at all, until the robots' longest travels have grown by kMargin; of
/// robots whose boxes are apart by more than that there is nothing to list until these may meet.
/// What is skipped cannot touch: contacts are the same without these lists, which are no state therefore.
/// Cost     two additions a listed pair of shapes that cannot have met yet; to list two robots' anew, all their shapes.

#include <span>
#include <vector>

#include "murosimf/modules/contact/placed_shapes.h"
#include "murosimf/modules/contact/shape_travel.h"

namespace murosimf {

class NearShapes {
 public:
  /// Shapes i of the one robot and j of the other. They are apart while their travels together are less than `until`.
  struct Pair {
    int i = 0, j = 0;
    double until = 0;
    bool isApart(const ShapeTravel& a, const ShapeTravel& b) const { return a.of(at(i)).now + b.of(at(j)).now < until; }
    /// They have been found a distance apart in this frame, or to touch: 0.
    void note(double apart, const ShapeTravel& a, const ShapeTravel& b) {
      until = a.of(at(i)).before + b.of(at(j)).before + apart - kSlack;
    }

   private:
    static std::size_t at(int shape) { return static_cast<std::size_t>(shape); }
  };
  /// One robot at the frame's start.
  struct Robot {
    const PlacedShapes& placed;
    const ShapeTravel& travel;
  };

  void reserve(std::size_t robots);
  /// Once a frame, before all others.
  void beginFrame();
  /// Takes over the list of two robots from the last frame. Robots must be asked for in ascending order of (a, b).
  /// @return false where there is none that is still right: make one
  bool keep(int a, int b, const ShapeTravel& travel_a, const ShapeTravel& travel_b);
  void list(int a, int b, const Robot& of_a, const Robot& of_b);
  /// Of the two robots that were named last, in the order of i, then j. Valid until the next call.
  std::span<Pair> pairs() { return std::span(now_.pairs).subspan(now_.lists.back().first); }

 private:
  static constexpr double kMargin = 0.02;  // [m]
  static constexpr double kSlack = 1e-7;   // [m]: rounding of travels, which grow
  struct List {
    int a = 0, b = 0;
    double until = 0;
    std::size_t first = 0, count = 0;
  };
  /// What is known of all pairs of robots in one frame, in ascending order.
  struct Lists {
    std::vector<List> lists;
    std::vector<Pair> pairs;
  };
  const List* lastOf(int a, int b);
  void listNear(const Robot& of_a, const Robot& of_b);

  Lists now_, last_;
  std::size_t next_ = 0;  // in last_.lists
};

}  // namespace murosimf
