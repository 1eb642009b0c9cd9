#include "murosimf/scene/field_reader.h"

#include <fmt/format.h>

#include "murosimf/scene/table_reader.h"

namespace murosimf {

namespace {

struct Measure {
  const char* key;
  Located<double> FieldSettings::*member;
  double of_2007, of_2025_kid;
};

// 2007: humanoid kid-size field; goal and poles after the rules of 2009, which still used them. Where no text was
// found (circle, penalty mark, posts) the numbers are ours. 2025: RoboCup Humanoid League rules, KidSize.
constexpr Measure kMeasures[] = {
    {"length", &FieldSettings::length, 4.5, 9.0},
    {"width", &FieldSettings::width, 3.0, 6.0},
    {"goal_width", &FieldSettings::goal_width, 1.5, 2.6},
    {"goal_height", &FieldSettings::goal_height, .9, 1.2},
    {"goal_depth", &FieldSettings::goal_depth, .5, .6},
    {"post_radius", &FieldSettings::post_radius, .05, .05},
    {"line_width", &FieldSettings::line_width, .05, .05},
    {"border", &FieldSettings::border, .5, 1.0},
    {"centre_circle_radius", &FieldSettings::centre_circle_radius, .6, .75},
    {"goal_area_length", &FieldSettings::goal_area_length, 0, 1.0},
    {"goal_area_width", &FieldSettings::goal_area_width, 0, 3.0},
    {"penalty_mark_distance", &FieldSettings::penalty_mark_distance, 1.5, 1.5},
    {"pole_radius", &FieldSettings::pole_radius, .10, 0},
    {"pole_height", &FieldSettings::pole_height, .60, 0},
};

void applyPreset(FieldSettings& field) {
  const bool is_2025 = *field.preset == "2025_kid";
  const SourceLocation& where = field.preset.where;
  for (const Measure& m : kMeasures) field.*m.member = {is_2025 ? m.of_2025_kid : m.of_2007, where};
  field.carpet = {{.09F, .38F, .14F}, where};
  field.goal_at_plus_x = {is_2025 ? "white" : "yellow", where};
  field.goal_at_minus_x = {is_2025 ? "white" : "blue", where};
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
