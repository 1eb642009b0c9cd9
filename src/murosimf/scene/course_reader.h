#pragma once

/// @file What stands in the way, and the course of a slalom or an obstacle run.

#include <cstdint>
#include <vector>

#include "murosimf/scene/scene.h"
#include "murosimf/scene/text_tree.h"

namespace murosimf {

/// @param table [course]; nullptr: there is none
CourseSettings readCourse(const TextNode* table, Diagnostics& diagnostics);

/// All obstacles by name, with what [obstacles.all] says of them, and the course's random ones, "random_1", ...
/// Random sites: x = length i / (sites_along + 1), y = width (j / (sites_across + 1) - 1/2) in the course's frame, i
/// and j from 1; a row of one i takes most_abreast at most. The seed puts all sites into an order, and they are filled
/// so.
std::vector<ObstacleSettings> readObstacles(const TextNode* table, const CourseSettings& course, std::uint64_t seed,
                                            Diagnostics& diagnostics);

}  // namespace murosimf
