#include "murosimf/linking/parameters.h"

#include <fmt/format.h>

#include <algorithm>

namespace murosimf {

namespace {

std::vector<std::string> namesOf(const std::vector<ParameterInfo>& known) {
  std::vector<std::string> names;
  for (const ParameterInfo& info : known) names.emplace_back(info.name);
  return names;
}

}  // namespace

ParameterValues resolveParameters(std::string_view module, const std::vector<ParameterInfo>& known,
                                  const WrittenParameters& written, Diagnostics& diagnostics) {
  ParameterValues values;
  for (const ParameterInfo& info : known) values.values_.emplace(info.name, info.initial);
  for (const auto& [name, parameter] : written) {
    const auto info =
        std::find_if(known.begin(), known.end(), [&wanted = name](const ParameterInfo& k) { return k.name == wanted; });
    if (info == known.end()) {
      diagnostics.error(parameter.where,
                        fmt::format("module {} has no parameter \"{}\"; it knows {}{}", module, name,
                                    fmt::join(namesOf(known), ", "), didYouMean(name, namesOf(known))));
      continue;
    }
    const auto number = fromWritten<double>(parameter.value);
    if (!number) {
      diagnostics.error(parameter.where,
                        fmt::format("parameter {} of module {} is not a number; expected one number in "
                                    "{}",
                                    name, module, info->unit));
    } else if (!(*number >= info->lowest && *number <= info->highest)) {
      diagnostics.error(parameter.where, fmt::format("parameter {} of module {} is {} {}; expected {} to {}", name,
                                                     module, *number, info->unit, info->lowest, info->highest));
    } else {
      values.values_.find(name)->second = *number;
    }
  }
  return values;
}

}  // namespace murosimf
