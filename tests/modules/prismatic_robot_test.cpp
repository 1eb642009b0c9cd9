// A robot of prismatic joints, a trunk on a telescopic leg with a lift: stands, lifts its weight and hops on multibody
// dynamics with every integrator, and on both versions of simplified dynamics.

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "modules/dynamic_world.h"
#include "modules/mechanics.h"

namespace murosimf::motion {
namespace {

constexpr double kG = 9.81, kTrunk = 3, kFoot = 0.5, kWeight = 1, kTotal = kTrunk + kFoot + kWeight;  // [kg]
constexpr double kLegGain = 8000, kLiftGain = 1500;                                                   // [N/m]
constexpr double kStiffness = 2e4, kRestitution = 0.3;                                                // of sole on turf
constexpr double kStand = 0.15, kLow = 0.02;                                                          // leg, lift [m]
enum Slider { kLeg, kLift };

const RobotBlueprint& hopper() {
  static const RobotBlueprint print = [] {
    Diagnostics diagnostics;
    RobotBlueprint made{*readUrdf(MUROSIMF_SOURCE_DIR "/tests/data/hopper.urdf", diagnostics), {}};
    made.flat = flattenTree(made.model.tree);
    return made;
  }();
  return print;
}

struct HopperLevel {
  std::string name;
  DynamicLevel level;
  double step = 1e-3;
  bool servos_give_way = true;  ///< position servos with gains; else joints follow whatever the load
  bool limbs_have_mass = true;  ///< not in version 1 of simplified dynamics
  double ground = kStiffness;   ///< force over depth at rest
};
HopperLevel multibodyLevel(const std::string& integrator, double step) {
  DynamicLevel level = multibody("hunt_crossley_contact", integrator);
  level.modules.emplace_back("joint_torque_sensor");
  return {integrator, level, step};
}
HopperLevel simplifiedLevel(const std::string& name, double recompute) {
  DynamicLevel level = simplified().with("simplified_dynamics.recompute", recompute);
  level.modules.emplace_back("torque_estimate");
  return {name, level, 1e-3, false, recompute == 1, kStiffness * (1 + kRestitution) / 2};
}

class Hoppers {
 public:
  explicit Hoppers(const HopperLevel& level, int count = 1, int lanes = 1) : level_(level), world_(level.step) {
    for (int i = 0; i < count; ++i)
      robots_.push_back(world_.add("hopper" + std::to_string(i), hopper(), {kStand, kLow}));
    world_.link(level.level, lanes);
  }
  /// Wants a slider at q, going there at `speed`; 0: as fast as it can.
  void command(Slider slider, double q, double speed = 0, std::size_t i = 0) {
    world_.linked().handle(robots_[i], kJointCommand, subset::kJoints).set({q, speed, 0, 1, 0}, slider);
  }
  void place(const PlanarPose& pose) { world_.place(0, pose); }
  void run(double seconds) { world_.run(seconds); }
  void step() { world_.step(); }
  double time() const { return world_.time(); }
  double q(Slider slider, std::size_t i = 0) const {
    return world_.get(robots_[i], kJointPosition, subset::kJoints, slider);
  }
  double dq(Slider slider) const { return world_.get(robots_[0], kJointVelocity, subset::kJoints, slider); }
  double force(Slider slider) const { return world_.get(robots_[0], kMeasuredTorque, subset::kJoints, slider); }
  Pose base(std::size_t i = 0) const { return world_.base(robots_[i]); }
  /// Height of the foot's lower face.
  double clearance() const { return base().translation.z - 0.1 - q(kLeg) - 0.015; }
  /// Vertical momentum: of all bodies, or of one that has all the mass and moves with the base.
  double momentum() {
    if (!level_.limbs_have_mass) return kTotal * (base().rotation * world_.get(robots_[0], kBaseVelocity).v).z;
    return mechanicsOf(world_.world(), world_.linked(), robots_[0]).linear.z;
  }
  double height() {
    if (!level_.limbs_have_mass) return base().translation.z;
    return mechanicsOf(world_.world(), world_.linked(), robots_[0]).centre.z;
  }

 private:
  HopperLevel level_;
  DynamicWorld world_;
  std::vector<ObjectId> robots_;
};

class PrismaticRobot : public testing::TestWithParam<HopperLevel> {};

TEST_P(PrismaticRobot, ServosCarryWhatStandsOnThemAndTheGroundCarriesAll) {
  const HopperLevel& level = GetParam();
  Hoppers hopper(level);
  hopper.run(2);
  EXPECT_NEAR(hopper.force(kLeg), (kTrunk + kWeight) * kG, 1e-3);
  EXPECT_NEAR(hopper.force(kLift), kWeight * kG, 1e-3);
  EXPECT_NEAR(hopper.q(kLeg), kStand - (level.servos_give_way ? (kTrunk + kWeight) * kG / kLegGain : 0), 1e-6);
  EXPECT_NEAR(hopper.q(kLift), kLow - (level.servos_give_way ? kWeight * kG / kLiftGain : 0), 1e-6);
  EXPECT_NEAR(hopper.clearance(), -kTotal * kG / level.ground, 1e-6);
  EXPECT_NEAR(hopper.base().rotation.z.z, 1, 1e-9);
}

TEST_P(PrismaticRobot, LiftsItsWeightAtASteadySpeedWithTheForceOfThatWeight) {
  const HopperLevel& level = GetParam();
  Hoppers hopper(level);
  hopper.run(1);
  hopper.command(kLift, 0.25, 0.2);
  hopper.run(0.8);
  EXPECT_NEAR(hopper.dq(kLift), 0.2, 1e-3);
  // The position that a servo holds moves on once a step: within it the force falls by so much.
  const double behind = kLiftGain * 0.2 * level.step;
  EXPECT_NEAR(hopper.force(kLift), kWeight * kG, 0.02 + behind / 2);
  EXPECT_NEAR(hopper.force(kLeg), (kTrunk + kWeight) * kG, 0.1 + behind / 2);
  hopper.run(1.5);
  EXPECT_NEAR(hopper.q(kLift), 0.25 - (level.servos_give_way ? kWeight * kG / kLiftGain : 0), 1e-5);
  EXPECT_NEAR(hopper.force(kLift), kWeight * kG, 1e-2);
}

/// Stretches its leg until the foot is in the air.
void takeOff(Hoppers& hopper) {
  hopper.run(1);
  hopper.command(kLeg, 0.05);
  hopper.run(1);
  hopper.command(kLeg, 0.25, 2);
  for (const double end = hopper.time() + 0.5; hopper.clearance() < 2e-3 && hopper.time() < end;) hopper.step();
  ASSERT_GT(hopper.clearance(), 2e-3);
}

TEST_P(PrismaticRobot, InTheAirItsMomentumFallsByItsWeightWhateverItsJointsDo) {
  Hoppers hopper(GetParam());
  takeOff(hopper);
  const double start = hopper.time(), p = hopper.momentum(), z = hopper.height(), v = p / kTotal;
  EXPECT_GT(v, 1);
  hopper.command(kLeg, 0.1), hopper.command(kLift, 0.15);  // draws up its leg and lifts its weight
  double highest = z;
  while (hopper.clearance() > 2e-3) {
    hopper.step();
    if (hopper.clearance() < 2e-3) break;
    const double t = hopper.time() - start;
    EXPECT_NEAR(hopper.momentum(), p - kTotal * kG * t, 1e-9) << t;
    highest = std::max(highest, hopper.height());
  }
  EXPECT_GT(hopper.time() - start, 1.5 * v / kG);
  EXPECT_NEAR(highest - z, v * v / (2 * kG), 0.01 * v * v / (2 * kG));
}

TEST_P(PrismaticRobot, LandsAndStandsAsBefore) {
  Hoppers hopper(GetParam());
  hopper.run(1.5);
  const Pose before = hopper.base();
  takeOff(hopper);
  hopper.command(kLeg, kStand, 0.5);
  hopper.run(4);
  EXPECT_LT(norm(hopper.base().translation - before.translation), 1e-3);
  EXPECT_GT(hopper.base().rotation.z.z, 0.9999);
}

INSTANTIATE_TEST_SUITE_P(Levels, PrismaticRobot,
                         testing::Values(multibodyLevel("implicit_euler", 1e-3),
                                         multibodyLevel("semi_implicit_euler", 1e-4),
                                         multibodyLevel("explicit_euler", 1e-4), multibodyLevel("midpoint", 1e-4),
                                         multibodyLevel("runge_kutta_4", 1e-4), multibodyLevel("dormand_prince", 1e-3),
                                         simplifiedLevel("simplified_two", 1), simplifiedLevel("simplified_one", 0)),
                         [](const auto& test) { return test.param.name; });

TEST(PrismaticRobotLanes, EqualScalarBitForBitStandingLiftingAndHopping) {
  const auto drive = [](Hoppers& hoppers, std::size_t first, std::size_t count) {
    hoppers.run(0.3);
    for (std::size_t k = 0; k < count; ++k) {
      const double share = static_cast<double>(first + k) / 4;
      hoppers.command(kLeg, 0.15 + 0.12 * share, 2 * share, k);
      hoppers.command(kLift, kLow + 0.2 * share, 0, k);
    }
    hoppers.run(0.4);
  };
  for (const HopperLevel& level : {multibodyLevel("implicit_euler", 1e-3), multibodyLevel("runge_kutta_4", 1e-4),
                                   simplifiedLevel("two", 1), simplifiedLevel("one", 0)}) {
    for (const int lanes : {4, 8}) {
      Hoppers together(level, 4, lanes);
      drive(together, 0, 4);
      for (std::size_t i = 0; i < 4; ++i) {
        Hoppers alone(level);
        alone.place({0, static_cast<double>(i), 0});
        drive(alone, i, 1);
        const Pose a = together.base(i), b = alone.base();
        EXPECT_EQ(std::memcmp(&a, &b, sizeof(Pose)), 0) << level.name << " " << lanes << " " << i;
        for (const Slider slider : {kLeg, kLift}) EXPECT_EQ(together.q(slider, i), alone.q(slider)) << level.name;
      }
    }
  }
}

}  // namespace
}  // namespace murosimf::motion
