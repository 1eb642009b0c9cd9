// Robots that stand on a field, two and two beside one another, in the product's whole frame: what a robot costs among
// a thousand on a field as much larger.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "paired_ratio.h"
#include "simulated_robots.h"

namespace murosimf::bench {
namespace {

constexpr int kRounds = 75;
constexpr double kLength = 9, kWidth = 6;  // of the field of 22 [m]
constexpr double kBeside = 0.25;           // [m] from one robot of a couple to the other
constexpr double kStanding = 0.2;          // [m] height of the base that nobody who stands is below

/// A field for so many robots, as many a square metre as 22 have.
class Field {
 public:
  Field(int robots, int lanes) : scale_(std::sqrt(robots / 22.0)), robots_(head(), places(robots), lanes) {
    robots_.settle(0.5);
  }
  void frame() { robots_.frame(); }
  double robots() const { return static_cast<double>(robots_.count()); }
  /// Pairs of shapes that may touch soon, per robot.
  double near() { return static_cast<double>(robots_.simulation().pairs().counts().listed) / robots(); }
  void require() const {
    robots_.requireNumbers();
    if (robots_.lowestBase() < kStanding)
      throw std::runtime_error(
          fmt::format("field_1000_over_22: a robot has fallen, its base is {:.3f} m high", robots_.lowestBase()));
  }

 private:
  std::string head() const {
    return fmt::format("[field]\npreset = \"2025_kid\"\nlength = {}\nwidth = {}\n", kLength * scale_, kWidth * scale_);
  }
  /// Couples in rows and columns about the centre; an even number of rows, so that none stands before a goal.
  std::vector<PlanarPose> places(int robots) const {
    const double couples = robots / 2.0;
    const int rows = 2 * static_cast<int>(std::lround(std::sqrt(couples * kWidth / kLength) / 2));
    const int columns = static_cast<int>(std::ceil(couples / rows));
    std::vector<PlanarPose> poses;
    for (int i = 0; i < robots; ++i) {
      const int couple = i / 2, column = couple % columns, row = couple / columns;
      const double side = i % 2 == 0 ? -0.5 : 0.5;
      poses.push_back({((column + 0.5) / columns - 0.5) * kLength * scale_,
                       ((row + 0.5) / rows - 0.5) * kWidth * scale_ + side * kBeside, 0});
    }
    return poses;
  }

  double scale_;
  SimulatedRobots robots_;
};

Row thousand(int lanes) {
  Field many(1000, lanes), few(22, lanes);
  // Ours over peer, for once: `few` stands in the place of what is measured.
  const Comparison c = compareFrames(
                           {[&] { few.frame(); }}, [&] { many.frame(); }, kRounds)
                           .front();
  for (Field* field : {&many, &few}) field->require();
  Row row{"field_1000_over_22",
          c.ratio * few.robots() / many.robots(),
          c.peer * 1e9 / many.robots(),
          c.ours * 1e9 / few.robots(),
          "ns/robot-frame",
          isaOf(lanes),
          ""};
  row.text = fmt::format(
      "{:28} {:7} {:6.2f} times the cost of a robot among 22 ({:.0f} ns, {:.0f} ns a robot-frame); {:.2f} and {:.2f} "
      "pairs of shapes a robot are near each other",
      row.name, row.isa, row.ratio, row.ours, row.peer, many.near(), few.near());
  return row;
}

}  // namespace

std::vector<Part> fieldParts() {
  std::vector<Part> parts;
  for (const int lanes : laneWidths()) parts.emplace_back([lanes] { return std::vector<Row>{thousand(lanes)}; });
  return parts;
}

}  // namespace murosimf::bench
