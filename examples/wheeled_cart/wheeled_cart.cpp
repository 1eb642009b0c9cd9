// A simulator of one wheeled cart: a world, four properties, one module, ten seconds.

#include <cmath>
#include <cstdio>

#include "murosimf/linking/linker.h"
#include "murosimf/linking/outside_access.h"
#include "murosimf/linking/robot_module.h"

namespace {

using namespace murosimf;

// What a cart is made of: constants, set on its object.
constexpr Constant<double> kWheelRadius{"wheel_radius", "m", "r > 0"};
constexpr Constant<double> kTrack{"track", "m", "b > 0, distance between the wheels"};

// What happens to it: variables, which modules add.
struct WheelRates {
  double left = 0, right = 0;
};
constexpr Variable<WheelRates> kWheelRates{"wheel_rates", "rad/s", "w_l and w_r"};
constexpr Variable<PlanarPose> kCartPose{"cart_pose", "m, rad", "middle between the wheels, and heading"};

/// Wheels that roll without slipping: v = r (w_l + w_r)/2, omega = r (w_r - w_l)/b. Over a step the cart follows an
/// arc, whose chord has the length v dt sin(h)/h, h = omega dt/2, and the mean heading: exact for constant rates.
class DifferentialDrive final : public RobotModule {
 public:
  void declare(Declaration& d) const override {
    d.needs(kWheelRadius);
    d.needs(kTrack);
    d.reads(kWheelRates);
    d.adds(kCartPose);
  }

 private:
  void bind(Links& links) override {
    radius_ = links.values(kWheelRadius);
    track_ = links.values(kTrack);
    rates_ = links.values(kWheelRates);
    pose_ = links.values(kCartPose);
  }
  void stepRobot(const RobotLane& robot, const StepTime& time) const override {
    const WheelRates rates = robot.get(rates_);
    const double speed = robot.get(radius_) * (rates.left + rates.right) / 2;
    const double half_turn = robot.get(radius_) * (rates.right - rates.left) / robot.get(track_) * time.dt / 2;
    PlanarPose pose = robot.get(pose_);
    const double shortening = half_turn == 0 ? 1 : murosimf::sin(half_turn) / half_turn;
    const SinCos<double> mean = murosimf::sincos(pose.heading + half_turn);
    pose.x += speed * time.dt * shortening * mean.cos;
    pose.y += speed * time.dt * shortening * mean.sin;
    pose.heading += 2 * half_turn;
    robot.set(pose_, pose);
  }

  RobotValues<const double> radius_, track_;
  RobotValues<WheelRates> rates_;
  RobotValues<PlanarPose> pose_;
};

}  // namespace

int main() {
  World world;
  const ObjectId cart = world.add(world.root(), "cart");
  world.set(cart, kWheelRadius, 0.05);
  world.set(cart, kTrack, 0.3);

  ModuleRegistry modules;
  modules.add<DifferentialDrive>("differential_drive", "motion", "two wheels that roll without slipping");
  const OutsideAccess driver([](Declaration& d) { d.adds(kWheelRates); });

  Linker linker(world, modules, {.frame_length = 1e-3});
  linker.assign({.assembly = cart, .module = "differential_drive", .parameters = {}, .where = {}});
  linker.attach({"driver", &driver, {cart}});
  Diagnostics diagnostics;
  const std::unique_ptr<LinkedWorld> linked = linker.link(diagnostics);
  if (linked == nullptr) return std::fputs(diagnostics.text().c_str(), stderr), 2;

  linked->handle(cart, kWheelRates).set({8.0, 10.0});
  for (long frame = 0; frame < 10'000; ++frame) linked->runFrame(frame);

  const double speed = 0.05 * 9, turn_rate = 0.05 * 2 / 0.3, radius = speed / turn_rate, t = 10;
  const double x = radius * std::sin(turn_rate * t), y = radius * (1 - std::cos(turn_rate * t));
  const PlanarPose pose = linked->handle(cart, kCartPose).get();
  const double error = std::hypot(pose.x - x, pose.y - y);
  std::printf("after %g s on a circle of %.3f m: (%.6f, %.6f) m, %.4f rad; %.1e m from the formula\n", t, radius,
              pose.x, pose.y, pose.heading, error);
  return error < 1e-9 ? 0 : 1;
}
