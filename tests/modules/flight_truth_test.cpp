// What free flight keeps: momentum while servos move limbs, energy less what servos give and friction takes, Euler's
// equations of a body that turns about no principal axis.

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "book/page.h"
#include "modules/dynamic_world.h"
#include "modules/test_rig.h"

namespace murosimf::motion {
namespace {

constexpr int kZ = 2;

TEST(FlightTruth, FlywheelTurnsItsBaseBackByTheRatioOfInertiasWhateverItsSpeed) {
  book::Page page({book::Chapter::kFlight,
                   "A flywheel turns its base back by the ratio of inertias",
                   R"(\psi = -\frac{I_r}{I_b + I_r} q)",
                   "Angular momentum is kept; servo, friction and method do not matter",
                   {{"\\psi", "heading of the base", "rad"},
                    {"I_b, I_r", "inertia of base and rotor, here 0.05 and 0.02", "kg m^2"}},
                   {"angle of the rotor $q$", "rad"},
                   {"heading $\\psi$", "rad"}});
  constexpr double kBase = 0.05, kRotor = 0.02;  // [kg m^2]
  for (const char* integrator : {"implicit_euler", "midpoint", "runge_kutta_4", "dormand_prince"}) {
    TestRig rig(rigidBody(2, {0.1, 0.1, kBase}));
    rig.joint(0, JointKind::kRevolute, kZ, {0, 0, 0.1}, rigidBody(1, {0.02, 0.02, kRotor}));
    rig.with(0, kServoStiffness, 3).with(0, kServoDamping, 0.2).with(0, kStallTorque, 1).with(0, kLargestVelocity, 9);
    rig.with(0, kLowerLimit, -2).with(0, kUpperLimit, 2).use({"servo_controller", "position_servo"});
    rig.link(integrator, 1e-3);
    rig.command(0, {kPi / 2, 0, 0, 1, 0});
    for (int i = 0; i < 20; ++i) {
      rig.run(0.1);
      const Pose X = rig.get(kBasePose);
      page.series(integrator).curve(0, 2, [](double q) { return -kRotor / (kBase + kRotor) * q; });
      EXPECT_TRUE(page.near(rig.q(0), headingOf(X), -kRotor / (kBase + kRotor) * rig.q(0), 1e-12));
    }
    EXPECT_NEAR(rig.q(0), kPi / 2, 1e-5) << integrator;
  }
}

/// KS21 in the air, with servos and viscous friction; no ground.
struct FlyingServos {
  DynamicWorld world;
  ObjectId robot;

  explicit FlyingServos(double step, const std::vector<double>& start) : world(step) {
    robot = world.add("robot", ks21(), start);
    world.link({{"servo_controller", "position_servo", "tree_motion", "multibody_dynamics", "runge_kutta_4"}});
    world.linked().handle(robot, kBasePose).set({rotationExp(Vector3{0.3, -0.2, 0.5}), {0, 0, 3}});
    world.linked().handle(robot, kBaseVelocity).set({{0.5, -1.0, 0.7}, {0.2, 0.3, 0.1}});
  }
  Mechanics mechanics() { return mechanicsOf(world.world(), world.linked(), robot); }
};

TEST(FlightTruth, RaisingArmsMovesNeitherTheCentreOfMassNorTheAngularMomentum) {
  const std::vector<double> start = gait(0, {}, 0);
  std::vector<double> target = start;
  for (double& q : target) q += 0.2;
  FlyingServos flight(1e-4, start);
  flight.world.command(flight.robot, target);
  const Mechanics before = flight.mechanics();
  constexpr double kTime = 0.3;
  flight.world.run(kTime);
  const Mechanics after = flight.mechanics();
  const Vector3 expected =
      before.centre + before.linear * (kTime / before.mass) + Vector3{0, 0, -0.5 * kGravity * kTime * kTime};
  EXPECT_LT(norm(after.centre - expected), 1e-11);
  EXPECT_LT(norm(after.angular - before.angular), 1e-10 * norm(before.angular));
  double moved = 0;
  for (int j = 0; j < 21; ++j) {
    const double q = flight.world.get(flight.robot, kJointPosition, subset::kJoints, j);
    moved = std::max(moved, std::fabs(q - start[static_cast<std::size_t>(j)]));
  }
  EXPECT_GT(moved, 0.1) << "the limbs were to move";
}

/// Power of the servos and of viscous friction in the state of the moment [W].
struct Power {
  double servos = 0, friction = 0;
};
Power powerOf(FlyingServos& flight) {
  Power power;
  const auto joints = flight.world.world().members(flight.robot, subset::kJoints);
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const int j = static_cast<int>(i);
    const double q = flight.world.get(flight.robot, kJointPosition, subset::kJoints, j);
    const double dq = flight.world.get(flight.robot, kJointVelocity, subset::kJoints, j);
    const ServoCommand demand = flight.world.get(flight.robot, kServoDemand, subset::kJoints, j);
    power.servos += (demand.kp * (demand.position - q) - demand.kd * dq) * dq;
    power.friction += *flight.world.world().find(joints[i], kJointDamping) * dq * dq;
  }
  return power;
}

TEST(FlightTruth, WorkOfTheServosIsEnergyGainedAndFrictionLost) {
  const std::vector<double> start = gait(0, {}, 0);
  std::vector<double> target = start;
  for (double& q : target) q += 0.05;  // small enough for no motor to reach its limit
  constexpr double kStep = 1e-4;
  constexpr int kSteps = 2000;
  FlyingServos flight(kStep, start);
  flight.world.command(flight.robot, target);
  flight.world.step();  // the demand is there
  const double before = flight.mechanics().energy();
  double work = 0, loss = 0, turnover = 0;
  for (int i = 0; i <= kSteps; ++i) {
    const Power power = powerOf(flight);
    const double weight = (i == 0 || i == kSteps ? 1 : i % 2 == 1 ? 4 : 2) * kStep / 3;  // Simpson's rule
    work += weight * power.servos, loss += weight * power.friction, turnover += weight * std::fabs(power.servos);
    if (i < kSteps) flight.world.step();
  }
  const double gained = flight.mechanics().energy() - before;
  EXPECT_NEAR(work, gained + loss, 1e-8 * turnover);
  EXPECT_GT(turnover, 0.05);
  EXPECT_GT(loss, 1e-4);
}

/// sn, cn, dn of modulus k by the arithmetic-geometric mean [Abramowitz & Stegun 1964, 16.4].
std::array<double, 3> jacobi(double u, double k) {
  std::vector<double> a{1}, c{k};
  for (double b = std::sqrt(1 - k * k); c.back() > 1e-17;) {
    const double next = 0.5 * (a.back() + b);
    c.push_back(0.5 * (a.back() - b));
    b = std::sqrt(a.back() * b);
    a.push_back(next);
  }
  double phi = std::ldexp(a.back() * u, static_cast<int>(a.size()) - 1);
  for (std::size_t i = a.size() - 1; i > 0; --i) phi = 0.5 * (phi + std::asin(c[i] / a[i] * std::sin(phi)));
  return {std::sin(phi), std::cos(phi), std::sqrt(1 - k * k * std::sin(phi) * std::sin(phi))};
}

constexpr double kI1 = 0.01, kI2 = 0.02, kI3 = 0.03;  // [kg m^2]
const Vector3 kSpin{0.1, 10, 0.1};                    // [rad/s]: all but about the middle axis, which is not stable

/// Angular velocity at t in the body's axes [Landau & Lifshitz 1976, 37], for |L|^2 > 2 T I2.
Vector3 freeTop(double t) {
  const double twice_energy = kI1 * kSpin.x * kSpin.x + kI2 * kSpin.y * kSpin.y + kI3 * kSpin.z * kSpin.z;
  const double L2 = std::pow(kI1 * kSpin.x, 2) + std::pow(kI2 * kSpin.y, 2) + std::pow(kI3 * kSpin.z, 2);
  const double low = L2 - twice_energy * kI1, high = twice_energy * kI3 - L2;
  const double k = std::sqrt((kI2 - kI1) * high / ((kI3 - kI2) * low));
  const double rate = std::sqrt((kI3 - kI2) * low / (kI1 * kI2 * kI3));
  const double amplitude2 = std::sqrt(high / (kI2 * (kI3 - kI2)));
  const double start = std::ellint_1(k, std::asin(kSpin.y / amplitude2));
  const auto [sn, cn, dn] = jacobi(start + rate * t, k);
  return {std::sqrt(high / (kI1 * (kI3 - kI1))) * cn, amplitude2 * sn, std::sqrt(low / (kI3 * (kI3 - kI1))) * dn};
}

struct FreeTop {
  TestRig rig{rigidBody(1, {kI1, kI2, kI3})};
  FreeTop(const Method& method, double step) {
    rig.link(method, step);
    rig.set(Pose{}, {kSpin, {0, 0, 0}});
  }
  Vector3 w() { return rig.get(kBaseVelocity).w; }
  /// World axes.
  Vector3 momentum() { return rig.mechanics().angular; }
  double kinetic() {
    const Vector3 v = w();
    return 0.5 * (kI1 * v.x * v.x + kI2 * v.y * v.y + kI3 * v.z * v.z);
  }
};

TEST(FlightTruth, FreeTopTumblesAsJacobisEllipticFunctions) {
  book::Page page(
      {book::Chapter::kFlight,
       "A free top tumbles as Jacobi's elliptic functions say",
       "\\omega_1 = a_1 \\mathrm{cn}(u), \\quad \\omega_2 = a_2 \\mathrm{sn}(u), \\quad \\omega_3 = a_3 "
       "\\mathrm{dn}(u), \\quad u = u_0 + \\lambda t",
       "[Landau & Lifshitz 1976, 37]; functions [Abramowitz & Stegun 1964, 16.4]",
       {{"\\omega_i", "angular velocity in the body's axes, 10 rad/s about the middle one at first", "rad/s"},
        {"a_i, \\lambda, u_0", "from energy, momentum and the moments of inertia 0.01, 0.02, 0.03 kg m^2", ""}},
       {"time $t$", "s"},
       {"angular velocity $\\omega_i$", "rad/s"}});
  page.series("$\\omega_1$").curve(0, 5, [](double t) { return freeTop(t).x; });
  page.series("$\\omega_2$").curve(0, 5, [](double t) { return freeTop(t).y; });
  page.series("$\\omega_3$").curve(0, 5, [](double t) { return freeTop(t).z; });
  FreeTop top({"dormand_prince", {{"tolerance", 1e-13}}}, 0.05);
  EXPECT_LT(norm(freeTop(0) - kSpin), 1e-12) << "the closed form is to begin where the body does";
  for (int i = 1; i <= 25; ++i) {
    top.rig.run(0.2);
    const Vector3 expected = freeTop(0.2 * i), found = top.w();
    EXPECT_TRUE(page.series("$\\omega_1$").near(0.2 * i, found.x, expected.x, 1e-8));
    EXPECT_TRUE(page.series("$\\omega_2$").near(0.2 * i, found.y, expected.y, 1e-8));
    EXPECT_TRUE(page.series("$\\omega_3$").near(0.2 * i, found.z, expected.z, 1e-8));
  }
}

TEST(FlightTruth, FreeTopKeepsEnergyAndMomentumAsTheOrderOfTheMethodSays) {
  const auto drift = [](const Method& method, double step) {
    FreeTop top(method, step);
    const double energy = top.kinetic(), momentum = norm(top.momentum());
    top.rig.run(5);
    return std::array{std::fabs(top.kinetic() / energy - 1), std::fabs(norm(top.momentum()) / momentum - 1)};
  };
  const auto middle = drift("midpoint", 1e-3), middle_fine = drift("midpoint", 5e-4);
  const auto classical = drift("runge_kutta_4", 4e-3), classical_fine = drift("runge_kutta_4", 2e-3);
  for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
    EXPECT_GT(std::log2(middle[i] / middle_fine[i]), 1.8) << i;
    EXPECT_GT(std::log2(classical[i] / classical_fine[i]), 3.8) << i;
    EXPECT_LT(classical_fine[i], 1e-9) << i;
    EXPECT_LT(drift({"dormand_prince", {{"tolerance", 1e-12}}}, 0.05)[i], 1e-9) << i;
  }
}

}  // namespace
}  // namespace murosimf::motion
