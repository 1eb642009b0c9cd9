// Objects, their names, groups and constants.

#include "murosimf/world/world.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "murosimf/world/surface_table.h"

namespace murosimf {
namespace {

constexpr Constant<double> kMassOf{"mass", "kg", "m > 0"};
constexpr Constant<Vector3> kCentre{"centre", "m", "of mass"};
constexpr Constant<std::string> kPaint{"paint", "", "name of a colour"};

TEST(World, PathsAreDottedAndFound) {
  World world;
  const ObjectId robot = world.addPath("robots.red.1"), trunk = world.add(robot, "trunk");
  EXPECT_EQ(world.path(trunk), "robots.red.1.trunk");
  EXPECT_EQ(world.find("robots.red.1.trunk"), trunk);
  EXPECT_EQ(world.addPath("robots.red.1"), robot);
  EXPECT_EQ(world.parent(robot), world.find("robots.red"));
  EXPECT_FALSE(world.find("robots.blue").valid());
  EXPECT_EQ(world.find(""), world.root());
}

TEST(World, NamesAreUniqueAndNotEmpty) {
  World world;
  world.add(world.root(), "ball");
  EXPECT_THROW(world.add(world.root(), "ball"), std::invalid_argument);
  EXPECT_THROW(world.add(world.root(), ""), std::invalid_argument);
  EXPECT_THROW(world.path(ObjectId{99}), std::out_of_range);
}

TEST(World, ConstantsKeepTheirTypeAndPlace) {
  World world;
  const ObjectId ball = world.addPath("ball");
  world.set(ball, kMassOf, 0.2, {"game.toml", 4, 8});
  world.set(ball, kMassOf, 0.3, {"game.toml", 5, 8});
  EXPECT_EQ(world.find(ball, kMassOf), 0.3);
  EXPECT_EQ(world.findEntry(ball, "mass")->where.line, 5);
  EXPECT_EQ(world.find(ball, Constant<Vector3>{"mass", "", ""}), std::nullopt);
  EXPECT_EQ(world.find(ball, kCentre), std::nullopt);
}

TEST(World, WrittenValuesBecomeWhatTheReaderAsksFor) {
  World world;
  const ObjectId ball = world.addPath("ball");
  world.setWritten(ball, "mass", {{0.25}, ""}, {});
  world.setWritten(ball, "centre", {{1, 2, 3}, ""}, {});
  world.setWritten(ball, "paint", {{}, "orange"}, {});
  EXPECT_EQ(world.find(ball, kMassOf), 0.25);
  EXPECT_EQ(world.find(ball, kCentre), (Vector3{1, 2, 3}));
  EXPECT_EQ(world.find(ball, kPaint), "orange");
  EXPECT_EQ(world.find(ball, Constant<double>{"centre", "", ""}), std::nullopt);
  EXPECT_EQ(world.find(ball, Constant<std::string>{"mass", "", ""}), std::nullopt);
  EXPECT_EQ(world.find(ball, Constant<Vector3>{"mass", "", ""}), std::nullopt);
}

TEST(World, GroupsKeepTheirOrderAndEveryObjectIsItsOwnGroup) {
  World world;
  const ObjectId robot = world.addPath("robot"), b = world.add(robot, "b"), a = world.add(robot, "a");
  world.defineSubset(robot, "joints", {b, a});
  ASSERT_EQ(world.members(robot, "joints").size(), 2U);
  EXPECT_EQ(world.members(robot, "joints")[0], b);
  EXPECT_EQ(world.members(robot, subset::kSelf)[0], robot);
  EXPECT_TRUE(world.members(robot, "wheels").empty());
}

TEST(Diagnostics, AreSortedByPlaceAndCounted) {
  Diagnostics diagnostics;
  diagnostics.error({"b.toml", 9, 2}, "late");
  diagnostics.warning({"b.toml", 3, 0}, "early");
  diagnostics.error({}, "nowhere");
  EXPECT_EQ(diagnostics.text(), "error: nowhere\nb.toml:3: warning: early\nb.toml:9:2: error: late\n");
  EXPECT_EQ(diagnostics.errorCount(), 2);
}

TEST(Diagnostics, SuggestTheNearestWordOrNothing) {
  EXPECT_EQ(didYouMean("mas", {"mass", "length"}), " (did you mean \"mass\"?)");
  EXPECT_EQ(didYouMean("lenght", {"mass", "length"}), " (did you mean \"length\"?)");
  EXPECT_EQ(didYouMean("colour", {"mass", "length"}), "");
  EXPECT_EQ(didYouMean("x", {}), "");
}

TEST(SurfaceTable, APairHasOneEntryInEitherOrder) {
  SurfaceTable table;
  SurfacePair pair;
  pair.stiffness = 5;
  table.set("turf", "ball", pair);
  ASSERT_NE(table.find("ball", "turf"), nullptr);
  EXPECT_EQ(table.find("ball", "turf")->stiffness, 5);
  pair.stiffness = 6;
  table.set("ball", "turf", pair);
  EXPECT_EQ(table.find("turf", "ball")->stiffness, 6);
  EXPECT_EQ(table.find("ball", "post"), nullptr);
}

}  // namespace
}  // namespace murosimf
