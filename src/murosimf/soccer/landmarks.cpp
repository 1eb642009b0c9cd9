#include "murosimf/soccer/landmarks.h"

#include "murosimf/math/elementary.h"

namespace murosimf {

namespace {

Landmark upright(SightKind kind, ObjectId object, const Vector3& foot, double height, const std::string& mark) {
  Landmark landmark;
  landmark.kind = kind, landmark.object = object;
  landmark.a = foot, landmark.b = foot + Vector3{0, 0, height};
  landmark.mark = mark;
  return landmark;
}

void addLine(std::vector<Landmark>& out, double a_x, double a_y, double b_x, double b_y) {
  Landmark& line = out.emplace_back();
  line.kind = SightKind::kLine;
  line.a = {a_x, a_y, 0}, line.b = {b_x, b_y, 0};
}

void addGoal(std::vector<Landmark>& out, ObjectId goal, const client::FieldDescription& f, const std::string& colour) {
  const double y = f.goal_width / 2 + f.post_radius;
  for (int i = 0; i < 2; ++i) {
    Landmark post = upright(SightKind::kPost, goal, {0, i == 0 ? y : -y, 0}, f.goal_height, colour);
    post.shape = i;
    out.push_back(post);
  }
}

/// Three lines around a goal line's middle; side +1 or -1.
void addArea(std::vector<Landmark>& out, const client::FieldDescription& f, double side, double length, double width) {
  if (!(length > 0 && width > 0)) return;
  const double goal_line = side * f.length / 2, front = goal_line - side * length, half = width / 2;
  addLine(out, goal_line, -half, front, -half);
  addLine(out, front, -half, front, half);
  addLine(out, front, half, goal_line, half);
}

void addCircle(std::vector<Landmark>& out, double radius) {
  for (int i = 0; radius > 0 && i < kCircleChords; ++i) {
    const SinCos<double> a = sincos(2 * kPi * i / kCircleChords), b = sincos(2 * kPi * (i + 1) / kCircleChords);
    addLine(out, radius * a.cos, radius * a.sin, radius * b.cos, radius * b.sin);
  }
}

}  // namespace

std::vector<Landmark> fieldLandmarks(const std::vector<ObjectId>& objects, const client::FieldDescription& f,
                                     const FieldLook& look) {
  std::vector<Landmark> out;
  addGoal(out, objects[0], f, look.goal_at_plus_x);
  addGoal(out, objects[1], f, look.goal_at_minus_x);
  if (objects.size() > 3) {
    out.push_back(upright(SightKind::kPole, objects[2], {}, f.pole_height, "yellow"));
    out.push_back(upright(SightKind::kPole, objects[3], {}, f.pole_height, "blue"));
  }
  const double x = f.length / 2, y = f.width / 2;
  for (const double side : {-1.0, 1.0}) {
    addLine(out, -x, side * y, x, side * y);
    addLine(out, side * x, -y, side * x, y);
    addArea(out, f, side, f.goal_area_length, f.goal_area_width);
    addArea(out, f, side, f.penalty_area_length, f.penalty_area_width);
  }
  addLine(out, 0, -y, 0, y);
  addCircle(out, f.centre_circle_radius);
  return out;
}

}  // namespace murosimf
