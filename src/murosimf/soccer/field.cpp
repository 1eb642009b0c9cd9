#include "murosimf/soccer/field.h"

#include "murosimf/world/vocabulary.h"

namespace murosimf {

namespace {

constexpr Colour kYellow{0.92F, 0.80F, 0.10F}, kBlue{0.12F, 0.22F, 0.75F}, kWhite{0.92F, 0.92F, 0.92F};
constexpr double kNetThickness = 0.04;  // [m]

void addLine(PaintedGround& ground, double a_x, double a_y, double b_x, double b_y, double width) {
  // Half a width longer at both ends, so that corners are whole.
  const double length = sqrt((b_x - a_x) * (b_x - a_x) + (b_y - a_y) * (b_y - a_y));
  const double x = (b_x - a_x) / length * width / 2, y = (b_y - a_y) / length * width / 2;
  ground.lines.push_back({a_x - x, a_y - y, b_x + x, b_y + y, width});
}

/// A rectangle of lines from one corner to the opposite one.
void addRectangle(PaintedGround& ground, double x0, double y0, double x1, double y1, double width) {
  addLine(ground, x0, y0, x1, y0, width);
  addLine(ground, x1, y0, x1, y1, width);
  addLine(ground, x1, y1, x0, y1, width);
  addLine(ground, x0, y1, x0, y0, width);
}

/// Three lines around a goal line's middle; side +1 or -1.
void addArea(PaintedGround& ground, const client::FieldDescription& f, double side, double length, double width) {
  if (!(length > 0 && width > 0)) return;
  const double goal_line = side * f.length / 2, front = goal_line - side * length, half = width / 2, w = f.line_width;
  addLine(ground, goal_line, -half, front, -half, w);
  addLine(ground, front, -half, front, half, w);
  addLine(ground, front, half, goal_line, half, w);
}

/// The lines before one goal; side +1 or -1.
void addGoalLines(PaintedGround& ground, const client::FieldDescription& f, double side) {
  const double goal_line = side * f.length / 2, w = f.line_width;
  addArea(ground, f, side, f.goal_area_length, f.goal_area_width);
  addArea(ground, f, side, f.penalty_area_length, f.penalty_area_width);
  if (f.penalty_mark_distance > 0) {
    const double x = goal_line - side * f.penalty_mark_distance;
    ground.lines.push_back({x - w, 0, x + w, 0, w});
    ground.lines.push_back({x, -w, x, w, w});
  }
}

PaintedGround groundOf(const client::FieldDescription& f, const FieldLook& look) {
  PaintedGround ground;
  ground.half_length = f.length / 2 + f.border;
  ground.half_width = f.width / 2 + f.border;
  ground.carpet = look.carpet;
  ground.texture = look.texture, ground.texture_size = look.texture_size;
  ground.brightness = static_cast<float>(look.brightness);
  const double x = f.length / 2, y = f.width / 2;
  addRectangle(ground, -x, -y, x, y, f.line_width);
  addLine(ground, 0, -y, 0, y, f.line_width);
  ground.circles.push_back({0, 0, f.centre_circle_radius, f.line_width});
  addGoalLines(ground, f, 1);
  addGoalLines(ground, f, -1);
  return ground;
}

PlacedShape part(const Shape& shape, const Rotation3& R_BS, const Vector3& p_BS, const Colour& colour) {
  return {0, {R_BS, p_BS}, shape, colour, "post", true, true};
}

/// Posts and bar, drawn; net, only felt. Frame of the goal: on the ground in the middle of the goal line, x outwards.
std::vector<PlacedShape> goalShapes(const client::FieldDescription& f, const Colour& colour) {
  const double y = f.goal_width / 2 + f.post_radius, r = f.post_radius, h = f.goal_height;
  std::vector<PlacedShape> shapes{part(makeCylinder(r, h + 2 * r), {}, {0, y, h / 2 + r}, colour),
                                  part(makeCylinder(r, h + 2 * r), {}, {0, -y, h / 2 + r}, colour),
                                  part(makeCylinder(r, 2 * y), rotationX(kPi / 2), {0, 0, h + r}, colour)};
  const auto net = [&](const Vector3& edges, const Vector3& centre) {
    PlacedShape s = part(makeBox(edges), {}, centre, colour);
    s.drawn = false;
    shapes.push_back(s);
  };
  net({kNetThickness, 2 * y, h}, {f.goal_depth, 0, h / 2});
  net({f.goal_depth, kNetThickness, h}, {f.goal_depth / 2, y, h / 2});
  net({f.goal_depth, kNetThickness, h}, {f.goal_depth / 2, -y, h / 2});
  return shapes;
}

std::vector<PlacedShape> poleShapes(const client::FieldDescription& f, const Colour& outer, const Colour& middle) {
  std::vector<PlacedShape> shapes;
  const double segment = f.pole_height / 3;
  for (int i = 0; i < 3; ++i) {
    shapes.push_back(
        part(makeCylinder(f.pole_radius, segment), {}, {0, 0, (i + 0.5) * segment}, i == 1 ? middle : outer));
  }
  return shapes;
}

ObjectId addObject(World& world, const std::string& path, const Pose& X_WB, std::vector<PlacedShape> shapes) {
  const ObjectId id = world.addPath(path);
  world.set(id, kFixedPose, X_WB);
  world.set(id, kShapes, std::move(shapes));
  return id;
}

}  // namespace

Colour goalColour(const std::string& name) { return name == "yellow" ? kYellow : name == "blue" ? kBlue : kWhite; }

std::vector<ObjectId> addField(World& world, const client::FieldDescription& f, const FieldLook& look) {
  world.set(world.root(), kGround, groundOf(f, look));
  std::vector<ObjectId> added;
  added.push_back(addObject(world, "field.goal_plus_x", toPose({f.length / 2, 0, 0}),
                            goalShapes(f, goalColour(look.goal_at_plus_x))));
  added.push_back(addObject(world, "field.goal_minus_x", toPose({-f.length / 2, 0, kPi}),
                            goalShapes(f, goalColour(look.goal_at_minus_x))));
  if (f.pole_radius > 0 && f.pole_height > 0) {
    const double y = f.width / 2;
    added.push_back(addObject(world, "field.pole_plus_y", toPose({0, y, 0}), poleShapes(f, kYellow, kBlue)));
    added.push_back(addObject(world, "field.pole_minus_y", toPose({0, -y, 0}), poleShapes(f, kBlue, kYellow)));
  }
  return added;
}

}  // namespace murosimf
