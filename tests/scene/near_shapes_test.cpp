// Lists of shapes that may touch soon: nothing that touches is ever missed.

#include <random>
#include <set>

#include "murosimf/modules/contact/robot_pairs.h"
#include "scene/touching_robots.h"

namespace murosimf::test {
namespace {

/// Two shapes of two robots, by the robots' numbers and the shapes'.
using Touch = std::tuple<std::size_t, std::uint16_t, std::size_t, std::uint16_t>;

/// What touches at the start of the frame to come, by looking at every shape of every robot.
class Onlooker {
 public:
  explicit Onlooker(Robots& robots) : robots_(robots), table_(robots.simulation().world()) {
    Simulation& simulation = robots_.simulation();
    for (std::size_t i = 0; i < robots_.count(); ++i)
      seen_.emplace_back(simulation.world(), simulation.linked(), robots_.robot(i), table_, kinds_);
  }
  std::set<Touch> look() {
    const Simulation& simulation = robots_.simulation();
    for (ContactRobot& robot : seen_) robot.begin(simulation.frame(), simulation.frameLength());
    std::set<Touch> touching;
    for (std::size_t a = 0; a < seen_.size(); ++a) {
      for (std::size_t b = a + 1; b < seen_.size(); ++b) look(a, b, touching);
    }
    return touching;
  }
  /// The same as the simulation found it in its last frame.
  std::set<Touch> found() {
    std::set<Touch> touching;
    for (const ContactPair& pair : robots_.simulation().pairs().contacts().pairs) {
      if (!pair.found) continue;
      const std::size_t a = numberOf(pair.key.name_a), b = numberOf(pair.key.name_b);
      if (a < b) touching.emplace(a, pair.key.shape_a, b, pair.key.shape_b);
      if (b < a) touching.emplace(b, pair.key.shape_b, a, pair.key.shape_a);
    }
    return touching;
  }

 private:
  void look(std::size_t a, std::size_t b, std::set<Touch>& touching) const {
    if (!seen_[a].present() || !seen_[b].present() || (!seen_[a].recoils() && !seen_[b].recoils())) return;
    for (const Obstacle& shape_a : seen_[a].shapes()) {
      for (const Obstacle& shape_b : seen_[b].shapes()) {
        const Pose X_WA = seen_[a].bodyPose(shape_a.row) * shape_a.X_BS,
                   X_WB = seen_[b].bodyPose(shape_b.row) * shape_b.X_BS;
        ContactManifold manifold;
        detectContact(shape_a.collision, X_WA, shape_b.collision, X_WB, manifold);
        if (manifold.count > 0 && deepest(manifold).depth > 1e-6)
          touching.emplace(a, shape_a.number, b, shape_b.number);
      }
    }
  }
  std::size_t numberOf(std::uint64_t name) const {
    return static_cast<std::size_t>(
        std::find_if(seen_.begin(), seen_.end(), [&](const ContactRobot& robot) { return robot.name() == name; }) -
        seen_.begin());
  }

  Robots& robots_;
  ContactTable table_;
  std::vector<SharedKind> kinds_;
  std::vector<ContactRobot> seen_;
};

class Throws {
 public:
  Throws() : robots_(kLevels) {}

  /// One robot is thrown onto another, or placed beside it, and limbs move about.
  void disturb() {
    const std::size_t i = index(3), other = index(4);
    const Vector3 p = robots_.base(other).get().translation;
    if (number() < 0)
      robots_.place(i, {p.x + 0.2 * number(), p.y + 0.2 * number(), kPi * number()});
    else
      robots_.put(i, {rotationExp(Vector3{3 * number(), 3 * number(), 3 * number()}), {p.x, p.y, 0.5}},
                  Vector3{number(), number(), number()});
    robots_.command(index(3), "shoulder_pitch_left", 2 * number());
    robots_.command(index(3), "knee_right", 1 + number());
  }
  Robots& robots() { return robots_; }

 private:
  inline static const std::vector<std::string> kLevels = {"multibody_dynamics", "simplified_dynamics",
                                                          "multibody_dynamics", "kinematic_walking"};
  double number() { return std::uniform_real_distribution<double>(-1, 1)(random_); }
  std::size_t index(std::size_t below) { return std::uniform_int_distribution<std::size_t>(0, below - 1)(random_); }
  Robots robots_;
  std::mt19937 random_{11};
};

TEST(NearShapes, NeverMissAContactOfRobotsThatAreThrownPlacedAndMoved) {
  Throws throws;
  Simulation& simulation = throws.robots().simulation();
  Onlooker onlooker(throws.robots());
  constexpr long kStep = 10;  // frames: of kinematic walking, which chooses its path at the start of the first one
  std::size_t seen = 0, missed = 0;
  for (int k = 0; k < 15; ++k) {
    throws.disturb();
    for (int i = 0; i < 200; ++i) {
      // Who was thrown is seen in the first frame where it was before, and as if it had flown in the second one.
      const bool known = simulation.frame() % kStep != 0 && i > 1;
      const std::set<Touch> touching = known ? onlooker.look() : std::set<Touch>{};
      simulation.step();
      const std::set<Touch> found = onlooker.found();
      for (const Touch& touch : touching) missed += found.contains(touch) ? 0U : 1U;
      seen += touching.size();
    }
  }
  EXPECT_EQ(missed, 0U);
  EXPECT_GT(seen, 2000U) << "of some pairs of shapes a frame";
  EXPECT_GT(simulation.pairs().counts().listed, 0) << "they still lie beside one another";
}

TEST(NearShapes, LookAtShapesAgainOnlyWhenTheyMayHaveMet) {
  Robots robots({"multibody_dynamics", "multibody_dynamics"});
  robots.place(1, {0, 0.25, 0});
  for (int i = 0; i < 100; ++i) robots.simulation().step();
  long listed = 0, tested = 0;
  for (int i = 0; i < 500; ++i) {
    robots.simulation().step();
    listed += robots.simulation().pairs().counts().listed;
    tested += robots.simulation().pairs().counts().tested;
  }
  EXPECT_GT(listed, 500);
  EXPECT_LT(tested, listed / 5) << "they hardly move";
}

/// A robot with sliders, off the ground.
class SlidersInFlight {
 public:
  SlidersInFlight() {
    simulation_->step();  // which places it
    travel_.reserve(seen_, numbers_);
  }
  void put(const Pose& X_WB, const SpatialMotion<double>& motion) {
    linked_.handle(robot_, kBasePose).set(X_WB);
    linked_.handle(robot_, kBaseVelocity).set(motion);
  }
  /// A joint that is commanded to stay there.
  void slideOut(int joint, double position) {
    linked_.handle(robot_, kJointPosition, subset::kJoints).set(position, joint);
    linked_.handle(robot_, kJointVelocity, subset::kJoints).set(0, joint);
    linked_.handle(robot_, kJointCommand, subset::kJoints).set({position, 0, 0, 1, 0}, joint);
  }
  void step() {
    simulation_->step();
    seen_.begin(simulation_->frame(), simulation_->frameLength());
    travel_.follow(seen_, simulation_->frame(), ways_);
  }
  /// Of the far face of a shape, in the world.
  Vector3 end(std::size_t shape, double sign) {
    const Obstacle& s = seen_.shapes()[shape];
    return seen_.bodyPose(s.row) * (s.X_BS * Vector3{0, 0, sign * s.shape.half_size.z});
  }
  const Travel& travel(std::size_t shape) const { return travel_.of(shape); }

 private:
  BuiltWorld built_{
      "[referee]\nenabled = false\n[ball]\npresent = false\n[robots.red.1]\n"
      "file = \"tests/data/hopper.urdf\"\npose = [0, 0, 0]\nlevel = \"full\"\n"};
  std::unique_ptr<Simulation> simulation_ = built_.simulation();
  LinkedWorld& linked_ = simulation_->linked();
  ObjectId robot_ = simulation_->world().find("robots.red.1");
  ContactTable table_{simulation_->world()};
  std::vector<SharedKind> kinds_;
  ContactRobot seen_{simulation_->world(), linked_, robot_, table_, kinds_};
  std::vector<double> numbers_ = std::vector<double>(ShapeTravel::numbersOf(seen_));
  std::vector<ShapeTravel::Way> ways_ = std::vector<ShapeTravel::Way>(seen_.limbs().size());
  ShapeTravel travel_;
};

TEST(ShapeTravel, BoundsTheWayOfASlidersEndWhenTheRobotTurns) {
  constexpr std::size_t kFoot = 1;
  SlidersInFlight robot;
  robot.put({{}, {0, 0, 5}}, {{5, 0, 0}, {}});
  robot.slideOut(0, 0.3);
  for (int i = 0; i < 8; ++i) robot.step();
  const Vector3 first = robot.end(kFoot, -1);
  const double before = robot.travel(kFoot).before;
  double way = 0;
  for (int i = 0; i < 100; ++i) {
    robot.step();
    const double gone = norm(robot.end(kFoot, -1) - first);
    EXPECT_LE(gone, robot.travel(kFoot).now - before) << i;
    way = std::max(way, gone);
  }
  EXPECT_GT(way, 0.1) << "it turns and falls";
  EXPECT_LT(robot.travel(kFoot).now - before, 10) << "a bound, not kUnknown";
}

// The weight on its lift: 0.12 m above the trunk's centre, 0.3 m out, and no point of it farther than e = 0.069 m from
// its body's origin. Turned about the trunk's centre its top goes 0.46 m per radian. A lever that forgot how far the
// slider is out would be 0.189 m, sqrt(2) times that (|dR| of a small turn) 0.267 m: less than the way.
TEST(ShapeTravel, CountsHowFarASliderIsOutAsItsLeverWhereTheRobotTurnsOnTheSpot) {
  constexpr std::size_t kWeight = 2;
  constexpr double kTurn = 0.005, kOut = 0.3;  // [rad] a frame, [m]
  SlidersInFlight robot;
  int turns = 0;
  const auto turn = [&] {
    robot.put({rotationY(kTurn * ++turns), {0, 0, 5}}, {});
    robot.slideOut(1, kOut);
    robot.step();
  };
  for (int i = 0; i < 8; ++i) turn();
  const Vector3 first = robot.end(kWeight, 1);
  const double before = robot.travel(kWeight).before;
  constexpr int kFrames = 40;
  for (int i = 0; i < kFrames; ++i) turn();
  const double gone = norm(robot.end(kWeight, 1) - first), bound = robot.travel(kWeight).now - before;
  EXPECT_NEAR(gone, 2 * 0.46 * std::sin(0.5 * kFrames * kTurn), 1e-3);
  EXPECT_LE(gone, bound);
  EXPECT_LT(bound, 2 * gone) << "sqrt(2) of the norm, and half as much again of e";
}

}  // namespace
}  // namespace murosimf::test
