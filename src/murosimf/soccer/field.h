#pragma once

/// @file The field of play: carpet and lines, goals, landmark poles.
///
/// Frame W: origin at the centre, +x along the longer side, z up. The poles stand on the ends of the halfway line: the
/// one at +y shows yellow, blue, yellow from the top, the other blue, yellow, blue.

#include <string>
#include <vector>

#include "murosimf/algorithms/ray_scene.h"
#include "murosimf/control/client/robot_description.h"
#include "murosimf/world/world.h"

namespace murosimf {

struct FieldLook {
  double brightness = 1;  ///< of the light on the ground
  Colour carpet{0.13F, 0.47F, 0.19F};
  std::shared_ptr<const GroundTexture> texture{};                   ///< in the place of the carpet's colour
  double texture_size = 0;                                          ///< [m], as PaintedGround has it
  std::string goal_at_plus_x = "yellow", goal_at_minus_x = "blue";  ///< or "white"
};

/// Sets the world's ground and adds the fixed objects. Surfaces: posts, bars and poles "post". The nets behind the
/// goals stop the ball and are not drawn: one looks through them. @returns the objects added
std::vector<ObjectId> addField(World& world, const client::FieldDescription& field, const FieldLook& look);

/// Yellow, blue or white.
Colour goalColour(const std::string& name);

}  // namespace murosimf
