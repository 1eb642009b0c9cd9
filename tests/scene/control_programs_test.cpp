// Parameters of control programs: what a scenario may write, and what reaches the program.

#include "murosimf/scene/control_programs.h"

#include "scene/built_world.h"

namespace murosimf::test {
namespace {

using Lines = std::vector<std::string>;

/// A program that keeps what it is given.
struct Kept {
  std::vector<double> speeds;
  std::vector<std::string> names, hosts;
  std::vector<bool> loud;
  std::vector<int> numbers;
};

ControlPrograms programs(const std::shared_ptr<Kept>& kept) {
  std::vector<ProgramParameter> parameters{
      {"speed", 0.5, "how fast", 0, 2, "m/s"},
      {"rounds", 3.0, "how often", 1, 9, "", true},
      {"gait", std::string("trot"), "how", 0, 0, "", false, {"trot", "walk"}},
      {"loud", false, "whether it calls"},
      {"hosts", std::vector<std::string>{"here"}, "who may ask"},
  };
  return {{"runner", ControlProgram(std::move(parameters),
                                    [kept](const ProgramValues& v, const client::RobotDescription& robot) {
                                      kept->speeds.push_back(v.number("speed"));
                                      kept->names.push_back(v.text("gait"));
                                      kept->hosts = v.texts("hosts");
                                      kept->loud.push_back(v.flag("loud"));
                                      kept->numbers.push_back(robot.number * 10 + v.whole("rounds"));
                                      return std::make_unique<Idle>();
                                    })},
          {"broken", ControlProgram({},
                                    [](const ProgramValues&,
                                       const client::RobotDescription&) -> std::unique_ptr<client::ControlSoftware> {
                                      throw std::runtime_error("no licence");
                                    })},
          {"idle", [] { return std::make_unique<Idle>(); }}};
}

/// kTwoRobots has seven lines.
Lines saidOf(const std::string& control, const std::shared_ptr<Kept>& kept = std::make_shared<Kept>()) {
  BuiltWorld built(kTwoRobots + "[robots.red.1.control]\n" + control);
  built.builder.link(allModules(), programs(kept));
  Lines lines;
  std::istringstream text(built.diagnostics.text());
  for (std::string line; std::getline(text, line);) lines.push_back(line.substr(line.find(':') + 1));
  return lines;
}

TEST(ControlPrograms, ValuesReachTheProgramAndTheRestHasItsDefault) {
  const auto kept = std::make_shared<Kept>();
  EXPECT_EQ(saidOf("program = \"runner\"\nspeed = 1.25\nloud = true\nhosts = [\"a\", \"b\"]", kept), Lines{});
  EXPECT_EQ(kept->speeds, std::vector<double>{1.25});
  EXPECT_EQ(kept->names, Lines{"trot"});
  EXPECT_EQ(kept->loud, std::vector<bool>{true});
  EXPECT_EQ(kept->hosts, (Lines{"a", "b"}));
  EXPECT_EQ(kept->numbers, std::vector<int>{13}) << "its robot is told as well";
}

TEST(ControlPrograms, AnEmptyListIsAListOfTexts) {
  const auto kept = std::make_shared<Kept>();
  EXPECT_EQ(saidOf("program = \"runner\"\nhosts = []", kept), Lines{});
  EXPECT_EQ(kept->hosts, Lines{});
}

TEST(ControlPrograms, EveryMistakeIsToldWithItsPlace) {
  EXPECT_EQ(saidOf("program = \"runner\"\nsped = 1\nspeed = 2.5\nrounds = 1.5\ngait = \"hop\"\nloud = 1\nhosts = [1]"),
            (Lines{"10:1: error: robots.red.1: control software \"runner\" has no parameter \"sped\", expected one of "
                   "speed, rounds, gait, loud, hosts (did you mean \"speed\"?)",
                   "11:9: error: robots.red.1: speed is 2.5, expected a number from 0 to 2 m/s",
                   "12:10: error: robots.red.1: rounds is 1.5, expected a whole number from 1 to 9",
                   "13:8: error: robots.red.1: gait is \"hop\", expected one of [trot, walk]",
                   "14:8: error: robots.red.1: loud is 1, expected true or false",
                   "15:9: error: robots.red.1: hosts is [1], expected an array of texts"}));
  EXPECT_EQ(saidOf("program = \"idle\"\nspeed = 1"),
            Lines{"10:1: error: robots.red.1: control software \"idle\" has no parameter \"speed\""});
}

TEST(ControlPrograms, WhatAProgramThrowsWhenItIsMadeIsTold) {
  EXPECT_EQ(saidOf("program = \"broken\""), Lines{"9:11: error: robots.red.1: no licence"});
}

TEST(ControlPrograms, EachParameterStandsInTheTables) {
  const std::string tables = programsAsMarkdown(programs(std::make_shared<Kept>()));
  EXPECT_NE(tables.find("### `program = \"runner\"`"), std::string::npos) << tables;
  EXPECT_NE(tables.find("| `speed` | a number from 0 to 2 m/s | m/s | `0.5` | how fast |"), std::string::npos)
      << tables;
  EXPECT_NE(tables.find("| `hosts` | an array of texts |  | `[\"here\"]` | who may ask |"), std::string::npos)
      << tables;
  EXPECT_EQ(tables.find("idle"), std::string::npos) << "it has none";
}

}  // namespace
}  // namespace murosimf::test
