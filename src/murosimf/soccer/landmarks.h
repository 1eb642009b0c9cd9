#pragma once

/// @file What oracles may tell of the field of play: goal posts, landmark poles, lines.

#include <vector>

#include "murosimf/modules/camera/landmark.h"
#include "murosimf/soccer/field.h"

namespace murosimf {

/// The centre circle is told as so many straight pieces, each 5 mm off the arc at most.
inline constexpr int kCircleChords = 24;

/// Posts and poles from foot to top, marked by the goal's colour and by that of the pole's top; middles of lines, in W.
/// Penalty marks are left out.
/// @param objects  what addField() gave for the same field and look
std::vector<Landmark> fieldLandmarks(const std::vector<ObjectId>& objects, const client::FieldDescription& field,
                                     const FieldLook& look);

}  // namespace murosimf
