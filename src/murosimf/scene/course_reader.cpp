#include "murosimf/scene/course_reader.h"

#include <fmt/format.h>

#include <algorithm>

#include "murosimf/math/random.h"
#include "murosimf/math/transform.h"
#include "murosimf/scene/table_reader.h"

namespace murosimf {

namespace {

constexpr std::string_view kSection = "obstacles.NAME";
const std::string kAll = "all";

/// Lays what a table says over the obstacle.
void readOver(const TableReader& reader, ObstacleSettings& obstacle) {
  reader.read("shape", obstacle.shape);
  reader.read("radius", obstacle.radius);
  reader.read("length", obstacle.length);
  reader.read("width", obstacle.width);
  reader.read("height", obstacle.height);
  reader.read("pose", obstacle.pose);
  reader.read("colour", obstacle.colour);
  reader.read("mass", obstacle.mass);
  reader.read("surface", obstacle.surface);
}

ObstacleSettings readDefaults(const TextNode* table, Diagnostics& diagnostics) {
  const TextNode* all = table == nullptr ? nullptr : table->find(kAll);
  const TableReader reader(all, kSection, diagnostics, "obstacles.all");
  reader.refuseUnknownKeys();
  ObstacleSettings defaults;
  readOver(reader, defaults);
  if (defaults.pose.given())
    diagnostics.error(defaults.pose.where,
                      "pose stands among what all obstacles share, expected in a table of one obstacle");
  defaults.pose = {};
  return defaults;
}

/// A name becomes part of a path.
bool isPlainName(const std::string& name) {
  return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  });
}

void readOne(const TextNode& node, ObstacleSettings obstacle, std::vector<ObstacleSettings>& out,
             Diagnostics& diagnostics) {
  const std::string name = "obstacles." + printable(node.key);
  if (!isPlainName(node.key)) {
    diagnostics.error(node.key_where,
                      fmt::format("{} is no name of an obstacle, expected letters, digits and _", name));
    return;
  }
  const TableReader reader(&node, kSection, diagnostics, name);
  reader.refuseUnknownKeys();
  obstacle.name = node.key;
  obstacle.where = node.key_where;
  readOver(reader, obstacle);
  if (!obstacle.pose.given() && node.isTable() && node.find("pose") == nullptr)
    diagnostics.error(node.key_where, fmt::format("pose of {} is missing, expected pose = [x, y, heading]", name));
  out.push_back(std::move(obstacle));
}

struct Site {
  int along = 0, across = 0;
};

/// All sites, in the order of the seed [Fisher and Yates].
std::vector<Site> shuffledSites(const CourseSettings& course, std::uint64_t seed) {
  std::vector<Site> sites;
  for (int i = 1; i <= *course.sites_along; ++i) {
    for (int j = 1; j <= *course.sites_across; ++j) sites.push_back({i, j});
  }
  const RandomStream random(seed, "course", 0);
  for (std::size_t n = sites.size(); n > 1; --n) {
    const auto other = static_cast<std::size_t>(random.uniform(n) * static_cast<double>(n));
    std::swap(sites[n - 1], sites[other]);
  }
  return sites;
}

void addRandom(const CourseSettings& course, std::uint64_t seed, const ObstacleSettings& like,
               std::vector<ObstacleSettings>& out) {
  std::vector<int> abreast(static_cast<std::size_t>(*course.sites_along) + 1, 0);
  int count = 0;
  for (const Site& site : shuffledSites(course, seed)) {
    if (count == *course.random_obstacles) return;
    int& beside = abreast[static_cast<std::size_t>(site.along)];
    if (beside == *course.most_abreast) continue;
    ++beside;
    ObstacleSettings& obstacle = out.emplace_back(like);
    obstacle.name = fmt::format("random_{}", ++count);
    obstacle.where = course.random_obstacles.where;
    const Vector3 p_CO{*course.length * site.along / (*course.sites_along + 1),
                       *course.width * (static_cast<double>(site.across) / (*course.sites_across + 1) - 0.5), 0};
    const Vector3 p_WO = toPose(*course.pose) * p_CO;
    obstacle.pose = {{p_WO.x, p_WO.y, course.pose->heading}, course.random_obstacles.where};
  }
}

void checkRandom(const CourseSettings& course, Diagnostics& diagnostics) {
  const int most = *course.sites_along * std::min(*course.sites_across, *course.most_abreast);
  if (*course.random_obstacles > most)
    diagnostics.error(course.random_obstacles.where,
                      fmt::format("random_obstacles is {}, expected at most {}: {} rows of {}",
                                  *course.random_obstacles, most, *course.sites_along, most / *course.sites_along));
  if (*course.random_obstacles > 0 && (*course.length <= 0 || *course.width <= 0))
    diagnostics.error(course.random_obstacles.where,
                      "random_obstacles need a course with a length and a width of more than 0 m");
}

}  // namespace

CourseSettings readCourse(const TextNode* table, Diagnostics& diagnostics) {
  const TableReader reader(table, "course", diagnostics);
  reader.refuseUnknownKeys();
  CourseSettings course;
  reader.read("pose", course.pose);
  reader.read("length", course.length);
  reader.read("width", course.width);
  reader.read("first_side", course.first_side);
  reader.read("random_obstacles", course.random_obstacles);
  reader.read("sites_along", course.sites_along);
  reader.read("sites_across", course.sites_across);
  reader.read("most_abreast", course.most_abreast);
  checkRandom(course, diagnostics);
  return course;
}

std::vector<ObstacleSettings> readObstacles(const TextNode* table, const CourseSettings& course, std::uint64_t seed,
                                            Diagnostics& diagnostics) {
  std::vector<ObstacleSettings> obstacles;
  TableReader(table, "obstacles", diagnostics);  // reports what is no table
  const ObstacleSettings defaults = readDefaults(table, diagnostics);
  if (table != nullptr && table->isTable()) {
    for (const TextNode& node : table->children) {
      if (node.key != kAll) readOne(node, defaults, obstacles, diagnostics);
    }
  }
  addRandom(course, seed, defaults, obstacles);
  std::stable_sort(obstacles.begin(), obstacles.end(),
                   [](const ObstacleSettings& a, const ObstacleSettings& b) { return a.name < b.name; });
  for (std::size_t i = 1; i < obstacles.size(); ++i) {
    if (obstacles[i].name != obstacles[i - 1].name) continue;
    diagnostics.error(
        obstacles[i - 1].where,
        fmt::format("obstacles.{} is also the name of a random obstacle, expected another name", obstacles[i].name));
  }
  return obstacles;
}

}  // namespace murosimf
