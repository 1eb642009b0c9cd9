// A robot that falls comes to rest, whatever its level of detail, wherever it falls, and sinks in nowhere.

#include "player/walking_engine.h"
#include "scene/touching_robots.h"

namespace murosimf::test {
namespace {

/// A level of detail with what the scenario changes about it.
struct Level {
  const char *name, *motion;
  std::vector<std::string> overrides = {};
};
const std::vector<Level>& levels() {
  static const std::vector<Level> all = {
      {"full", "multibody_dynamics"},
      {"full_composite_body", "composite_body_dynamics"},
      {"full_smooth_contact", "multibody_dynamics", {"robots.all.contact=smooth_contact"}},
      {"full_runge_kutta_4", "multibody_dynamics", {"robots.all.integration=runge_kutta_4"}},
      {"fast", "simplified_dynamics"},
      {"fast_version_1", "simplified_dynamics", {"robots.all.motion.recompute=0"}},
      {"fast_hunt_crossley_contact", "simplified_dynamics", {"robots.all.contact=hunt_crossley_contact"}}};
  return all;
}
/// From standing, on the way down [rad].
struct Side {
  const char* name;
  double roll, pitch;
};
constexpr Side kSides[] = {
    {"on_its_face", 0, 0.6}, {"on_its_back", 0, -0.6}, {"on_its_right_side", 0.7, 0}, {"on_its_left_side", -0.7, 0}};
enum class Posture { kWalkReady, kStraight };  ///< as robots of games fall; all joints at zero

using Fall = std::tuple<Level, Side, Posture>;
std::string nameOf(const testing::TestParamInfo<Fall>& test) {
  const auto& [level, side, posture] = test.param;
  return std::string(level.name) + "_" + side.name + (posture == Posture::kStraight ? "_straight" : "");
}

/// One robot on its way down.
class FallingRobot {
 public:
  FallingRobot(const Level& level, const Side& side, const controllers::JointAngles* held)
      : one_({level.motion}, level.overrides) {
    if (held != nullptr) stand(*held);
    const Pose standing = one_.base(0).get();
    one_.put(0, {fromRollPitchYaw(Vector3{side.roll, side.pitch, 0.0}), standing.translation + Vector3{0, 0, 0.05}});
    one_.simulation().step();
    first_moment_ = one_.mass(0).moment.z;
  }
  /// Until 0.2 s after `seconds`. @return when its kinetic energy was above 1e-4 J for the last time [s]
  double fall(double seconds) {
    const double start = one_.simulation().time();
    double moving = 0;
    while (one_.simulation().time() - start < seconds + 0.2) {
      one_.simulation().step();
      deepest_ = std::max(deepest_, depth());
      if (one_.kineticEnergy(0) > 1e-4) moving = one_.simulation().time() - start;
    }
    return moving;
  }
  bool lies() { return one_.base(0).get().rotation.z.z < 0.5; }
  double depth() { return -one_.lowestPoint(0); }
  double deepest() const { return deepest_; }
  /// s_c D^2/2 = m g h: a spring of that stiffness that took all the energy of the way down.
  double depthOfAllEnergy(double stiffness) {
    return std::sqrt(2 * 9.81 * (first_moment_ - one_.mass(0).moment.z) / stiffness);
  }

 private:
  /// Joints go there in a second, and the robot has another half to calm down.
  void stand(const controllers::JointAngles& held) {
    for (int i = 0; i < 1500; ++i) {
      controllers::JointAngles angles = held;
      for (double& angle : angles) angle *= std::min(1.0, one_.simulation().time());
      if (i % 10 == 0) one_.commandAll(0, angles);
      one_.simulation().step();
    }
  }

  Robots one_;
  double first_moment_ = 0, deepest_ = 0;
};

std::ostream& operator<<(std::ostream& out, const Level& level) { return out << level.name; }
std::ostream& operator<<(std::ostream& out, const Side& side) { return out << side.name; }

class RobotThatFalls : public testing::TestWithParam<Fall> {};

// Its servos hold their posture. On its side it rocks on arm, forearm and foot, which takes longest: 1.8 s.
// 5 mm hold for the robot that lies. While it falls a body of 3.3 kg that comes with v goes v sqrt(m/s_c) deep: 26 mm
// at 2 m/s and 2e4 N/m. Level `full` stays far below since its joints give way and its law damps the impact.
TEST_P(RobotThatFalls, LiesStillWithinTwoSecondsAndSinksNowhere) {
  const auto& [level, side, posture] = GetParam();
  const controllers::JointAngles straight{}, ready = controllers::walkingPose({}, 0, 0, {});
  FallingRobot robot(level, side, posture == Posture::kStraight ? &straight : &ready);
  EXPECT_LT(robot.fall(2), 2) << "[s]";
  EXPECT_TRUE(robot.lies());
  EXPECT_LT(robot.depth(), 5e-3);
  EXPECT_LT(robot.deepest(), robot.depthOfAllEnergy(2e4)) << "on its way";
  if (std::string_view(level.name) == "full") {
    EXPECT_LT(robot.deepest(), 6e-3) << "on its way";
  }
}

INSTANTIATE_TEST_SUITE_P(Levels, RobotThatFalls,
                         testing::Combine(testing::ValuesIn(levels()), testing::ValuesIn(kSides),
                                          testing::Values(Posture::kWalkReady, Posture::kStraight)),
                         nameOf);

// Servos that nobody commands are off at level `full`: a chain of limbs that folds up and rolls from its arm onto its
// face, braked by the gears alone. Off its balance on the arm it tips at sqrt(m g h/(I + m h^2)), some 8/s.
TEST(LimpRobot, FoldsUpAndLiesStillAfterASecondMore) {
  for (const Side& side : kSides) {
    FallingRobot robot(levels()[0], side, nullptr);
    const double longest = side.roll != 0 ? 3.4 : 2;
    EXPECT_LT(robot.fall(longest), longest) << side.name << " [s]";
    EXPECT_TRUE(robot.lies()) << side.name;
    EXPECT_LT(robot.depth(), 5e-3) << side.name;
  }
}

/// Scenario in which dry friction creeps with 0.2 mm/s at most instead of 2 and 10.
std::vector<std::string> thatHardlyCreeps() {
  std::vector<std::string> overrides{"robots.all.contact=hunt_crossley_contact"};
  for (const char* pair : {"plastic-turf", "sole-turf", "plastic-plastic", "plastic-sole", "sole-sole"})
    overrides.push_back(fmt::format("surfaces.{}.stick_speed=0.0002", pair));
  return overrides;
}

// A heap in which friction creeps slips now and then until it lies flat, as sand on a table that is tapped. Limbs that
// slide off others take most of the time.
TEST(RobotHeap, OfTenThatFallOnOneAnotherComesToRest) {
  for (const char* motion : {"multibody_dynamics", "simplified_dynamics"}) {
    Robots ten(std::vector<std::string>(10, motion), thatHardlyCreeps());
    const controllers::JointAngles ready = controllers::walkingPose({}, 0, 0, {});
    for (std::size_t k = 0; k < ten.count(); ++k) {
      const double n = static_cast<double>(k);
      ten.commandAll(k, ready);
      ten.put(k, {rotationExp(Vector3{n, 0.5 * static_cast<double>(k % 3), 0}),
                  {0.05 * static_cast<double>(k % 3), 0.04 * static_cast<double>(k % 4), 0.4 + 0.5 * n}});
    }
    double moving = 0;
    while (ten.simulation().time() < moving + 1 && ten.simulation().time() < 20) {
      ten.simulation().step();
      for (std::size_t k = 0; k < ten.count(); ++k) {
        if (ten.kineticEnergy(k) > 1e-4) moving = ten.simulation().time();
      }
    }
    EXPECT_LT(moving, 18) << motion << ": then nobody had 1e-4 J for a second";
    EXPECT_LT(ten.deepest(), 1e-3) << motion;
    EXPECT_GT(ten.simulation().pairs().counts().found, 4) << motion;
    EXPECT_TRUE(ten.simulation().guard().faults().empty());
  }
}

}  // namespace
}  // namespace murosimf::test
