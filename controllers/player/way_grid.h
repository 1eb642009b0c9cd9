#pragma once

/// @file The best way along a course, around what stands there: cheapest costs from every cell of a grid to the finish
/// [Dijkstra 1959].
///
/// Frame C of the course: x from the start line to the finish line, y to the left. A cell costs its length times 1 plus
/// what the nearest obstacle, the strip's edge and walls add. Costs are high, never infinite: a robot that stands where
/// it should not finds its way out.

#include <span>
#include <vector>

#include "murosimf/control/client/robot_description.h"
#include "plane.h"

namespace murosimf::controllers {

/// A line across the course that is not to be crossed: at x, from y towards +y or -y to the edge.
struct CourseWall {
  Point from;
  bool to_left = false;
};

class WayGrid {
 public:
  /// Reserves all memory.
  void start(const client::CourseDescription& course);
  /// Finds the cheapest ways. Obstacles' middles and walls in C.
  void plan(std::span<const Point> obstacles_C, std::span<const CourseWall> walls);
  /// The point that lies this far along the way from p_C.
  Point ahead(const Point& p_C, double distance) const;

 private:
  static constexpr double kCell = 0.05;  ///< [m]
  struct Entry {
    double cost = 0;
    int cell = 0;
  };
  /// The order of a heap with the cheapest on top.
  static bool costsMore(const Entry& a, const Entry& b) { return a.cost > b.cost; }
  double costAt(const Point& p_C, std::span<const Point> obstacles_C, std::span<const CourseWall> walls) const;
  Point centre(int cell) const;
  int cellOf(const Point& p_C) const;
  template <class Visit>
  void forNeighbours(int cell, const Visit& visit) const;
  void relax(int cell);
  double stepCost(int from, int to, double length) const;
  int next(int cell) const;

  client::CourseDescription course_;
  Point corner_;  ///< lower left of the grid, in C
  int columns_ = 0, rows_ = 0;
  std::vector<double> cell_cost_, way_cost_;
  std::vector<Entry> heap_;
};

}  // namespace murosimf::controllers
