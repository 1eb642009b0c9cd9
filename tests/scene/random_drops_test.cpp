// Robots that are thrown about and put into one another at random: nothing explodes.

#include <random>

#include "scene/touching_robots.h"

namespace murosimf::test {
namespace {

class Throws {
 public:
  Throws() : robots_({"multibody_dynamics", "simplified_dynamics", "multibody_dynamics", "kinematic_walking"}) {}

  /// Speed that anybody reaches at most after a drop from some height, with some speed and spin.
  double drop() {
    const std::size_t i = index(3);
    const double height = 0.3 + 0.9 * (number() + 1) / 2;
    robots_.put(i, {rotationExp(Vector3{3 * number(), 3 * number(), 3 * number()}), somewhere(height)},
                Vector3{number(), number(), number()} * 1.5);
    return run(600);
  }
  /// The same after one was put into another, both standing.
  double teleport() {
    const std::size_t i = index(4), other = (i + 1 + index(3)) % 4;
    const Vector3 p = robots_.base(other).get().translation;
    robots_.place(i, {p.x + 0.1 * number(), p.y + 0.1 * number(), kPi * number()});
    return run(400);
  }
  Robots& robots() { return robots_; }

 private:
  double number() { return std::uniform_real_distribution<double>(-1, 1)(random_); }
  std::size_t index(std::size_t below) { return std::uniform_int_distribution<std::size_t>(0, below - 1)(random_); }
  Vector3 somewhere(double height) {
    const Vector3 p = robots_.base(index(4)).get().translation;
    return {p.x + 0.15 * number(), p.y + 0.15 * number(), height};
  }
  double run(int frames) {
    double fastest = 0;
    for (int i = 0; i < frames; ++i) {
      robots_.simulation().step();
      if (i > 1) fastest = std::max(fastest, robots_.fastest());  // the first frames still show the place before
    }
    return fastest;
  }
  Robots robots_;
  std::mt19937 random_{7};
};

TEST(RandomDrops, AndTeleportsNeverExplode) {
  Throws throws;
  // From 1.2 m with 2.6 m/s a body comes down with 5.5 m/s; a base is turned about by what hits the ground first.
  for (int k = 0; k < 100; ++k) {
    EXPECT_LT(throws.drop(), 8) << "drop " << k;
    EXPECT_LT(throws.teleport(), 8) << "teleport " << k;
    EXPECT_TRUE(throws.robots().simulation().guard().faults().empty()) << k;
  }
}

}  // namespace
}  // namespace murosimf::test
