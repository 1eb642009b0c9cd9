#include "murosimf/scene/scene.h"

#include <utility>

namespace murosimf {

client::FieldDescription fieldDescription(const Scene& scene) {
  const FieldSettings& field = scene.field;
  client::FieldDescription d;
  d.length = *field.length;
  d.width = *field.width;
  d.goal_width = *field.goal_width;
  d.goal_height = *field.goal_height;
  d.goal_depth = *field.goal_depth;
  d.post_radius = *field.post_radius;
  d.line_width = *field.line_width;
  d.border = *field.border;
  d.centre_circle_radius = *field.centre_circle_radius;
  d.goal_area_length = *field.goal_area_length;
  d.goal_area_width = *field.goal_area_width;
  d.penalty_mark_distance = *field.penalty_mark_distance;
  d.ball_radius = *scene.ball.radius;
  d.pole_radius = *field.pole_radius;
  d.pole_height = *field.pole_height;
  return d;
}

const SurfacePairSettings* findSurfacePair(const Scene& scene, std::string_view a, std::string_view b) {
  if (b < a) std::swap(a, b);
  for (const SurfacePairSettings& pair : scene.surfaces)
    if (pair.first == a && pair.second == b) return &pair;
  return nullptr;
}

}  // namespace murosimf
