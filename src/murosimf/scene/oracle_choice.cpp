#include "murosimf/scene/oracle_choice.h"

#include <fmt/format.h>

#include <algorithm>

#include "murosimf/scene/module_choice.h"

namespace murosimf {

namespace {

/// Parameters NAME, which hold for all kinds, and KIND_NAME.
template <class Errors, std::size_t kCount>
class ErrorReader {
 public:
  using Parameter = ErrorParameter<Errors>;
  ErrorReader(const std::array<std::string_view, kCount>& kinds, const std::vector<Parameter>& parameters,
              std::vector<std::string> others, Diagnostics& diagnostics)
      : kinds_(kinds), parameters_(parameters), others_(std::move(others)), diagnostics_(diagnostics) {}

  void read(const ModuleChoice& choice, std::array<Errors, kCount>& errors) const {
    for (const bool of_all : {true, false}) {
      for (const NamedValue& value : choice.parameters) {
        const auto [parameter, kind] = find(value.name);
        if (parameter != nullptr && (kind < 0) == of_all) store(value, *parameter, kind, errors);
        if (parameter == nullptr && of_all) checkOther(value);
      }
    }
  }

 private:
  struct Found {
    const Parameter* parameter = nullptr;
    int kind = -1;  // -1: all
  };
  Found find(std::string_view name) const {
    for (const Parameter& parameter : parameters_) {
      if (parameter.name == name) return {&parameter, -1};
      for (std::size_t k = 0; k < kCount; ++k)
        if (fmt::format("{}_{}", kinds_[k], parameter.name) == name) return {&parameter, static_cast<int>(k)};
    }
    return {};
  }

  void store(const NamedValue& value, const Parameter& parameter, int kind, std::array<Errors, kCount>& errors) const {
    const auto* number = std::get_if<double>(&*value.value);
    if (number == nullptr || !(*number >= parameter.lowest && *number <= parameter.highest)) {
      const std::string unit =
          parameter.unit == "1" || parameter.unit.empty() ? "" : fmt::format(" {}", parameter.unit);
      diagnostics_.error(value.value.where, fmt::format("{} is {}, expected a number from {} to {}{}", value.name,
                                                        number == nullptr ? "no number" : fmt::format("{}", *number),
                                                        parameter.lowest, parameter.highest, unit));
      return;
    }
    for (std::size_t k = 0; k < kCount; ++k)
      if (kind < 0 || static_cast<std::size_t>(kind) == k) errors[k].*parameter.value = *number;
  }

  void checkOther(const NamedValue& value) const {
    if (std::find(others_.begin(), others_.end(), value.name) != others_.end()) return;
    std::vector<std::string> names, known = others_;
    for (const Parameter& parameter : parameters_) {
      names.emplace_back(parameter.name);
      known.emplace_back(parameter.name);
      for (const std::string_view kind : kinds_) known.push_back(fmt::format("{}_{}", kind, parameter.name));
    }
    const std::string more = others_.empty() ? "" : fmt::format(", and {}", fmt::join(others_, ", "));
    diagnostics_.error(
        value.name_where,
        fmt::format("module oracle has no parameter \"{}\"; it knows {}, for one kind with {}_ before "
                    "it{}{}",
                    value.name, fmt::join(names, ", "), fmt::join(kinds_, "_, "), more, didYouMean(value.name, known)));
  }

  const std::array<std::string_view, kCount>& kinds_;
  const std::vector<Parameter>& parameters_;
  std::vector<std::string> others_;  // read elsewhere
  Diagnostics& diagnostics_;
};

}  // namespace

void readSightErrors(const ModuleChoice& camera, ErrorsByKind& errors, Diagnostics& diagnostics) {
  ErrorReader(kSightKindNames, sightParameters(), {"lens", "extrapolate"}, diagnostics).read(camera, errors);
}

std::optional<PoseOracleSettings> localisationChoice(const RobotSettings& robot, Diagnostics& diagnostics) {
  const ModuleChoice& choice = robot.localisation;
  const std::string usual = *robot.level == "oracle" ? "oracle" : "none";
  const std::string& module = choice.module->empty() ? usual : *choice.module;
  if (module != "none" && module != "oracle") {
    diagnostics.error(choice.module.where,
                      fmt::format("{}: unknown module \"{}\" of localisation; expected none or oracle{}", robot.path(),
                                  module, didYouMean(module, {"none", "oracle"})));
    return std::nullopt;
  }
  if (module == "none") {
    for (const NamedValue& parameter : choice.parameters)
      diagnostics.error(parameter.name_where,
                        fmt::format("{}: localisation \"none\" has no parameter \"{}\", expected module = \"oracle\" "
                                    "beside it",
                                    robot.path(), parameter.name));
    return std::nullopt;
  }
  PoseOracleSettings settings;
  settings.period = *choice.period, settings.phase = *choice.phase;
  ErrorReader(kPoseKindNames, poseParameters(), {}, diagnostics).read(choice, settings.errors);
  return settings;
}

}  // namespace murosimf
