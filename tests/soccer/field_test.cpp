#include "murosimf/soccer/field.h"

#include <gtest/gtest.h>

#include "soccer/free_ball_match.h"

namespace murosimf {
namespace {

double totalLength(const PaintedGround& ground) {
  double sum = 0;
  for (const auto& line : ground.lines) sum += norm(Vector3{line.b_x - line.a_x, line.b_y - line.a_y, 0});
  return sum;
}

/// A world with nothing but this field.
struct PaintedField {
  World world;
  std::vector<ObjectId> objects;
  explicit PaintedField(const client::FieldDescription& field) : objects(addField(world, field, {})) {}
  const PaintedGround& ground() const { return *world.findShared(world.root(), kGround); }
};

TEST(Field, LinesAreAsLongAsTheRulesDrawThem) {
  const client::FieldDescription f = smallField();
  const PaintedField field(f);
  // Each line is drawn half a width longer at both ends; marks are crosses of two strokes of two widths.
  const double border = 2 * f.length + 2 * f.width + 4 * f.line_width, halfway = f.width + f.line_width;
  const double goal_areas = 2 * (2 * f.goal_area_length + f.goal_area_width + 3 * f.line_width);
  const double marks = 2 * 4 * f.line_width;
  EXPECT_NEAR(totalLength(field.ground()), border + halfway + goal_areas + marks, 1e-12);
  ASSERT_EQ(field.ground().circles.size(), 1U);
}

TEST(Field, CarpetReachesTheBorderAroundTheLines) {
  const PaintedField field(smallField());
  EXPECT_DOUBLE_EQ(field.ground().half_length, 2.75);
  EXPECT_DOUBLE_EQ(field.ground().half_width, 2.0);
}

TEST(Field, LinesAreTheSameForBothTeams) {
  const PaintedField field(smallField());
  for (const auto& line : field.ground().lines) {
    bool found = false;  // the line turned by pi about the centre
    for (const auto& other : field.ground().lines) {
      const auto meets = [&](double a_x, double a_y, double b_x, double b_y) {
        return fabs(a_x + line.a_x) + fabs(a_y + line.a_y) + fabs(b_x + line.b_x) + fabs(b_y + line.b_y) < 1e-12;
      };
      found = found || meets(other.a_x, other.a_y, other.b_x, other.b_y) ||
              meets(other.b_x, other.b_y, other.a_x, other.a_y);
    }
    EXPECT_TRUE(found) << line.a_x << " " << line.a_y << " to " << line.b_x << " " << line.b_y;
  }
}

TEST(Field, GoalsLeaveTheInnerWidthAndHeightFree) {
  const client::FieldDescription f = smallField();
  const PaintedField field(f);
  for (const char* name : {"field.goal_plus_x", "field.goal_minus_x"}) {
    const ObjectId goal = field.world.find(name);
    ASSERT_TRUE(goal.valid()) << name;
    const Pose X_WG = *field.world.find(goal, kFixedPose);
    const double side = X_WG.rotation.x.x;
    EXPECT_NEAR(X_WG.translation.x, side * 2.25, 1e-12);
    const auto& shapes = *field.world.findShared(goal, kShapes);
    for (std::size_t post = 0; post < 2; ++post) {
      const Vector3 p = X_WG * shapes[post].X_BS.translation;
      EXPECT_NEAR(p.x, side * f.length / 2, 1e-12);
      EXPECT_NEAR(fabs(p.y) - f.post_radius, f.goal_width / 2, 1e-12);
    }
    EXPECT_NEAR(shapes[2].X_BS.translation.z - f.post_radius, f.goal_height, 1e-12);
  }
}

TEST(Field, NetsAreFeltAndNotSeen) {
  const PaintedField field(smallField());
  int nets = 0;
  for (const PlacedShape& shape : *field.world.findShared(field.world.find("field.goal_plus_x"), kShapes)) {
    EXPECT_TRUE(shape.collides);
    nets += shape.drawn ? 0 : 1;
  }
  EXPECT_EQ(nets, 3);
}

TEST(Field, PolesStandOnTheEndsOfTheHalfwayLineAndDifferInTheirColours) {
  const PaintedField field(smallField());
  const ObjectId left = field.world.find("field.pole_plus_y"), right = field.world.find("field.pole_minus_y");
  ASSERT_TRUE(left.valid() && right.valid());
  EXPECT_EQ(field.world.find(left, kFixedPose)->translation, (Vector3{0, 1.5, 0}));
  EXPECT_EQ(field.world.find(right, kFixedPose)->translation, (Vector3{0, -1.5, 0}));
  const auto& a = *field.world.findShared(left, kShapes);
  const auto& b = *field.world.findShared(right, kShapes);
  EXPECT_TRUE(a[0].colour == goalColour("yellow") && a[1].colour == goalColour("blue") && a[2].colour == a[0].colour);
  EXPECT_TRUE(b[0].colour == a[1].colour && b[1].colour == a[0].colour);
  EXPECT_NEAR(a[2].X_BS.translation.z + 0.1, 0.6, 1e-12);
}

TEST(Field, AFieldWithoutPolesHasNone) {
  client::FieldDescription f = smallField();
  f.pole_radius = 0;
  EXPECT_EQ(PaintedField(f).objects.size(), 2U);
}

}  // namespace
}  // namespace murosimf
