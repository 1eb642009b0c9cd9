#include "murosimf/scene/field_reader.h"

#include <fmt/format.h>

#include <algorithm>

#include "murosimf/scene/table_reader.h"

namespace murosimf {

namespace {

/// A size of field with everything on it [m]; as FieldSettings.
struct Preset {
  std::string_view name;
  double length, width, goal_width, goal_height, goal_depth, post_radius, line_width, border;
  double centre_circle_radius, goal_area_length, goal_area_width, penalty_area_length, penalty_area_width;
  double penalty_mark_distance, pole_radius, pole_height;
};

// 2007: humanoid kid-size field; goal and poles after the rules of 2009, which still used them. Where no text was
// found (circle, penalty mark, posts) the numbers are ours. 2025: RoboCup Humanoid League rules, KidSize and AdultSize.
// 2026: Humanoid Soccer League, draft of January 2026, fields S, M and L; its goal on S has 2.6 m in one table and 1.8
// m in another, height and depth of the goal on L are not in it: M's.
constexpr Preset kPresets[] = {
    {"2007", 4.5, 3.0, 1.5, .9, .5, .05, .05, .5, .6, 0, 0, 0, 0, 1.5, .10, .60},
    {"2025_kid", 9.0, 6.0, 2.6, 1.2, .6, .05, .05, 1.0, .75, 1.0, 3.0, 2.0, 5.0, 1.5, 0, 0},
    {"2025_adult", 14.0, 9.0, 2.6, 1.8, .6, .06, .05, 1.0, 1.5, 1.0, 4.0, 3.0, 6.0, 2.1, 0, 0},
    {"2026_small", 9.0, 6.0, 2.6, 1.2, .6, .05, .05, 1.0, .75, 1.0, 3.0, 2.0, 4.0, 1.5, 0, 0},
    {"2026_middle", 14.0, 9.0, 2.6, 1.8, .6, .06, .05, 1.0, 1.5, 1.0, 4.0, 3.0, 6.0, 2.0, 0, 0},
    {"2026_large", 22.0, 14.0, 2.4, 1.8, .6, .06, .12, 1.0, 2.0, 1.0, 5.0, 3.5, 7.0, 2.5, 0, 0},
};

struct Measure {
  const char* key;
  Located<double> FieldSettings::*member;
  double Preset::*preset;
};
constexpr Measure kMeasures[] = {
    {"length", &FieldSettings::length, &Preset::length},
    {"width", &FieldSettings::width, &Preset::width},
    {"goal_width", &FieldSettings::goal_width, &Preset::goal_width},
    {"goal_height", &FieldSettings::goal_height, &Preset::goal_height},
    {"goal_depth", &FieldSettings::goal_depth, &Preset::goal_depth},
    {"post_radius", &FieldSettings::post_radius, &Preset::post_radius},
    {"line_width", &FieldSettings::line_width, &Preset::line_width},
    {"border", &FieldSettings::border, &Preset::border},
    {"centre_circle_radius", &FieldSettings::centre_circle_radius, &Preset::centre_circle_radius},
    {"goal_area_length", &FieldSettings::goal_area_length, &Preset::goal_area_length},
    {"goal_area_width", &FieldSettings::goal_area_width, &Preset::goal_area_width},
    {"penalty_area_length", &FieldSettings::penalty_area_length, &Preset::penalty_area_length},
    {"penalty_area_width", &FieldSettings::penalty_area_width, &Preset::penalty_area_width},
    {"penalty_mark_distance", &FieldSettings::penalty_mark_distance, &Preset::penalty_mark_distance},
    {"pole_radius", &FieldSettings::pole_radius, &Preset::pole_radius},
    {"pole_height", &FieldSettings::pole_height, &Preset::pole_height},
};

void applyPreset(FieldSettings& field) {
  const auto* preset =
      std::find_if(std::begin(kPresets), std::end(kPresets), [&](const Preset& p) { return p.name == *field.preset; });
  const SourceLocation& where = field.preset.where;
  for (const Measure& m : kMeasures) field.*m.member = {preset->*m.preset, where};
  const bool coloured_goals = *field.preset == "2007";
  field.carpet = {{.09F, .38F, .14F}, where};
  field.goal_at_plus_x = {coloured_goals ? "yellow" : "white", where};
  field.goal_at_minus_x = {coloured_goals ? "blue" : "white", where};
}

/// A part of the field that must not be larger than the one around it.
void checkFits(const char* inner, const Located<double>& size, double factor, const char* outer,
               const Located<double>& room, Diagnostics& diagnostics) {
  if (factor * *size <= *room) return;
  const SourceLocation& where = size.given() ? size.where : room.where;
  diagnostics.error(where, fmt::format("{} is {} m, expected at most {} m, as {} is {} m", inner, *size, *room / factor,
                                       outer, *room));
}

void checkMeasures(const FieldSettings& field, Diagnostics& diagnostics) {
  checkFits("goal_width", field.goal_width, 1, "width", field.width, diagnostics);
  checkFits("goal_area_width", field.goal_area_width, 1, "width", field.width, diagnostics);
  checkFits("goal_area_length", field.goal_area_length, 2, "length", field.length, diagnostics);
  checkFits("penalty_area_width", field.penalty_area_width, 1, "width", field.width, diagnostics);
  checkFits("penalty_area_length", field.penalty_area_length, 2, "length", field.length, diagnostics);
  checkFits("penalty_mark_distance", field.penalty_mark_distance, 2, "length", field.length, diagnostics);
  checkFits("centre_circle_radius", field.centre_circle_radius, 2, "width", field.width, diagnostics);
  checkFits("centre_circle_radius", field.centre_circle_radius, 2, "length", field.length, diagnostics);
}

}  // namespace

FieldSettings readField(const TextNode* table, Diagnostics& diagnostics) {
  const TableReader reader(table, "field", diagnostics);
  reader.refuseUnknownKeys();
  FieldSettings field;
  reader.read("preset", field.preset);
  applyPreset(field);
  for (const Measure& m : kMeasures) reader.read(m.key, field.*m.member);
  reader.read("brightness", field.brightness);
  reader.read("carpet", field.carpet);
  reader.read("texture", field.texture);
  reader.read("texture_size", field.texture_size);
  reader.read("goal_at_plus_x", field.goal_at_plus_x);
  reader.read("goal_at_minus_x", field.goal_at_minus_x);
  checkMeasures(field, diagnostics);
  return field;
}

}  // namespace murosimf
