// Capsules and convex hulls on the ground: depth at rest, a cube as a box, the same bits in lanes.

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "modules/single_body.h"
#include "murosimf/algorithms/collision/hull_shape.h"

namespace murosimf::motion {
namespace {

constexpr double kG = 9.81, kMass = 2, kStiffness = 1e4, kDepth = kMass * kG / kStiffness;
constexpr double kRadius = 0.04, kHalfLength = 0.06;

SurfacePair turf() {
  SurfacePair pair;
  pair.stiffness = kStiffness, pair.restitution_factor = 0.3, pair.dissipation = 5;
  pair.friction = 0.6, pair.stick_speed = 2e-3, pair.viscous_friction = 10;
  return pair;
}
MassProperties massOf(const Vector3& moments) { return {kMass, {}, {moments.x, moments.y, moments.z, 0, 0, 0}}; }
SingleBody over(const RobotBlueprint& print, const char* contact = "hunt_crossley_contact") {
  return {print, turf(), 1e-3, contact, "implicit_euler"};
}

RobotBlueprint capsule() { return bodyOf(makeCapsule(kRadius, 2 * kHalfLength), massOf({5e-3, 5e-3, 2e-3})); }

HullShape cube(double half) {
  std::vector<Vector3> points;
  for (int i = 0; i < 8; ++i)
    points.push_back({(i & 1) != 0 ? half : -half, (i & 2) != 0 ? half : -half, (i & 4) != 0 ? half : -half});
  return makeConvex(points);
}
/// An upright prism whose ends have so many corners.
HullShape prism(int corners) {
  std::vector<Vector3> points;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * kPi * i / corners;
    for (const double z : {-kHalfLength, kHalfLength})
      points.push_back({kRadius * cos(angle), kRadius * sin(angle), z});
  }
  return makeConvex(points);
}

TEST(GroundUnderACapsule, CarriesOneThatLiesAtTheDepthOfItsLaw) {
  for (const auto& [contact, depth] : {std::pair{"hunt_crossley_contact", 1.0}, {"smooth_contact", 2 / 1.3}}) {
    SingleBody b = over(capsule(), contact);
    b.set({rotationY(kPi / 2) * rotationZ(0.3), {0, 0, kRadius}});
    b.run(2);
    EXPECT_NEAR(kRadius - b.pose().translation.z, depth * kDepth, 1e-7) << contact;
    EXPECT_LT(norm(b.velocity().v), 1e-6);
  }
}

TEST(GroundUnderACapsule, CarriesOneOnItsEndTwiceAsDeep) {
  SingleBody b = over(capsule());
  b.set({Rotation3{}, {0, 0, kRadius + kHalfLength}});
  b.run(1);
  EXPECT_NEAR(kRadius + kHalfLength - b.pose().translation.z, 2 * kDepth, 1e-6);
}

TEST(GroundUnderACapsule, MovesOneWithoutLengthAsASphere) {
  const MassProperties mass = massOf({.4 * kMass * kRadius * kRadius, .4 * kMass * kRadius * kRadius, 1.3e-3});
  SingleBody round = over(bodyOf(makeSphere(kRadius), mass)), capsule = over(bodyOf(makeCapsule(kRadius, 1e-12), mass));
  for (SingleBody* b : {&round, &capsule}) {
    b->set({rotationX(0.5), {0, 0, kRadius + 0.05}}, {{1, 4, 9}, {0.7, 0.2, 0}});
    b->run(1);
  }
  EXPECT_LT(norm(round.pose().translation - capsule.pose().translation), 1e-7);
  EXPECT_LT(norm(round.velocity().w - capsule.velocity().w), 1e-6);
  EXPECT_GT(norm(round.pose().translation), 0.3) << "it was to roll";
}

struct Resting {
  const char* name;
  HullShape hull;
  Rotation3 R_WB;
  double height;  ///< of the body's origin over the face on which it rests
};
class GroundUnderAHull : public testing::TestWithParam<Resting> {};

TEST_P(GroundUnderAHull, CarriesItAtTheDepthOfTheLawWhateverTheNumberOfItsCorners) {
  for (const auto& [contact, depth] : {std::pair{"hunt_crossley_contact", 1.0}, {"smooth_contact", 2 / 1.3}}) {
    SingleBody b = over(bodyOf(GetParam().hull, massOf({5e-3, 5e-3, 2e-3})), contact);
    b.set({GetParam().R_WB, {0, 0, GetParam().height}});
    b.run(2);
    EXPECT_NEAR(GetParam().height - b.pose().translation.z, depth * kDepth, 1e-6) << contact;
    EXPECT_LT(norm(b.velocity().v), 1e-6);
  }
}
std::vector<Resting> restingHulls() {
  const double beside = kRadius * cos(kPi / 24);  // of a side of the prism with 24 corners
  return {{"cube", cube(0.05), rotationX(kPi / 2), 0.05},
          {"tetrahedron", makeConvex(std::vector<Vector3>{{.06, 0, 0}, {-.03, .05, 0}, {-.03, -.05, 0}, {0, 0, .08}}),
           Rotation3{}, 0},
          {"end_of_a_prism", prism(24), Rotation3{}, kHalfLength},
          {"side_of_a_prism", prism(24), rotationY(kPi / 2) * rotationZ(kPi / 24), beside},
          {"end_of_a_prism_of_90", prism(90), Rotation3{}, kHalfLength}};
}
INSTANTIATE_TEST_SUITE_P(Faces, GroundUnderAHull, testing::ValuesIn(restingHulls()),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(GroundUnderAHull, MovesACubeAsABox) {
  const MassProperties mass = boxMass(kMass, {0.1, 0.1, 0.1}, {});
  for (const double tilt : {0.0, 0.02, 0.5, 2.0}) {
    SingleBody box = over(bodyOf(makeBox({0.1, 0.1, 0.1}), mass)), hull = over(bodyOf(cube(0.05), mass));
    double farthest = 0;
    for (SingleBody* b : {&box, &hull})
      b->set({rotationX(tilt) * rotationY(0.3 * tilt), {0, 0, 0.15}}, {{}, {.3, 0, 0}});
    for (int k = 0; k < 1000; ++k) {
      box.step(), hull.step();
      farthest = max(farthest, norm(box.pose().translation - hull.pose().translation));
    }
    EXPECT_LT(farthest, 1e-6) << tilt;
    EXPECT_LT(box.pose().translation.z, 0.09) << "it was to fall";
  }
}

TEST(GroundUnderAHull, LetsADiscOfManyCornersRockAndComeToRest) {
  for (const double tilt : {0.05, 0.2, 0.4}) {
    SingleBody b = over(bodyOf(prism(60), massOf({5e-3, 5e-3, 2e-3})));
    b.set({rotationX(tilt), {0, 0, 0.08}});
    double fastest = 0;
    for (int k = 0; k < 4000; ++k) {
      b.step();
      fastest = max(fastest, b.worldVelocity().z);
    }
    EXPECT_LT(fastest, 0.5) << "nothing throws it up, " << tilt;
    EXPECT_LT(norm(b.velocity().v), 1e-4) << tilt;
    EXPECT_LT(norm(b.velocity().w), 1e-3) << tilt;
    EXPECT_NEAR(b.pose().translation.z, kHalfLength - kDepth, 1e-5) << tilt;
  }
}

/// A robot with a hull, and a capsule across it.
RobotBlueprint hullWithCapsule() {
  RobotBlueprint print = bodyOf(prism(7), massOf({5e-3, 4e-3, 3e-3}));
  BodyShape across;
  across.shape = makeCapsule(0.02, 0.1), across.X_BS = {rotationX(1.0), {0.02, 0, 0.05}}, across.surface = "plastic";
  print.model.tree.bodies[0].shapes.push_back(across);
  return print;
}

/// Where robots are that tumble over the ground, each its own way, from number `first` on.
std::vector<Pose> tumble(std::size_t first, std::size_t count, int lanes) {
  DynamicWorld world(1e-3, onGround(turf()));
  for (std::size_t k = 0; k < count; ++k) world.add("robot" + std::to_string(k), hullWithCapsule(), {});
  world.link({{"tree_motion", "hunt_crossley_contact", "multibody_dynamics", "implicit_euler"}}, lanes);
  for (std::size_t k = 0; k < count; ++k) {
    const double number = static_cast<double>(first + k);
    world.linked().handle(world.robots()[k], kBasePose).set({rotationX(0.4 * number), {0, 0, 0.1 + 0.003 * number}});
    world.linked().handle(world.robots()[k], kBaseVelocity).set({{number, 2, 0}, {0.2, 0, 0}});
  }
  world.run(0.8);
  std::vector<Pose> poses;
  for (const ObjectId robot : world.robots()) poses.push_back(world.base(robot));
  return poses;
}

TEST(GroundUnderCapsulesAndHulls, GivesInLanesTheBitsOfTheScalar) {
  std::vector<Pose> alone;
  for (std::size_t k = 0; k < 8; ++k) alone.push_back(tumble(k, 1, 1).front());
  for (const int lanes : {4, 8}) {
    const std::vector<Pose> together = tumble(0, 8, lanes);
    for (std::size_t k = 0; k < 8; ++k)
      EXPECT_EQ(std::memcmp(&together[k], &alone[k], sizeof(Pose)), 0) << lanes << " lanes, robot " << k;
  }
}

TEST(GroundUnderCapsulesAndHulls, IsFeltByTouchSensors) {
  RobotBlueprint print = bodyOf(cube(0.05), boxMass(kMass, {0.1, 0.1, 0.1}, {}));
  TouchSensorMount sensor;
  sensor.name = "touch", sensor.body = 0;
  print.model.touch_sensors = {sensor};
  DynamicWorld world(1e-3, onGround(turf()));
  const ObjectId body = world.add("body", print, {});
  world.link({{"tree_motion", "hunt_crossley_contact", "multibody_dynamics", "touch_sensor", "implicit_euler"}});
  world.run(1);
  EXPECT_NEAR(world.get(body, kTouchForce, subset::kTouchSensors, 0), kMass * kG, 1e-3);
  EXPECT_EQ(world.get(body, kTouch, subset::kTouchSensors, 0), 1);
}

/// What the corners of a sole feel of a cube that stands on it, its weight off the middle.
CornerForces<> pressureUnder(RobotBlueprint print, double sole_size) {
  Sole sole;
  sole.name = "sole", sole.body = 0, sole.length = sole.width = sole_size, sole.X_BSole.translation.z = -0.05;
  print.model.soles = {sole};
  DynamicWorld world(1e-3, onGround(turf()));
  const ObjectId body = world.add("body", print, {});
  world.link({{"tree_motion", "hunt_crossley_contact", "multibody_dynamics", "foot_pressure", "implicit_euler"}});
  world.run(2);
  return world.get(body, kSolePressure, subset::kSoles, 0);
}

TEST(GroundUnderAHull, IsFeltByPressureSensorsAsUnderABox) {
  const MassProperties mass = boxMass(kMass, {0.1, 0.1, 0.1}, {0.01, -0.005, 0.02});
  const CornerForces<> box = pressureUnder(bodyOf(makeBox({0.1, 0.1, 0.1}), mass), 0.1);
  const CornerForces<> hull = pressureUnder(bodyOf(cube(0.05), mass), 0.1);
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(hull.of[i], box.of[i], 1e-6) << i;
  EXPECT_GT(box.of[1], box.of[0] + 1);
  // The corners of a larger sole share the same forces, about the same point.
  const CornerForces<> wide = pressureUnder(bodyOf(cube(0.05), mass), 0.15);
  const auto sum = [](const CornerForces<>& f) { return f.of[0] + f.of[1] + f.of[2] + f.of[3]; };
  const auto momentAboutY = [](const CornerForces<>& f, double size) {
    return 0.5 * size * (f.of[1] + f.of[3] - f.of[0] - f.of[2]);
  };
  EXPECT_NEAR(sum(wide), kMass * kG, 1e-6);
  EXPECT_NEAR(momentAboutY(wide, 0.15), momentAboutY(box, 0.1), 1e-6);
}

TEST(StandingPose, PutsCapsulesAndHullsOntoTheGround) {
  const auto heightOf = [](RobotBlueprint print, const Pose& X_BS) {
    print.model.tree.bodies[0].shapes[0].X_BS = X_BS;
    World world;
    StandingPose standing(world, addRobot(world, "body", print, Colour{}));
    return standing.find({}, {}).translation.z;
  };
  const Pose X_BS{rotationY(0.7), {0.01, 0.02, -0.3}};
  EXPECT_NEAR(heightOf(capsule(), X_BS), 0.3 + kHalfLength * cos(0.7) + kRadius, 1e-12);
  EXPECT_NEAR(heightOf(bodyOf(cube(0.05), massOf({5e-3, 5e-3, 2e-3})), X_BS), 0.3 + 0.05 * (cos(0.7) + sin(0.7)),
              1e-12);
}

}  // namespace
}  // namespace murosimf::motion
