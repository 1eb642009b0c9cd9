#include "murosimf/scene/scenario_keys.h"

#include <fmt/format.h>

namespace murosimf {

namespace {

using enum ScenarioKey::Kind;
using Key = ScenarioKey;

constexpr ScenarioKey wordKey(std::string_view section, std::string_view key, std::string_view words,
                              std::string_view fallback, std::string_view meaning) {
  return {section, key, kWord, "", 0, 0, false, words, fallback, meaning};
}
constexpr ScenarioKey plainKey(std::string_view section, std::string_view key, Key::Kind kind,
                               std::string_view fallback, std::string_view meaning) {
  return {section, key, kind, "", 0, 0, false, "", fallback, meaning};
}
/// A number in [lower, upper].
constexpr ScenarioKey from(std::string_view section, std::string_view key, std::string_view unit, double lower,
                           double upper, std::string_view fallback, std::string_view meaning) {
  return {section, key, kNumber, unit, lower, upper, false, "", fallback, meaning};
}
/// A number in (lower, upper].
constexpr ScenarioKey above(std::string_view section, std::string_view key, std::string_view unit, double lower,
                            double upper, std::string_view fallback, std::string_view meaning) {
  return {section, key, kNumber, unit, lower, upper, true, "", fallback, meaning};
}
constexpr ScenarioKey whole(std::string_view section, std::string_view key, double lower, double upper,
                            std::string_view fallback, std::string_view meaning) {
  return {section, key, kInteger, "1", lower, upper, false, "", fallback, meaning};
}

constexpr std::string_view kRobot = "robots.TEAM.NUMBER";
constexpr std::string_view kTeam = "teams.TEAM";
constexpr std::string_view kPair = "surfaces.A-B";
constexpr std::string_view kContact = "contacts.NAME";
constexpr std::string_view kObstacle = "obstacles.NAME";

constexpr ScenarioKey kKeys[] = {
    plainKey("", "simulation", kTable, "", "time steps, seed, clock, threads"),
    plainKey("", "field", kTable, "", "field of play"),
    plainKey("", "ball", kTable, "", "the ball"),
    plainKey("", "surfaces", kTable, "", "how two surfaces touch, a table `[surfaces.A-B]` a pair"),
    plainKey("", "contacts", kTable, "", "what may touch what, where surfaces do not say it: tables `[contacts.NAME]`"),
    plainKey("", "teams", kTable, "", "`[teams.red]`, `[teams.blue]`"),
    plainKey("", "robots", kTable, "", "`[robots.all]`, and `[robots.red.1]` for red's robot with the number 1"),
    plainKey("", "obstacles", kTable, "",
             "what stands in the way: a table `[obstacles.NAME]` each, and `[obstacles.all]` for what they share"),
    plainKey("", "course", kTable, "", "the way of a slalom or of an obstacle run"),
    plainKey("", "referee", kTable, "", "what is judged: kick-off, goals, ball out, clock; or attempts of a trial"),
    plainKey("", "game_controller", kTable, "", "tells robots' software by UDP how the game stands"),
    plainKey("", "output", kTable, "", "what a run leaves behind"),

    above("simulation", "frame", "s", 0, .02, "0.001", "length of a frame"),
    above("simulation", "duration", "s", 0, 1e7, "60.0", "simulated time of the run"),
    whole("simulation", "seed", 0, kNoLimit, "1", "of all random numbers"),
    from("simulation", "pace", "1", 0, 100, "0.0",
         "0: as fast as it goes; p > 0: p simulated seconds a second of the wall clock"),
    above("simulation", "control_period", "s", 0, 1, "0.01", "between two steps of control software: whole frames"),
    from("simulation", "control_delay", "s", 0, 1, "0.01", "after which commands act: whole frames"),
    whole("simulation", "threads", 0, 1024, "0", "0: all"),
    whole("simulation", "lanes", 0, 8, "0", "robots computed at once: 1, 4 or 8; 0: as it suits the machine"),

    wordKey("field", "preset", "2007 2025_kid 2025_adult 2026_small 2026_middle 2026_large", "\"2007\"",
            "the measures that are not given below"),
    above("field", "length", "m", 0, 200, "", "from goal line to goal line; default: the preset's"),
    above("field", "width", "m", 0, 200, "", "from side line to side line; default: the preset's"),
    above("field", "goal_width", "m", 0, 20, "", "between the posts; default: the preset's"),
    above("field", "goal_height", "m", 0, 10, "", "height of the bar; default: the preset's"),
    above("field", "goal_depth", "m", 0, 10, "", "default: the preset's"),
    above("field", "post_radius", "m", 0, .5, "", "default: the preset's"),
    above("field", "line_width", "m", 0, .5, "", "default: the preset's"),
    from("field", "border", "m", 0, 20, "", "turf around the lines; default: the preset's"),
    from("field", "centre_circle_radius", "m", 0, 50, "", "default: the preset's"),
    from("field", "goal_area_length", "m", 0, 50, "", "along x, 0: no goal area; default: the preset's"),
    from("field", "goal_area_width", "m", 0, 100, "", "default: the preset's"),
    from("field", "penalty_area_length", "m", 0, 50, "", "along x, 0: no penalty area; default: the preset's"),
    from("field", "penalty_area_width", "m", 0, 100, "", "default: the preset's"),
    from("field", "penalty_mark_distance", "m", 0, 50, "", "from the goal line; default: the preset's"),
    from("field", "pole_radius", "m", 0, 1, "", "landmark poles at the halfway line, 0: none; default: the preset's"),
    from("field", "pole_height", "m", 0, 5, "", "default: the preset's"),
    from("field", "brightness", "1", .05, 5, "1.0", "factor on all light"),
    plainKey("field", "carpet", kColour, "[0.09, 0.38, 0.14]", "colour of the turf"),
    plainKey("field", "texture", kText, "\"\"", "PNG picture on the turf in the place of its colour, top towards +y"),
    from("field", "texture_size", "m", 0, 200, "0.0",
         "edge of the square that it covers again and again; 0: all, once"),
    wordKey("field", "goal_at_plus_x", "yellow blue white", "", "colour; default: the preset's"),
    wordKey("field", "goal_at_minus_x", "yellow blue white", "", "colour; default: the preset's"),

    plainKey("ball", "present", kBool, "true", "whether there is one"),
    from("ball", "radius", "m", .01, .5, "0.07", ""),
    from("ball", "mass", "kg", .001, 10, "0.205", ""),
    from("ball", "inertia_factor", "1", .01, 1, "0.667", "beta in I = beta m r^2: hollow 2/3, solid 2/5"),
    plainKey("ball", "position", kPosition, "[0.0, 0.0]", "x, y and perhaps z of its lowest point at the start"),
    plainKey("ball", "colour", kColour, "[1.0, 0.4, 0.05]", ""),

    wordKey(kPair, "law", "smooth paper hunt_crossley", "\"smooth\"", "contact law"),
    above(kPair, "stiffness", "N/m", 0, 1e8, "", "s_c, of the whole contact of two bodies"),
    from(kPair, "restitution_factor", "1", 0, 1, "",
         "s_b, share of the stiffness that acts while separating; bounces with sqrt(s_b)"),
    above(kPair, "blend_speed", "m/s", 0, 1, "0.02", "v_0 of `smooth`"),
    from(kPair, "dissipation", "s/m", 0, 500, "0.6", "d of `hunt_crossley`"),
    wordKey(kPair, "friction", "viscous coulomb", "", "which of the two holds; default: the one that is given"),
    from(kPair, "viscous_friction", "s/m", 0, 1e4, "0.0", "s_mu, force over normal force and speed"),
    from(kPair, "friction_coefficient", "1", 0, 10, "0.0", "mu of Coulomb friction"),
    above(kPair, "stick_speed", "m/s", 0, 1, "0.002", "v_s, below which Coulomb friction is viscous"),
    from(kPair, "turning_friction", "m s", 0, 1e3, "0.0", "s_nu, torque over normal force and angular velocity"),
    from(kPair, "rolling_resistance", "1", 0, 1, "0.0", "c_rr, torque over normal force and radius"),

    plainKey(kContact, "between", kTwoNames, "", "pairs of an object of the one and an object of the other"),
    plainKey(kContact, "within", kNames, "", "pairs of these objects; bodies of one robot are no pair"),
    plainKey(kContact, "self", kNames, "", "pairs of bodies of one and the same robot"),
    plainKey(kContact, "check", kBool, "", "whether they touch; default: yes, and bodies of one robot do not"),
    wordKey(kContact, "points", "manifold one", "",
            "up to four points a pair of shapes, or the deepest alone; default: manifold"),

    wordKey(kTeam, "attacks", "+x -x", "", "the goal it plays to; default: red +x, blue -x"),

    plainKey(kRobot, "file", kText, "",
             "robot file, looked for from the scenario's folder, the folder above, the working folder and the "
             "installed data"),
    plainKey(kRobot, "pose", kPose, "", "start pose of the pelvis' projection, [x, y, heading] or {x, y, heading}"),
    plainKey(kRobot, "role", kText, "\"\"", "told to the control software"),
    wordKey(kRobot, "level", "kinematic fast full oracle", "\"kinematic\"",
            "level of detail: a motion and what goes with it; `oracle`: that of `kinematic`, cameras and localisation "
            "tell the truth"),
    plainKey(kRobot, "motion", kModule, "", "module; default: the level's. What goes with it comes with it"),
    plainKey(kRobot, "electronics", kModule, "", "module; default: the level's"),
    plainKey(kRobot, "actuation", kModule, "", "module; default: the level's"),
    plainKey(kRobot, "velocities", kModule, "", "module; default: the level's"),
    plainKey(kRobot, "kinematics", kModule, "", "module; default: the level's"),
    plainKey(kRobot, "collision", kModule, "", "module; default: the level's"),
    plainKey(kRobot, "contact", kModule, "", "module; default: the level's"),
    plainKey(kRobot, "integration", kModule, "", "module; default: the level's"),
    plainKey(kRobot, "sensing", kModule, "", "module; default: the level's"),
    plainKey(kRobot, "pressure", kModule, "", "module; default: the level's"),
    plainKey(kRobot, "torque", kModule, "", "module; default: the level's"),
    plainKey(kRobot, "touch", kModule, "", "module; default: the level's"),
    plainKey(kRobot, "force", kModule, "", "module; default: the level's"),
    plainKey(kRobot, "limits", kModule, "", "module; default: the level's"),
    plainKey(kRobot, "accelerations", kModule, "", "module; default: the level's"),
    plainKey(kRobot, "recoil", kModule, "", "module; default: the level's"),
    plainKey(kRobot, "focus", kTable, "", "another motion near the ball and other robots, see below"),
    plainKey(kRobot, "modules", kTable, "", "further modules by name, `modules.NAME = {PARAMETER = VALUE}`"),
    plainKey(kRobot, "cameras", kTable, "",
             "per camera of the robot file a module, `ray_caster`, `opengl`, `oracle` or `none`"),
    plainKey(kRobot, "localisation", kModule, "", "`oracle`: told where it and its mates stand; or `none`"),
    plainKey(
        kRobot, "control", kModule, "\"none\"",
        "control software: `player`, `trotter`, `cart`, a port for that of others, `player_api`, `agent_server` or "
        "`servo_bus`, `none` or {program = ...}"),
    plainKey(kRobot, "properties", kTable, "", "any property by object and name, `\"trunk.mass\" = 1.2`"),
    plainKey(kRobot, "kickoff_own", kPose, "", "at the own team's kick-off; default: the referee's choice"),
    plainKey(kRobot, "kickoff_other", kPose, "", "at the other team's kick-off; default: the referee's choice"),

    plainKey("MODULE", "module", kText, "", "name of the module; default: the level's"),
    from("MODULE", "period", "s", 0, 10, "0.0", "between two updates: whole frames (cameras: rounded); 0: its own"),
    from("MODULE", "phase", "s", 0, 10, "0.0", "first update after the start"),
    plainKey("CONTROL", "program", kText, "",
             "`player`, `trotter`, `cart`, `player_api`, `agent_server`, `servo_bus` or `none`; what else may stand "
             "here is the program's"),
    above("CONTROL", "period", "s", 0, 1, "",
          "between two of its steps: whole frames; default: simulation.control_period"),
    from("CONTROL", "delay", "s", 0, 1, "",
         "after which its commands act: whole frames; default: "
         "simulation.control_delay"),
    plainKey("FOCUS", "motion", kText, "\"multibody_dynamics\"", "module that moves the robot there"),
    from("FOCUS", "ball", "m", 0, 100, "1.0",
         "distance from the ball within which it does; 0: the ball does not count"),
    from("FOCUS", "robots", "m", 0, 100, "1.0", "same, from any other robot"),
    from("FOCUS", "margin", "m", 0, 100, "0.2", "so much farther away the robot goes back to its usual motion"),
    plainKey("POSE", "x", kNumber, "", "m"),
    plainKey("POSE", "y", kNumber, "", "m"),
    plainKey("POSE", "heading", kNumber, "0.0", "rad, or {deg = ...}; from +x to +y"),

    wordKey(kObstacle, "shape", "cylinder box", "\"cylinder\"", "upright"),
    above(kObstacle, "radius", "m", 0, 10, "0.1", "of a cylinder"),
    above(kObstacle, "length", "m", 0, 10, "0.4", "of a box, along its own x"),
    above(kObstacle, "width", "m", 0, 10, "0.4", "of a box, along its own y"),
    above(kObstacle, "height", "m", 0, 10, "0.6", ""),
    plainKey(kObstacle, "pose", kPose, "", "where it stands: [x, y, heading]; must be given"),
    plainKey(kObstacle, "colour", kColour, "[0.75, 0.08, 0.06]", ""),
    from(kObstacle, "mass", "kg", 0, 1000, "0.0", "0: it stands fast; else it can be pushed and knocked over"),
    plainKey(kObstacle, "surface", kText, "\"plastic\"", "for the pairs of surfaces"),

    plainKey("course", "pose", kPose, "[0, 0, 0]", "middle of the start line, and the direction of the way"),
    from("course", "length", "m", 0, 200, "0.0", "from the start line to the finish line; 0: there is no course"),
    from("course", "width", "m", 0, 200, "0.0", "of the strip that must not be left; 0: no limit"),
    wordKey("course", "first_side", "left right", "\"left\"",
            "of the first pole of a slalom, on which the robot passes; sides alternate"),
    whole("course", "random_obstacles", 0, 400, "0",
          "so many, as `[obstacles.all]` has them, on sites that the seed chooses"),
    whole("course", "sites_along", 1, 20, "3", "sites divide length and width evenly, the edges left out"),
    whole("course", "sites_across", 1, 20, "3", ""),
    whole("course", "most_abreast", 1, 20, "2", "obstacles beside one another"),

    plainKey("referee", "enabled", kBool, "true", ""),
    wordKey("referee", "rules", "match penalty_kicks slalom obstacle_run", "\"match\"",
            "what is judged; all but `match` are trials"),
    whole("referee", "attempts", 1, 1000, "1", "of a trial, each from where the scenario has everything"),
    above("referee", "time_limit", "s", 0, 1e5, "60.0", "of an attempt"),
    from("referee", "scatter", "m", 0, 1, "0.0",
         "standard deviation of the robots' places at the beginning of an attempt, of which they are not told"),
    from("referee", "scatter_heading", "rad", 0, 3.2, "0.0", "same, of their headings; or {deg = ...}"),
    wordKey("referee", "kickoff_team", "red blue", "\"red\"", "has the first kick-off, or makes the attempts"),
    from("referee", "kickoff_wait", "s", 0, 600, "10.0", "after which the other team may play a resting ball"),
    above("referee", "ball_moved", "m", 0, 2, "0.05", "way of the ball after which it is in play"),
    from("referee", "pause_after_goal", "s", 0, 600, "2.0",
         "until the robots are put back for the kick-off, or for the next attempt"),
    from("referee", "half_length", "s", 0, 1e7, "0.0", "0: one half, as long as the run"),

    wordKey("game_controller", "role", "none send", "\"none\"",
            "`send`: packets to robots, and their status heard (docs/game_controller.md)"),
    wordKey("game_controller", "format", "hsl19 spl18 hl15 hl12", "\"hsl19\"", "league and version of the packets"),
    plainKey("game_controller", "host", kText, "\"127.0.0.1\"",
             "that packets go to; a network's last address: all of it"),
    whole("game_controller", "port", 1, 65535, "3838", "that they go to"),
    plainKey("game_controller", "broadcast", kBool, "false", "`host` is a network's last address"),
    plainKey("game_controller", "listen", kText, "\"127.0.0.1\"", "address on which robots are heard"),
    whole("game_controller", "return_port", 0, 65535, "3939", "on which robots are heard; 0: any free one"),
    plainKey("game_controller", "allow", kText, "\"127.0.0.1\"", "hosts whose robots are heard, blanks between them"),
    whole("game_controller", "red_number", 0, 254, "1", "of the team"),
    whole("game_controller", "blue_number", 0, 254, "2", "likewise"),

    plainKey("output", "directory", kText, "\"out\"", ""),
    plainKey("output", "record", kText, "\"none\"", "file of the recorder within the directory, or `none`"),
    plainKey("output", "video", kText, "\"none\"", "file of the video within the directory, or `none`"),
    plainKey("output", "pictures", kBool, "true", "bird's eye and camera pictures at the end"),
};

std::string typeName(const ScenarioKey& key) {
  switch (key.kind) {
    case kBool:
      return "true or false";
    case kInteger:
      return "whole number";
    case kNumber:
      return "number";
    case kText:
      return "text";
    case kWord:
      return "word";
    case kPose:
      return "pose";
    case kPosition:
      return "position";
    case kColour:
      return "colour";
    case kModule:
      return "name or table";
    case kTable:
      return "table";
    case kNames:
      return "names";
    case kTwoNames:
      return "two names";
  }
  return "";
}

std::string interval(const ScenarioKey& key) {
  const std::string unit = key.unit == "1" || key.unit.empty() ? "" : fmt::format(" {}", key.unit);
  std::string out = fmt::format("{} {:g}", key.above_lower ? "more than" : "at least", key.lower);
  if (key.upper == kNoLimit) return out + unit;
  return out + fmt::format(" and at most {:g}{}", key.upper, unit);
}

/// The range as [lower, upper]; ( and ) where the limit itself is outside.
std::string bracket(const ScenarioKey& key) {
  const std::string lower = fmt::format("{}{:g}", key.above_lower ? "(" : "[", key.lower);
  return key.upper == kNoLimit ? lower + ", )" : lower + fmt::format(", {:g}]", key.upper);
}

}  // namespace

std::span<const ScenarioKey> scenarioKeys() { return kKeys; }

const ScenarioKey* findScenarioKey(std::string_view section, std::string_view key) {
  for (const ScenarioKey& k : kKeys)
    if (k.section == section && k.key == key) return &k;
  return nullptr;
}

std::vector<std::string> keysOfSection(std::string_view section) {
  std::vector<std::string> keys;
  for (const ScenarioKey& k : kKeys)
    if (k.section == section) keys.emplace_back(k.key);
  return keys;
}

std::vector<std::string> allowedWords(const ScenarioKey& key) {
  std::vector<std::string> words;
  for (std::string_view rest = key.words; !rest.empty();) {
    const std::size_t blank = rest.find(' ');
    words.emplace_back(rest.substr(0, blank));
    rest = blank == rest.npos ? std::string_view{} : rest.substr(blank + 1);
  }
  return words;
}

std::string listWords(const std::vector<std::string>& words) {
  std::string out;
  for (std::size_t i = 0; i < words.size(); ++i)
    out += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + ("\"" + words[i] + "\"");
  return out;
}

std::string expectation(const ScenarioKey& key) {
  switch (key.kind) {
    case kBool:
      return "true or false";
    case kInteger:
      return "a whole number, " + interval(key);
    case kNumber:
      return key.upper > key.lower ? "a number, " + interval(key) : "a number";
    case kText:
      return "a text in quotes";
    case kWord:
      return listWords(allowedWords(key));
    case kPose:
      return "[x, y, heading] or {x = ..., y = ..., heading = ...}";
    case kPosition:
      return "[x, y] or [x, y, z] in m";
    case kColour:
      return "[red, green, blue], each from 0 to 1";
    case kModule:
      return "a name in quotes or a table";
    case kTable:
      return "a table";
    case kNames:
      return "a name in quotes or an array of names";
    case kTwoNames:
      return "[A, B], each a name in quotes or an array of names";
  }
  return "";
}

std::string scenarioKeysAsMarkdown() {
  std::string out;
  std::string_view section = "-";
  for (const ScenarioKey& k : kKeys) {
    if (k.section != section) {
      section = k.section;
      out += fmt::format("\n### {}\n\n| key | type | range | unit | default | meaning |\n|---|---|---|---|---|---|\n",
                         section.empty() ? "Tables of a scenario" : fmt::format("`[{}]`", section));
    }
    const bool ranged = k.upper > k.lower;
    const std::string range = k.kind == kWord ? listWords(allowedWords(k)) : ranged ? bracket(k) : "";
    const std::string fallback = k.fallback.empty() ? "" : fmt::format("`{}`", k.fallback);
    out += fmt::format("| `{}` | {} | {} | {} | {} | {} |\n", k.key, typeName(k), range, k.unit, fallback, k.meaning);
  }
  return out;
}

}  // namespace murosimf
