// What a scenario chooses: who touches whom, with which shapes, at how many points, by which law.

#include <map>
#include <tuple>

#include "scene/touching_robots.h"

namespace murosimf::test {
namespace {

const std::string kBall = "[ball]\npresent = true\nposition = [0, 2]\n";
const std::vector<std::string> kTwo = {"multibody_dynamics", "multibody_dynamics"};

std::vector<std::string> rulesOf(const Scene& scene) {
  std::vector<std::string> names;
  for (const ContactRuleSettings& rule : scene.contacts) names.push_back(rule.name);
  return names;
}

TEST(ContactTables, HoldInTheOrderOfTheFileAndThoseOfTheCommandLineLast) {
  const std::string text = kTwoRobots +
                           "[contacts.zebra]\nwithin = \"robots\"\ncheck = false\n"
                           "[contacts.ant]\nbetween = [[\"robots.red\", \"ball\"], \"ground\"]\npoints = \"one\"\n";
  const std::vector<std::string> more = {"contacts.bee={self=\"robots.red.1\", check=true}",
                                         "contacts.zebra.stiffness=5"};
  const Scene scene = readGood(text, more);
  EXPECT_EQ(rulesOf(scene), (std::vector<std::string>{"zebra", "ant", "bee"}));
  EXPECT_EQ(*scene.contacts[0].surface.stiffness, 5);
  EXPECT_FALSE(*scene.contacts[0].check);
  EXPECT_EQ(scene.contacts[1].between->size(), 2u);
  EXPECT_EQ(*scene.contacts[1].with, std::vector<std::string>{"ground"});
  const std::string written = writeScenario(scene);
  EXPECT_EQ(writeScenario(readGood(written)), written);
  EXPECT_EQ(rulesOf(readGood(written)), rulesOf(scene));
}

TEST(ContactTables, SayWhatIsWrongWithThem) {
  const auto said = complaints(
      "[contacts.none]\ncheck = false\n[contacts.two]\nwithin = \"a\"\nself = \"b\"\ncheck = false\n"
      "[contacts.empty]\nwithin = \"robots\"\n[contacts.slip]\nwithin = 3\nbetween = [\"a\"]\nchek = true\nlaw = "
      "\"x\"\n");
  ASSERT_EQ(said.size(), 8u);
  EXPECT_EQ(said[0], "1:11: contacts.none has none of between, within and self, expected one of them");
  EXPECT_EQ(said[1], "3:11: contacts.two has more than one of between, within and self, expected one of them");
  EXPECT_EQ(said[2],
            "7:11: contacts.empty says nothing of its pairs, expected check, points or a key of [surfaces.A-B]");
  EXPECT_NE(said[3].find("12:1: unknown key \"chek\" in contacts.slip, expected"), std::string::npos) << said[3];
  EXPECT_EQ(said[4],
            "11:11: between is an array of 1 value, expected [A, B], each a name in quotes or an array of names");
  EXPECT_EQ(said[5], "10:10: within is 3, expected a name in quotes or an array of names");
  EXPECT_NE(said[6].find("law is text \"x\", expected \"smooth\""), std::string::npos) << said[6];
  EXPECT_EQ(said[7], "9:11: contacts.slip has more than one of between, within and self, expected one of them");
}

TEST(ContactTables, NamesThatMeanNothingAreErrorsAtTheirPlace) {
  BuiltWorld built(kTwoRobots + "[contacts.a]\nbetween = [\"robots.red.1.trnk\", \"ball\"]\ncheck = false\n");
  const auto said = built.complaints();
  ASSERT_EQ(said.size(), 1u);
  EXPECT_NE(said[0].find("\"robots.red.1.trnk\" in contacts.a means no body of this scenario, expected a name as in"),
            std::string::npos)
      << said[0];
  EXPECT_NE(said[0].find("(did you mean \"robots.red.1.trunk\"?)"), std::string::npos) << said[0];
}

TEST(ContactTables, APairOfSurfacesThatNobodyDescribesIsAnErrorOfTheScenario) {
  BuiltWorld built(
      kQuietGame + "[robots.red.1]\npose = [0, 0, 0]\nlevel = \"full\"\n[robots.red.2]\npose = [1, 0, 0]\n", {});
  // Nothing in the table speaks of wood.
  std::vector<PlacedShape> shapes = *built.builder.world().findShared(built.builder.participants().robots[1], kShapes);
  for (PlacedShape& shape : shapes) shape.surface = "wood";
  built.builder.world().set(built.builder.participants().robots[1], kShapes, shapes);
  const auto said = built.complaints();
  ASSERT_EQ(said.size(), 1u);
  EXPECT_NE(said[0].find("may touch, but there is no surface pair of "), std::string::npos) << said[0];
}

/// How fast the second of two robots is after the first has flown into it.
double pushedTo(const std::string& rules, const std::vector<std::string>& overrides = {}) {
  Robots two(kTwo, overrides, rules);
  two.put(0, {{}, {0, 0, 2}}, {2, 0, 0});
  two.put(1, {{}, {0.3, 0.03, 2}});
  for (int i = 0; i < 300; ++i) two.simulation().step();
  return two.momentum(1).x;
}

TEST(ContactTables, TakeAwayTheContactsOfAPairOfASetAndOfSelectedBodies) {
  EXPECT_GT(pushedTo(""), 1);
  EXPECT_NEAR(pushedTo("[contacts.a]\nbetween = [\"robots.red.1\", \"robots.red.2\"]\ncheck = false\n"), 0, 1e-6);
  EXPECT_NEAR(pushedTo("[contacts.a]\nwithin = \"robots.red\"\ncheck = false\n"), 0, 1e-6);
  EXPECT_GT(pushedTo("[contacts.a]\nwithin = \"robots.red\"\ncheck = false\n"
                     "[contacts.b]\nbetween = [\"robots.red.1.trunk\", \"robots.red.2.trunk\"]\ncheck = true\n"),
            1);
  EXPECT_GT(pushedTo("[contacts.a]\nbetween = [\"robots.red.1\", \"robots.red.2.*_left\"]\ncheck = false\n"), 0.5);
}

/// Largest number of points of a pair of shapes while two robots collide, and whether they did.
int mostPoints(const std::string& rules) {
  Robots two(kTwo, {}, rules);
  two.put(0, {{}, {0, 0, 2}}, {1, 0, 0});
  two.put(1, {{}, {0.3, 0, 2}});
  int most = 0;
  for (int i = 0; i < 400; ++i) {
    two.simulation().step();
    std::map<std::tuple<std::uint64_t, int, int>, int> points;
    for (const ContactPair& pair : two.simulation().pairs().contacts().pairs)
      most = std::max(most, ++points[{pair.key.name_a, pair.key.shape_a, pair.key.shape_b}]);
  }
  EXPECT_GT(two.momentum(1).x, 0.3);
  return most;
}

TEST(ContactTables, ChooseOnePointOrSeveral) {
  EXPECT_GT(mostPoints(""), 2) << "two trunks meet face to face";
  EXPECT_EQ(mostPoints("[contacts.a]\nwithin = \"robots\"\npoints = \"one\"\n"), 1);
}

TEST(ContactTables, GiveARobotALawOfItsOwnWithTheGround) {
  // A robot that slides on its feet stops by friction alone: v^2 / (2 mu g).
  const auto slides = [](const std::string& rules) {
    Robots one({"simplified_dynamics"}, {"robots.all.contact=\"ground_contact\""}, rules);
    const double from = one.base(0).get().translation.x;
    one.motion(0).set({{}, {0.3, 0, 0}});
    for (int i = 0; i < 1500; ++i) one.simulation().step();
    return one.base(0).get().translation.x - from;
  };
  const std::string rule = "[contacts.ice]\nbetween = [\"robots.red.1.foot_*\", \"ground\"]\n";
  const double slippery = slides(rule + "friction_coefficient = 0.05\n");
  EXPECT_NEAR(slippery, 0.3 * 0.3 / (2 * 0.05 * 9.81), 0.01);
  EXPECT_LT(slides(rule + "friction_coefficient = 0.8\n"), 0.03);
}

TEST(ContactTables, TakeAwayTheGroundOfARobot) {
  Robots one({"simplified_dynamics"}, {}, "[contacts.gone]\nbetween = [\"robots.red.1\", \"ground\"]\ncheck = false\n");
  const double from = one.base(0).get().translation.z;
  for (int i = 0; i < 300; ++i) one.simulation().step();
  EXPECT_NEAR(one.base(0).get().translation.z, from - 0.5 * 9.81 * 0.3 * 0.3, 0.01);
}

// ----------------------------------------------------------------------------- shapes that are looked at

/// Velocity along x after a ball has flown at the robot at this height, from its front.
double ballAfter(double height, const std::string& collision, const std::string& rules = "") {
  Robots one({"multibody_dynamics"}, {"robots.all.collision=" + collision, "ball.present=true", "ball.position=[0, 2]"},
             rules);
  one.putBall({0.4, 0.045, height}, {-3, 0, 0});
  for (int i = 0; i < 150; ++i) one.simulation().step();
  return one.ballVelocity().x;
}

TEST(ShapeDetection, FeetOnlyLetTheBallThroughTheTrunkAndKickItAllTheSame) {
  EXPECT_GT(ballAfter(0.4, "primitives"), 0.5);
  EXPECT_NEAR(ballAfter(0.4, "feet_only"), -3, 0.01);
  EXPECT_GT(ballAfter(0.07, "feet_only"), -2.5) << "it rolls over the toes";
}

TEST(ShapeDetection, WithoutAModuleARobotTouchesNothing) {
  EXPECT_NEAR(ballAfter(0.4, "none"), -3, 0.01);
  EXPECT_NEAR(pushedTo("", {"robots.red.1.collision=none"}), 0, 1e-6);
}

TEST(ShapeDetection, ARuleTakesTheBallFromARobot) {
  EXPECT_NEAR(ballAfter(0.4, "primitives", "[contacts.a]\nbetween = [\"ball\", \"robots\"]\ncheck = false\n"), -3,
              0.01);
}

/// Distance of the bases when two robots that fly towards one another first touch.
double touchingDistance(const std::string& collision) {
  Robots two(kTwo, {"robots.all.collision=" + collision});
  two.put(0, {{}, {0, 0, 2}}, {1, 0, 0});
  two.put(1, {{}, {0.5, 0, 2}});
  for (int i = 0; i < 600; ++i) {
    two.simulation().step();
    if (two.simulation().pairs().counts().found > 0)
      return two.base(1).get().translation.x - two.base(0).get().translation.x;
  }
  return 0;
}

TEST(ShapeDetection, BoundingSpheresTouchTooEarly) {
  const double exact = touchingDistance("primitives"), early = touchingDistance("bounding_spheres");
  EXPECT_NEAR(exact, 0.1, 0.05) << "the trunks are 0.1 m thick";
  EXPECT_GT(early, exact + 0.03);
  EXPECT_LT(early, 0.3);
}

TEST(ShapeDetection, FeetOnlyNeedsSoles) {
  BuiltWorld built(
      "[referee]\nenabled = false\n[robots.red.1]\nfile = \"robots/rappe.urdf\"\npose = [0, 0, 0]\n"
      "level = \"full\"\ncollision = \"feet_only\"\n");
  const auto said = built.complaints();
  ASSERT_EQ(said.size(), 1u);
  EXPECT_NE(said[0].find("the robot has no soles; expected bounding_spheres or primitives for it"), std::string::npos)
      << said[0];
}

// ----------------------------------------------------------------------------- a robot's own bodies

/// Depth of the deepest contact while the legs press on one another, and the angle at which the left one stops.
struct Press {
  double deepest = 0, angle = 0;
};
Press legsTogether(const std::string& rules) {
  Robots one({"multibody_dynamics"}, {}, rules);
  Press press;
  one.put(0, {{}, {0, 0, 3}});
  one.command(0, "hip_roll_left", -0.5);
  one.command(0, "hip_roll_right", 0.5);
  for (int i = 0; i < 500; ++i) {
    one.simulation().step();
    press.deepest = std::max(press.deepest, one.deepest());
  }
  const auto joints = one.simulation().world().members(one.robot(0), subset::kJoints);
  const ObjectId joint = one.simulation().world().find("robots.red.1.hip_roll_left");
  const auto at = std::find(joints.begin(), joints.end(), joint);
  press.angle = one.simulation()
                    .linked()
                    .handle(one.robot(0), kJointPosition, subset::kJoints)
                    .get(static_cast<int>(at - joints.begin()));
  return press;
}

TEST(SelfCollision, KeepsTheLegsApartWhereARuleWantsItAndOnlyThere) {
  const Press free = legsTogether(""), held = legsTogether("[contacts.own]\nself = \"robots.red.1\"\ncheck = true\n");
  EXPECT_EQ(free.deepest, 0);
  EXPECT_LT(free.angle, -0.45) << "nothing holds it";
  EXPECT_GT(held.deepest, 1e-5);
  EXPECT_LT(held.deepest, 5e-3);
  EXPECT_GT(held.angle, free.angle + 0.2);
}

TEST(SelfCollision, DoesNotMoveARobotThatFlies) {
  Robots one({"multibody_dynamics"}, {}, "[contacts.own]\nself = \"robots\"\ncheck = true\n");
  one.put(0, {{}, {0, 0, 3}});
  one.command(0, "hip_roll_left", -0.5);
  one.command(0, "hip_roll_right", 0.5);
  for (int i = 0; i < 2; ++i) one.simulation().step();
  const Vector3 before = one.momentum(0);
  for (int i = 0; i < 400; ++i) one.simulation().step();
  const Vector3 after = one.momentum(0);
  EXPECT_GT(one.simulation().pairs().counts().found, 0);
  EXPECT_NEAR(after.x, before.x, 2e-3);
  EXPECT_NEAR(after.y, before.y, 2e-3);
}

}  // namespace
}  // namespace murosimf::test
