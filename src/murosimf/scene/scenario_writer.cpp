#include <fmt/format.h>

#include "murosimf/scene/scenario_reader.h"

namespace murosimf {

namespace {

std::string inQuotes(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\')
      out += std::string("\\") + c;
    else if (byte < 0x20 || byte == 0x7f)
      out += fmt::format("\\u{:04x}", byte);
    else
      out += c;
  }
  return out + "\"";
}

// One function per type of value; the shortest digits that read back to the same double.
std::string written(bool value) { return value ? "true" : "false"; }
std::string written(double value) { return fmt::format("{}", value); }
std::string written(int value) { return fmt::format("{}", value); }
std::string written(std::uint64_t value) { return fmt::format("{}", value); }
std::string written(const std::string& value) { return inQuotes(value); }
std::string written(const Colour& c) { return fmt::format("[{}, {}, {}]", c.red, c.green, c.blue); }
std::string written(const Vec3<double>& p) { return fmt::format("[{}, {}, {}]", p.x, p.y, p.z); }
std::string written(const PlanarPose& p) {
  return fmt::format("{{x = {}, y = {}, heading = {}}}", p.x, p.y, p.heading);
}
template <class T>
std::string written(const std::vector<T>& values) {
  std::string out = "[";
  for (const T& value : values) out += (out.size() > 1 ? ", " : "") + written(value);
  return out + "]";
}
std::string written(const SceneValue& value) {
  return std::visit([](const auto& v) { return written(v); }, value);
}

class ScenarioWriter {
 public:
  void table(const std::string& name) { out_ += fmt::format("{}[{}]\n", out_.empty() ? "" : "\n", name); }
  template <class T>
  void value(std::string_view key, const Located<T>& value) {
    out_ += fmt::format("{} = {}\n", key, written(value.value));
  }
  void named(const std::vector<NamedValue>& values) {
    for (const NamedValue& v : values) value(inQuotes(v.name), v.value);
  }
  void choice(const std::string& name, const char* name_key, const ModuleChoice& choice) {
    table(name);
    if (!choice.module->empty()) value(name_key, choice.module);
    if (choice.period.given()) value("period", choice.period);
    if (choice.phase.given()) value("phase", choice.phase);
    named(choice.parameters);
  }
  std::string take() { return std::move(out_); }

 private:
  std::string out_;
};

void writeSimulation(ScenarioWriter& out, const SimulationSettings& s) {
  out.table("simulation");
  out.value("frame", s.frame);
  out.value("duration", s.duration);
  out.value("seed", s.seed);
  out.value("pace", s.pace);
  out.value("control_period", s.control_period);
  out.value("control_delay", s.control_delay);
  out.value("threads", s.threads);
  out.value("lanes", s.lanes);
}

void writeField(ScenarioWriter& out, const FieldSettings& f) {
  out.table("field");
  out.value("preset", f.preset);
  out.value("length", f.length);
  out.value("width", f.width);
  out.value("goal_width", f.goal_width);
  out.value("goal_height", f.goal_height);
  out.value("goal_depth", f.goal_depth);
  out.value("post_radius", f.post_radius);
  out.value("line_width", f.line_width);
  out.value("border", f.border);
  out.value("centre_circle_radius", f.centre_circle_radius);
  out.value("goal_area_length", f.goal_area_length);
  out.value("goal_area_width", f.goal_area_width);
  out.value("penalty_area_length", f.penalty_area_length);
  out.value("penalty_area_width", f.penalty_area_width);
  out.value("penalty_mark_distance", f.penalty_mark_distance);
  out.value("pole_radius", f.pole_radius);
  out.value("pole_height", f.pole_height);
  out.value("brightness", f.brightness);
  out.value("carpet", f.carpet);
  if (!f.texture->empty()) out.value("texture", f.texture), out.value("texture_size", f.texture_size);
  out.value("goal_at_plus_x", f.goal_at_plus_x);
  out.value("goal_at_minus_x", f.goal_at_minus_x);
}

void writeBall(ScenarioWriter& out, const BallSettings& b) {
  out.table("ball");
  out.value("present", b.present);
  out.value("radius", b.radius);
  out.value("mass", b.mass);
  out.value("inertia_factor", b.inertia_factor);
  out.value("position", b.position);
  out.value("colour", b.colour);
}

using NamedNumber = std::pair<const char*, const Located<double>*>;
std::vector<NamedNumber> numbersOf(const SurfacePairSettings& p) {
  return {{"stiffness", &p.stiffness},
          {"restitution_factor", &p.restitution_factor},
          {"blend_speed", &p.blend_speed},
          {"dissipation", &p.dissipation},
          {"viscous_friction", &p.viscous_friction},
          {"friction_coefficient", &p.friction_coefficient},
          {"stick_speed", &p.stick_speed},
          {"turning_friction", &p.turning_friction},
          {"rolling_resistance", &p.rolling_resistance}};
}

void writeContacts(ScenarioWriter& out, const std::vector<ContactRuleSettings>& rules) {
  for (const ContactRuleSettings& r : rules) {
    out.table("contacts." + inQuotes(r.name));
    if (r.between.given()) {
      const Located<std::vector<std::vector<std::string>>> both{{*r.between, *r.with}, {}};
      out.value("between", both);
    }
    if (r.within.given()) out.value("within", r.within);
    if (r.self.given()) out.value("self", r.self);
    if (r.check.given()) out.value("check", r.check);
    if (r.points.given()) out.value("points", r.points);
    const SurfacePairSettings& p = r.surface;
    if (p.law.given()) out.value("law", p.law);
    if (p.friction.given()) out.value("friction", p.friction);
    for (const auto& [key, value] : numbersOf(p)) {
      if (value->given()) out.value(key, *value);
    }
  }
}

void writeSurfaces(ScenarioWriter& out, const std::vector<SurfacePairSettings>& pairs) {
  for (const SurfacePairSettings& p : pairs) {
    out.table(fmt::format("surfaces.{}-{}", p.first, p.second));
    out.value("law", p.law);
    out.value("friction", p.friction);
    for (const auto& [key, value] : numbersOf(p)) out.value(key, *value);
  }
}

void writeRobot(ScenarioWriter& out, const RobotSettings& r) {
  out.table(r.path());
  out.value("file", r.file);
  out.value("pose", r.pose);
  out.value("role", r.role);
  out.value("level", r.level);
  if (r.kickoff_own) out.value("kickoff_own", *r.kickoff_own);
  if (r.kickoff_other) out.value("kickoff_other", *r.kickoff_other);
  out.choice(r.path() + ".control", "program", r.control);
  if (r.control_delay.given()) out.value("delay", r.control_delay);
  for (const ModuleChoice& m : r.modules) {
    const std::string prefix = "modules.";
    const bool extra = m.slot.starts_with(prefix);
    out.choice(r.path() + "." + (extra ? prefix + inQuotes(m.slot.substr(prefix.size())) : m.slot), "module", m);
  }
  for (const ModuleChoice& m : r.cameras) out.choice(r.path() + ".cameras." + inQuotes(m.slot), "module", m);
  if (r.localisation.module.given() || !r.localisation.parameters.empty())
    out.choice(r.path() + ".localisation", "module", r.localisation);
  if (r.focus) {
    out.table(r.path() + ".focus");
    out.value("motion", r.focus->motion);
    out.value("ball", r.focus->ball);
    out.value("robots", r.focus->robots);
    out.value("margin", r.focus->margin);
  }
  if (r.properties.empty()) return;
  out.table(r.path() + ".properties");
  out.named(r.properties);
}

void writeObstacle(ScenarioWriter& out, const ObstacleSettings& o) {
  out.table(o.path());
  out.value("shape", o.shape);
  out.value("radius", o.radius);
  out.value("length", o.length);
  out.value("width", o.width);
  out.value("height", o.height);
  out.value("pose", o.pose);
  out.value("colour", o.colour);
  out.value("mass", o.mass);
  out.value("surface", o.surface);
}

/// Random obstacles have become obstacles like others.
void writeCourse(ScenarioWriter& out, const CourseSettings& c) {
  out.table("course");
  out.value("pose", c.pose);
  out.value("length", c.length);
  out.value("width", c.width);
  out.value("first_side", c.first_side);
}

void writeReferee(ScenarioWriter& out, const RefereeSettings& r) {
  out.table("referee");
  out.value("enabled", r.enabled);
  out.value("rules", r.rules);
  out.value("attempts", r.attempts);
  out.value("time_limit", r.time_limit);
  out.value("scatter", r.scatter);
  out.value("scatter_heading", r.scatter_heading);
  out.value("kickoff_team", r.kickoff_team);
  out.value("kickoff_wait", r.kickoff_wait);
  out.value("ball_moved", r.ball_moved);
  out.value("pause_after_goal", r.pause_after_goal);
  out.value("half_length", r.half_length);
}

void writeOutput(ScenarioWriter& out, const OutputSettings& o) {
  out.table("output");
  out.value("directory", o.directory);
  out.value("record", o.record);
  out.value("video", o.video);
  out.value("pictures", o.pictures);
}

}  // namespace

std::string writeScenario(const Scene& scene) {
  ScenarioWriter out;
  writeSimulation(out, scene.simulation);
  writeField(out, scene.field);
  writeBall(out, scene.ball);
  writeSurfaces(out, scene.surfaces);
  writeContacts(out, scene.contacts);
  for (const TeamSettings* team : {&scene.red, &scene.blue}) {
    out.table("teams." + team->name);
    out.value("attacks", Located<std::string>{*team->attacks_positive_x ? "+x" : "-x", {}});
  }
  for (const RobotSettings& robot : scene.robots) writeRobot(out, robot);
  for (const ObstacleSettings& obstacle : scene.obstacles) writeObstacle(out, obstacle);
  writeCourse(out, scene.course);
  writeReferee(out, scene.referee);
  writeOutput(out, scene.output);
  return out.take();
}

}  // namespace murosimf
