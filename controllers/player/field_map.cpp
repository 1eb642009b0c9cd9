#include "field_map.h"

#include <algorithm>
#include <cmath>

namespace murosimf::controllers {
namespace {

constexpr double kNormalAgreement = 0.82;  // cosine of the largest angle between seen and painted normal: 35 degrees
constexpr double kOverrun = 0.15;          // how far beyond its end a line may still be seen [m]

}  // namespace

void FieldMap::start(const client::RobotDescription& robot) {
  const client::FieldDescription& field = robot.field;
  half_length_ = 0.5 * field.length, half_width_ = 0.5 * field.width;
  border_ = field.border, circle_radius_ = field.centre_circle_radius;
  const std::size_t attacked = robot.goal_colour_attacked == "blue" ? 1 : 0;
  const double post_y = 0.5 * field.goal_width + field.post_radius;
  posts_[attacked] = {Point{half_length_, post_y}, Point{half_length_, -post_y}};
  posts_[1 - attacked] = {Point{-half_length_, post_y}, Point{-half_length_, -post_y}};
  has_poles_ = field.pole_height > 0;
  const double yellow_side = robot.attacks_positive_x ? 1 : -1;
  poles_ = {Point{0, yellow_side * half_width_}, Point{0, -yellow_side * half_width_}};
  line_count_ = 0;
  for (const double side : {-1.0, 1.0}) {
    addLine(true, side * half_width_, -half_length_, half_length_);
    addLine(false, side * half_length_, -half_width_, half_width_);
    addArea(side, field.goal_area_length, field.goal_area_width);
    addArea(side, field.penalty_area_length, field.penalty_area_width);
  }
  addLine(false, 0, -half_width_, half_width_);
}

void FieldMap::addLine(bool along_x, double offset, double first, double last) {
  lines_[line_count_++] = {along_x, offset, std::min(first, last), std::max(first, last)};
}

void FieldMap::addArea(double side, double length, double width) {
  if (!(length > 0 && width > 0)) return;
  const double y = 0.5 * width, x = side * (half_length_ - length);
  addLine(false, x, -y, y);
  addLine(true, -y, x, side * half_length_);
  addLine(true, y, x, side * half_length_);
}

std::span<const Point> FieldMap::landmarks(LandmarkKind kind, LandmarkColour colour) const {
  const auto index = static_cast<std::size_t>(colour);
  if (kind == LandmarkKind::kPost) return posts_[index];
  return {&poles_[index], has_poles_ ? std::size_t{1} : std::size_t{0}};
}

LineMatch FieldMap::nearestLine(const Point& p_F, const Point& normal) const {
  LineMatch best;
  for (const Line& line : std::span(lines_).first(line_count_)) {
    const double across = line.along_x ? p_F.y : p_F.x, along = line.along_x ? p_F.x : p_F.y;
    if (along < line.first - kOverrun || along > line.last + kOverrun) continue;
    if (std::fabs(line.along_x ? normal.y : normal.x) < kNormalAgreement) continue;
    const double offset = across - line.offset;
    if (best.found && std::fabs(offset) >= std::fabs(best.offset)) continue;
    best = {true, offset, line.along_x ? Point{0, 1} : Point{1, 0}};
  }
  matchCircle(p_F, normal, best);
  return best;
}

void FieldMap::matchCircle(const Point& p_F, const Point& normal, LineMatch& best) const {
  const double radius = norm(p_F);
  if (!(circle_radius_ > 0) || radius < 0.3 * circle_radius_) return;
  const Point radial = (1 / radius) * p_F;
  const double offset = radius - circle_radius_;
  if (std::fabs(dot(radial, normal)) < kNormalAgreement) return;
  if (!best.found || std::fabs(offset) < std::fabs(best.offset)) best = {true, offset, radial};
}

bool FieldMap::contains(const Point& p_F, double margin) const {
  return std::fabs(p_F.x) <= half_length_ + margin && std::fabs(p_F.y) <= half_width_ + margin;
}

Point FieldMap::nearestOnCarpet(const Point& p_F) const {
  const double x = half_length_ + border_, y = half_width_ + border_;
  return {std::clamp(p_F.x, -x, x), std::clamp(p_F.y, -y, y)};
}

}  // namespace murosimf::controllers
