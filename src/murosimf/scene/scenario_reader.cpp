#include "murosimf/scene/scenario_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <set>
#include <sstream>
#include <utility>

#include "murosimf/scene/contact_reader.h"
#include "murosimf/scene/course_reader.h"
#include "murosimf/scene/field_reader.h"
#include "murosimf/scene/override.h"
#include "murosimf/scene/robot_layers.h"
#include "murosimf/scene/robot_reader.h"
#include "murosimf/scene/table_reader.h"

namespace murosimf {

namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kLargestFile = 4u << 20;  ///< [bytes]
constexpr int kLargestNumber = 99;                 ///< of a jersey
const std::vector<std::string> kTeamNames = {"red", "blue"};

/// The number of "1", "12", ...; 0 when the text is none.
int parseJerseyNumber(const std::string& text) {
  int number = 0;
  const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool right = failed == std::errc{} && end == text.data() + text.size() && std::to_string(number) == text;
  return right && number >= 1 && number <= kLargestNumber ? number : 0;
}

class ScenarioReader {
 public:
  /// @param file_tree, changes normalised
  ScenarioReader(const TextNode& file_tree, const TextNode& changes, const fs::path& file, Diagnostics& diagnostics)
      : file_tree_(file_tree), changes_(changes), whole_(file_tree), file_(file), problems_(diagnostics) {
    layOver(whole_, changes);
  }

  Scene read() {
    TableReader(&whole_, "", problems_).refuseUnknownKeys();
    scene_.file = file_;
    readSimulation();
    scene_.field = readField(whole_.find("field"), problems_);
    readBall();
    scene_.surfaces = readSurfaces(whole_.find("surfaces"), problems_);
    scene_.contacts = readContacts(whole_.find("contacts"), file_tree_.find("contacts"), problems_);
    readTeams();
    readRobots();
    scene_.course = readCourse(whole_.find("course"), problems_);
    scene_.obstacles = readObstacles(whole_.find("obstacles"), scene_.course, *scene_.simulation.seed, problems_);
    readReferee();
    readGameController();
    readOutput();
    return std::move(scene_);
  }

 private:
  TableReader section(const char* name) {
    const TableReader reader(whole_.find(name), name, problems_);
    reader.refuseUnknownKeys();
    return reader;
  }

  void readSimulation() {
    const TableReader reader = section("simulation");
    SimulationSettings& s = scene_.simulation;
    reader.read("frame", s.frame);
    reader.read("duration", s.duration);
    reader.read("seed", s.seed);
    reader.read("pace", s.pace);
    reader.read("control_period", s.control_period);
    reader.read("control_delay", s.control_delay);
    reader.read("threads", s.threads);
    reader.read("lanes", s.lanes);
    if (*s.lanes != 0 && *s.lanes != 1 && *s.lanes != 4 && *s.lanes != 8)
      problems_.error(s.lanes.where, fmt::format("lanes is {}, expected 0, 1, 4 or 8", *s.lanes));
    checkWholeFrames("control_period", s.control_period);
    checkWholeFrames("control_delay", s.control_delay);
  }

  void checkWholeFrames(const std::string& name, const Located<double>& time) {
    const Located<double>& frame = scene_.simulation.frame;
    const double frames = *time / *frame;
    if (std::fabs(frames - std::nearbyint(frames)) < 1e-6) return;
    problems_.error(time.given() ? time.where : frame.where,
                    fmt::format("{} is {} s, expected a multiple of the frame's length of {} s", name, *time, *frame));
  }

  void readBall() {
    const TableReader reader = section("ball");
    reader.read("present", scene_.ball.present);
    reader.read("radius", scene_.ball.radius);
    reader.read("mass", scene_.ball.mass);
    reader.read("inertia_factor", scene_.ball.inertia_factor);
    reader.read("position", scene_.ball.position);
    reader.read("colour", scene_.ball.colour);
  }

  void refuseUnknownTeams(const TextNode* table, const std::vector<std::string>& known) {
    if (table == nullptr || !table->isTable()) return;
    for (const TextNode& team : table->children)
      if (std::find(known.begin(), known.end(), team.key) == known.end())
        problems_.error(team.key_where, fmt::format("there is no team \"{}\" in {}, expected {}{}", printable(team.key),
                                                    table->key, listWords(known), didYouMean(team.key, known)));
  }

  void readTeams() {
    const TextNode* teams = whole_.find("teams");
    const TableReader reader(teams, "teams", problems_);
    refuseUnknownTeams(teams, kTeamNames);
    for (TeamSettings* team : {&scene_.red, &scene_.blue}) {
      const TextNode* table = reader.child(team->name);
      Located<std::string> goal;
      if (TableReader(table, "teams.TEAM", problems_).read("attacks", goal))
        team->attacks_positive_x = {*goal == "+x", goal.where};
      if (table != nullptr && table->isTable())
        readRobot(*table, RobotTable::kDefaults, "teams." + team->name, file_, {"attacks"}, problems_);
    }
    agreeOnGoals(scene_.red.attacks_positive_x, scene_.blue.attacks_positive_x);
  }

  /// Where one team says which goal it attacks, the other one attacks the other goal.
  void agreeOnGoals(Located<bool>& red, Located<bool>& blue) {
    if (*red != *blue) return;
    if (red.given() && blue.given())
      problems_.error(blue.where,
                      "both teams attack the same goal, expected attacks = \"+x\" for one of them and "
                      "\"-x\" for the other");
    Located<bool>& follower = red.given() ? blue : red;
    follower.value = !follower.value;
  }

  void readRobots() {
    const TextNode* robots = whole_.find("robots");
    const TableReader reader(robots, "robots", problems_);
    refuseUnknownTeams(robots, {"red", "blue", "all"});
    const TableReader defaults(reader.child("all"), "robots.all", problems_);
    if (const TextNode* all = reader.child("all"); all != nullptr && all->isTable())
      readRobot(*all, RobotTable::kDefaults, "robots.all", file_, {}, problems_);
    for (const std::string& team : kTeamNames) readRobotsOf(team, reader.child(team));
    std::stable_sort(scene_.robots.begin(), scene_.robots.end(), [](const RobotSettings& a, const RobotSettings& b) {
      return a.team == b.team ? a.number < b.number : a.team == "red" && b.team == "blue";
    });
    for (const RobotSettings& robot : scene_.robots) checkControlTimes(robot);
    warnOfCrowds();
  }

  void checkControlTimes(const RobotSettings& robot) {
    if (robot.control.period.given()) checkWholeFrames("period", robot.control.period);
    if (robot.control_delay.given()) checkWholeFrames("delay", robot.control_delay);
  }

  void readRobotsOf(const std::string& team, const TextNode* table) {
    const TableReader reader(table, "robots.TEAM", problems_);
    if (table == nullptr || !table->isTable()) return;
    for (const TextNode& robot : table->children) {
      const int number = parseJerseyNumber(robot.key);
      if (number == 0) {
        problems_.error(robot.key_where, fmt::format("robots.{}.\"{}\" is no jersey number, expected 1 to {}", team,
                                                     printable(robot.key), kLargestNumber));
      } else if (!robot.isTable()) {
        problems_.error(robot.where,
                        fmt::format("robots.{}.{} is {}, expected a table", team, number, describe(robot)));
      } else if (isInFile(team, robot)) {
        readOneRobot(team, number, robot.key);
      }
    }
  }

  /// `--set` changes robots, it adds none: a slip in a number would otherwise make half a robot.
  bool isInFile(const std::string& team, const TextNode& robot) {
    const TextNode* robots = file_tree_.find("robots");
    const TextNode* own = robots == nullptr ? nullptr : robots->find(team);
    if (own != nullptr && own->find(robot.key) != nullptr) return true;
    problems_.error(robot.key_where,
                    fmt::format("the scenario has no robots.{}.{}, expected one of its robots", team, robot.key));
    return false;
  }

  void readOneRobot(const std::string& team, int number, const std::string& key) {
    const TextNode table = layeredRobot(file_tree_, changes_, team, key);
    RobotSettings robot =
        readRobot(table, RobotTable::kRobot, fmt::format("robots.{}.{}", team, number), file_, {}, problems_);
    robot.team = team;
    robot.number = number;
    for (const ModuleChoice& module : robot.modules) {
      checkWholeFrames("period", module.period);
      checkWholeFrames("phase", module.phase);
    }
    scene_.robots.push_back(std::move(robot));
  }

  void warnOfCrowds() {
    constexpr double kClosest = .10;  // [m]
    for (std::size_t i = 0; i < scene_.robots.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        const RobotSettings &a = scene_.robots[k], &b = scene_.robots[i];
        const double dx = a.pose->x - b.pose->x, dy = a.pose->y - b.pose->y;
        if (!a.pose.given() || !b.pose.given() || dx * dx + dy * dy >= kClosest * kClosest) continue;
        problems_.warning(b.pose.where, fmt::format("{} stands within {} m of {}", b.path(), kClosest, a.path()));
      }
    }
  }

  void readReferee() {
    const TableReader reader = section("referee");
    reader.read("enabled", scene_.referee.enabled);
    reader.read("rules", scene_.referee.rules);
    reader.read("attempts", scene_.referee.attempts);
    reader.read("time_limit", scene_.referee.time_limit);
    reader.read("scatter", scene_.referee.scatter);
    reader.read("scatter_heading", scene_.referee.scatter_heading);
    reader.read("kickoff_team", scene_.referee.kickoff_team);
    reader.read("kickoff_wait", scene_.referee.kickoff_wait);
    reader.read("ball_moved", scene_.referee.ball_moved);
    reader.read("pause_after_goal", scene_.referee.pause_after_goal);
    reader.read("half_length", scene_.referee.half_length);
    checkRules();
  }

  void readGameController() {
    const TableReader reader = section("game_controller");
    GameControllerSettings& s = scene_.game_controller;
    reader.read("role", s.role);
    reader.read("format", s.format);
    reader.read("host", s.host);
    reader.read("port", s.port);
    reader.read("broadcast", s.broadcast);
    reader.read("listen", s.listen);
    reader.read("return_port", s.return_port);
    reader.read("allow", s.allow);
    reader.read("red_number", s.red_number);
    reader.read("blue_number", s.blue_number);
    if (*s.role == "none") return;
    if (!*scene_.referee.enabled)
      problems_.error(s.role.where,
                      "a game controller tells what the referee decides, and there is none; expected "
                      "referee.enabled = true");
    if (*s.red_number == *s.blue_number)
      problems_.error(s.blue_number.where, fmt::format("both teams have the number {}, expected two", *s.red_number));
  }

  /// What the rules need to have something to judge.
  void checkRules() {
    const Located<std::string>& rules = scene_.referee.rules;
    if (*rules == "match" || !*scene_.referee.enabled) return;
    const std::string& team = *scene_.referee.kickoff_team;
    const bool any = std::any_of(scene_.robots.begin(), scene_.robots.end(),
                                 [&](const RobotSettings& robot) { return robot.team == team; });
    if (!any)
      problems_.error(rules.where, fmt::format("rules are \"{}\", and there is no robot of team {} to make the "
                                               "attempts, expected one, or another kickoff_team",
                                               *rules, team));
    if (*rules == "penalty_kicks") {
      if (!*scene_.ball.present)
        problems_.error(rules.where, "rules are \"penalty_kicks\", and there is no ball, expected ball.present = true");
    } else if (*scene_.course.length <= 0) {
      problems_.error(rules.where, fmt::format("rules are \"{}\", and there is no course, expected [course] with a "
                                               "length of more than 0 m",
                                               *rules));
    }
  }

  void readOutput() {
    const TableReader reader = section("output");
    reader.read("directory", scene_.output.directory);
    reader.read("record", scene_.output.record);
    reader.read("video", scene_.output.video);
    reader.read("pictures", scene_.output.pictures);
  }

  const TextNode& file_tree_;
  const TextNode& changes_;
  TextNode whole_;
  const fs::path& file_;
  Diagnostics& problems_;
  Scene scene_;
};

/// Defaults are read once for each robot that has them: a mistake there is told once.
void tellOnce(const Diagnostics& found, Diagnostics& diagnostics) {
  std::set<std::string> told;
  for (const Diagnostic& d : found.all()) {
    const SourceLocation& w = d.where;
    if (!told.insert(fmt::format("{}:{}:{}:{}", w.file, w.line, w.column, d.message)).second) continue;
    if (d.severity == Diagnostic::Severity::kError)
      diagnostics.error(w, d.message);
    else
      diagnostics.warning(w, d.message);
  }
}

std::optional<Scene> readTree(std::string_view text, const fs::path& file, const std::vector<std::string>& overrides,
                              Diagnostics& problems) {
  std::optional<TextNode> tree = parseToml(text, file.string(), problems);
  TextNode changes;
  for (const std::string& assignment : overrides) applyOverride(changes, assignment, problems);
  if (!tree) return std::nullopt;
  for (TextNode* t : {&*tree, &changes}) {
    normaliseRobotTables(*t);
    normaliseSurfaces(*t, problems);
  }
  Scene scene = ScenarioReader(*tree, changes, file, problems).read();
  if (problems.hasErrors()) return std::nullopt;
  return scene;
}

}  // namespace

std::optional<Scene> readScenarioText(std::string_view text, const fs::path& file,
                                      const std::vector<std::string>& overrides, Diagnostics& diagnostics) {
  Diagnostics problems;
  std::optional<Scene> scene = readTree(text, file, overrides, problems);
  tellOnce(problems, diagnostics);
  return scene;
}

std::optional<Scene> readScenario(const fs::path& file, const std::vector<std::string>& overrides,
                                  Diagnostics& diagnostics) {
  const SourceLocation where{file.string(), 0, 0};
  std::error_code failed;
  if (!fs::is_regular_file(file, failed)) {
    diagnostics.error(where, fs::exists(file, failed) ? "this is no file, expected a scenario (TOML)"
                                                      : "there is no such file, expected a scenario (TOML)");
    return std::nullopt;
  }
  if (fs::file_size(file, failed) > kLargestFile) {
    diagnostics.error(where, fmt::format("the file is larger than {} bytes, expected a scenario (TOML)", kLargestFile));
    return std::nullopt;
  }
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  if (!stream || stream.bad()) {
    diagnostics.error(where, "the file cannot be read");
    return std::nullopt;
  }
  return readScenarioText(text.str(), file, overrides, diagnostics);
}

}  // namespace murosimf
