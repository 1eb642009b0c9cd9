// What acts from outside acts at the beginning of its frame, in one order.

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "simulation/walking_team.h"

namespace murosimf::team {
namespace {

std::vector<Member> standing() { return {{"robots.red.1", {1, 1, 0}, {}, 0}, {"robots.blue.1", {-1, 1, 0}, {}, 0}}; }

TEST(FrameInterventions, ActAtTheBeginningOfTheirFrame) {
  WalkingTeam team(standing());
  const ObjectId ball = team.simulation().participants().free_bodies[0];
  team.simulation().interventions().placeBody(5, ball, {0, 0, 3});
  team.frames(5);
  EXPECT_LT(team.ball().translation.z, 0.1);
  team.frame();
  EXPECT_NEAR(team.ball().translation.z, 3 - 0.5 * 9.81e-6, 1e-9);  // has fallen for one frame
}

TEST(FrameInterventions, TheLastRequestForAnObjectWins) {
  WalkingTeam team(standing());
  InterventionQueue& queue = team.simulation().interventions();
  queue.placeRobot(20, team.robot(0), {2, 0, 0});
  queue.placeRobot(20, team.robot(0), {2, 1, 0.5});
  team.frames(21);
  EXPECT_NEAR(team.base(0).translation.x, 2, 1e-12);
  EXPECT_NEAR(team.base(0).translation.y, 1, 1e-12);
}

TEST(FrameInterventions, AreAppliedInTheOrderOfFramesAndNames) {
  WalkingTeam team(standing(), {.ball = false});
  InterventionQueue& queue = team.simulation().interventions();
  queue.placeRobot(8, team.robot(0), {2, 0, 0});  // red
  queue.placeRobot(7, team.robot(0), {2, 1, 0});
  queue.placeRobot(8, team.robot(1), {-2, 0, 0});  // blue: before red by name
  team.frames(8);
  ASSERT_EQ(queue.applied().size(), 1U);
  EXPECT_EQ(queue.applied()[0].frame, 7);
  team.frames(1);
  ASSERT_EQ(queue.applied().size(), 2U);
  EXPECT_EQ(queue.applied()[0].intervention.object, team.robot(1));
  EXPECT_EQ(queue.applied()[1].intervention.object, team.robot(0));
}

TEST(FrameInterventions, TheOrderOfRequestsForDifferentObjectsDoesNotMatter) {
  const auto run = [](bool turned) {
    WalkingTeam team(standing());
    InterventionQueue& queue = team.simulation().interventions();
    const auto red = [&] { queue.placeRobot(30, team.robot(0), {0.2, 0.1, 0.3}); };
    const auto blue = [&] { queue.placeRobot(30, team.robot(1), {0.6, -0.1, 0.1}); };
    turned ? (blue(), red()) : (red(), blue());
    team.frames(300);
    return team.simulation().stateHash();
  };
  EXPECT_EQ(run(true), run(false));
}

TEST(FrameInterventions, NumbersThatAreNoneAndObjectsThatCannotBePlacedAreRefused) {
  WalkingTeam team(standing());
  InterventionQueue& queue = team.simulation().interventions();
  EXPECT_THROW(queue.placeRobot(1, team.robot(0), {NAN, 0, 0}), std::invalid_argument);
  EXPECT_THROW(queue.placeBody(1, team.simulation().participants().free_bodies[0], {0, 0, 1}, {0, INFINITY, 0}),
               std::invalid_argument);
  EXPECT_THROW(queue.placeRobot(1, ObjectId{}, {}), std::invalid_argument);
  EXPECT_THROW(queue.placeBody(1, team.robot(0), {}), std::invalid_argument);
}

}  // namespace
}  // namespace murosimf::team
