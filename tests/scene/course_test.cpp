// What stands in the way, and the course around it, as scenarios say them.

#include <cmath>

#include "scene/scenario_for_test.h"

namespace murosimf::test {
namespace {

const std::string kRunner = "[robots.red.1]\nfile = \"robots/ks21.urdf\"\npose = [-1, 0, 0]\n";

TEST(Obstacles, HaveWhatAllHaveAndWhatIsTheirs) {
  const Scene scene = readGood(kRunner +
                               "[obstacles.all]\nradius = 0.2\nheight = 1\n[obstacles.b]\npose = [1, 0.5, {deg = 90}]\n"
                               "[obstacles.a]\npose = [0, 0, 0]\nradius = 0.05\nmass = 2\n");
  ASSERT_EQ(scene.obstacles.size(), 2U);
  EXPECT_EQ(scene.obstacles[0].name, "a");
  EXPECT_EQ(*scene.obstacles[0].radius, 0.05);
  EXPECT_EQ(*scene.obstacles[0].mass, 2);
  EXPECT_EQ(*scene.obstacles[1].radius, 0.2);
  EXPECT_EQ(*scene.obstacles[1].height, 1);
  EXPECT_NEAR(scene.obstacles[1].pose->heading, kPi / 2, 1e-12);
}

TEST(Obstacles, ReachAsFarAsTheirCorners) {
  const Scene scene =
      readGood(kRunner + "[obstacles.a]\nshape = \"box\"\nlength = 0.3\nwidth = 0.4\npose = [0, 0, 0]\n");
  EXPECT_NEAR(scene.obstacles[0].reach(), 0.25, 1e-12);
}

TEST(Obstacles, MistakesAreToldWithTheirPlace) {
  EXPECT_EQ(complaints(kRunner + "[obstacles.a]\nradius = 0.1\n"),
            std::vector<std::string>{"4:12: pose of obstacles.a is missing, expected pose = [x, y, heading]"});
  EXPECT_EQ(complaints(kRunner + "[obstacles.\"a b\"]\npose = [0, 0, 0]\n"),
            std::vector<std::string>{"4:12: obstacles.a b is no name of an obstacle, expected letters, digits and _"});
  EXPECT_EQ(
      complaints(kRunner + "[obstacles.all]\npose = [0, 0, 0]\n"),
      std::vector<std::string>{"5:8: pose stands among what all obstacles share, expected in a table of one obstacle"});
}

TEST(Course, RandomObstaclesNeedRoom) {
  EXPECT_EQ(complaints(kRunner + "[course]\nlength = 3\nwidth = 1.5\nrandom_obstacles = 7\n"),
            std::vector<std::string>{"7:20: random_obstacles is 7, expected at most 6: 3 rows of 2"});
  EXPECT_EQ(
      complaints(kRunner + "[course]\nlength = 3\nrandom_obstacles = 2\n"),
      std::vector<std::string>{"6:20: random_obstacles need a course with a length and a width of more than 0 m"});
}

TEST(Trial, NeedsSomethingToJudge) {
  EXPECT_EQ(complaints(kRunner + "[referee]\nrules = \"slalom\"\n"),
            std::vector<std::string>{
                "5:9: rules are \"slalom\", and there is no course, expected [course] with a length of more than 0 m"});
  EXPECT_EQ(
      complaints(kRunner + "[ball]\npresent = false\n[referee]\nrules = \"penalty_kicks\"\n"),
      std::vector<std::string>{"7:9: rules are \"penalty_kicks\", and there is no ball, expected ball.present = true"});
  EXPECT_EQ(complaints(kRunner + "[referee]\nrules = \"penalty_kicks\"\nkickoff_team = \"blue\"\n"),
            std::vector<std::string>{"5:9: rules are \"penalty_kicks\", and there is no robot of team blue to make the "
                                     "attempts, expected one, or another kickoff_team"});
}

TEST(Course, IsTurnedForTheTeamThatAttacksMinusX) {
  const Scene scene = readGood(kRunner + "[course]\npose = [1, 0.5, 0]\nlength = 2\n");
  const client::CourseDescription blue = courseDescription(scene, false);
  EXPECT_NEAR(blue.X_FC.x, -1, 1e-12);
  EXPECT_NEAR(blue.X_FC.y, -0.5, 1e-12);
  EXPECT_NEAR(std::fabs(blue.X_FC.heading), kPi, 1e-12);
}

}  // namespace
}  // namespace murosimf::test
