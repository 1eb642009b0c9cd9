#pragma once

/// @file Control software by the name that a scenario gives it, and the parameters that each has.

#include <concepts>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "murosimf/control/client/control_software.h"
#include "murosimf/scene/scene.h"

namespace murosimf {

/// A parameter of a control program. Its value is of the kind of `fallback`, what it has when nobody writes it.
struct ProgramParameter {
  std::string name;
  SceneValue fallback;
  std::string meaning;
  double lowest = 0, highest = 0;       ///< of a number, both included
  std::string unit = {};                ///< of a number; empty: a whole number, or a share
  bool whole = false;                   ///< a number must be whole
  std::vector<std::string> words = {};  ///< of a text: those that it may be; none: any
};

/// The values of all parameters of a program.
class ProgramValues {
 public:
  void set(const std::string& name, SceneValue value) { values_.insert_or_assign(name, std::move(value)); }
  double number(const std::string& name) const { return std::get<double>(values_.at(name)); }
  int whole(const std::string& name) const { return static_cast<int>(number(name)); }
  bool flag(const std::string& name) const { return std::get<bool>(values_.at(name)); }
  const std::string& text(const std::string& name) const { return std::get<std::string>(values_.at(name)); }
  const std::vector<std::string>& texts(const std::string& name) const {
    return std::get<std::vector<std::string>>(values_.at(name));
  }

 private:
  std::map<std::string, SceneValue> values_;
};

struct ControlProgram {
  /// What it throws is told with the scenario's line of the program.
  using Make =
      std::function<std::unique_ptr<client::ControlSoftware>(const ProgramValues&, const client::RobotDescription&)>;
  Make make;
  std::vector<ProgramParameter> parameters;

  ControlProgram(std::vector<ProgramParameter> known, Make maker)
      : make(std::move(maker)), parameters(std::move(known)) {}
  /// One without parameters.
  template <std::invocable Maker>
  ControlProgram(Maker maker)  // NOLINT(google-explicit-constructor): a list of programs names most of them like this
      : make([maker](const ProgramValues&, const client::RobotDescription&) { return maker(); }) {}
};

using ControlPrograms = std::map<std::string, ControlProgram>;

/// The values that a robot's scenario gives to its program. Reports unknown parameters, and values of the wrong kind or
/// beyond their limits.
ProgramValues programValues(const RobotSettings& robot, const std::vector<ProgramParameter>& known,
                            Diagnostics& diagnostics);

/// Tables of all parameters of all programs, for docs/scenario_format.md.
std::string programsAsMarkdown(const ControlPrograms& programs);

}  // namespace murosimf
