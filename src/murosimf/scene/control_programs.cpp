#include "murosimf/scene/control_programs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace murosimf {

namespace {

template <class... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};

std::string listed(const std::vector<std::string>& words) { return fmt::format("[{}]", fmt::join(words, ", ")); }

std::string written(const SceneValue& value) {
  return std::visit(
      Overloaded{[](bool v) { return std::string(v ? "true" : "false"); },
                 [](double v) { return fmt::format("{:g}", v); }, [](const std::string& v) { return '"' + v + '"'; },
                 [](const std::vector<double>& v) { return fmt::format("[{}]", fmt::join(v, ", ")); },
                 [](const std::vector<std::string>& v) {
                   std::vector<std::string> quoted;
                   for (const std::string& text : v) quoted.push_back('"' + text + '"');
                   return listed(quoted);
                 }},
      value);
}

std::string expectedNumber(const ProgramParameter& p) {
  return fmt::format("a {}number from {:g} to {:g}{}{}", p.whole ? "whole " : "", p.lowest, p.highest,
                     p.unit.empty() ? "" : " ", p.unit);
}

std::string expectation(const ProgramParameter& p) {
  return std::visit(
      Overloaded{[](bool) { return std::string("true or false"); }, [&](double) { return expectedNumber(p); },
                 [&](const std::string&) {
                   return p.words.empty() ? std::string("a text in quotes") : "one of " + listed(p.words);
                 },
                 [](const std::vector<double>&) { return std::string("an array of numbers"); },
                 [](const std::vector<std::string>&) { return std::string("an array of texts"); }},
      p.fallback);
}

bool isRight(const ProgramParameter& p, const SceneValue& value) {
  if (value.index() != p.fallback.index()) {
    const auto* numbers = std::get_if<std::vector<double>>(&value);  // what an empty array is read as
    return numbers != nullptr && numbers->empty() && std::holds_alternative<std::vector<std::string>>(p.fallback);
  }
  if (const auto* number = std::get_if<double>(&value))
    return *number >= p.lowest && *number <= p.highest && (!p.whole || *number == std::floor(*number));
  const auto* text = std::get_if<std::string>(&value);
  return text == nullptr || p.words.empty() || std::find(p.words.begin(), p.words.end(), *text) != p.words.end();
}

void refuseUnknown(const RobotSettings& robot, const NamedValue& value, const std::vector<ProgramParameter>& known,
                   Diagnostics& diagnostics) {
  const std::string subject = fmt::format("{}: control software \"{}\" has no parameter \"{}\"", robot.path(),
                                          *robot.control.module, value.name);
  if (known.empty()) return diagnostics.error(value.name_where, subject);
  std::vector<std::string> names;
  for (const ProgramParameter& p : known) names.push_back(p.name);
  diagnostics.error(value.name_where, fmt::format("{}, expected one of {}{}", subject, fmt::join(names, ", "),
                                                  didYouMean(value.name, names)));
}

}  // namespace

ProgramValues programValues(const RobotSettings& robot, const std::vector<ProgramParameter>& known,
                            Diagnostics& diagnostics) {
  ProgramValues values;
  for (const ProgramParameter& p : known) values.set(p.name, p.fallback);
  for (const NamedValue& given : robot.control.parameters) {
    const auto p =
        std::find_if(known.begin(), known.end(), [&](const ProgramParameter& k) { return k.name == given.name; });
    if (p == known.end()) {
      refuseUnknown(robot, given, known, diagnostics);
    } else if (!isRight(*p, *given.value)) {
      diagnostics.error(given.value.where, fmt::format("{}: {} is {}, expected {}", robot.path(), given.name,
                                                       written(*given.value), expectation(*p)));
    } else if (given.value->index() == p->fallback.index()) {
      values.set(p->name, *given.value);
    } else {
      values.set(p->name, std::vector<std::string>{});
    }
  }
  return values;
}

std::string programsAsMarkdown(const ControlPrograms& programs) {
  std::string out;
  for (const auto& [name, program] : programs) {
    if (program.parameters.empty()) continue;
    out += fmt::format(
        "\n### `program = \"{}\"`\n\n| parameter | value | unit | default | meaning |\n|---|---|---|---|---|\n", name);
    for (const ProgramParameter& p : program.parameters)
      out += fmt::format("| `{}` | {} | {} | `{}` | {} |\n", p.name, expectation(p), p.unit, written(p.fallback),
                         p.meaning);
  }
  return out;
}

}  // namespace murosimf
