#pragma once

/// @file Numbers of a method (a period, a tolerance), as opposed to properties, the numbers of an object.

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/world/diagnostics.h"
#include "murosimf/world/world.h"

namespace murosimf {

/// One parameter that a module understands. A value outside [lowest, highest] is refused.
struct ParameterInfo {
  std::string_view name, unit, meaning;
  double initial = 0, lowest = 0, highest = 0;
};

/// A parameter as somebody wrote it.
struct WrittenParameter {
  WrittenValue value;
  SourceLocation where;
};
using WrittenParameters = std::map<std::string, WrittenParameter, std::less<>>;

/// Checked values of all parameters of a module.
class ParameterValues {
 public:
  double operator[](std::string_view name) const { return values_.find(name)->second; }
  friend bool operator==(const ParameterValues&, const ParameterValues&) = default;

 private:
  friend ParameterValues resolveParameters(std::string_view, const std::vector<ParameterInfo>&,
                                           const WrittenParameters&, Diagnostics&);
  std::map<std::string, double, std::less<>> values_;
};

/// Every module that steps has a parameter `period` besides its own.
inline constexpr ParameterInfo kPeriodParameter{"period", "s", "time between two steps; 0: every frame", 0, 0, 10};

/// Initial values replaced by written ones. Reports parameters that the module does not know (unused), values that are
/// no single number, and values out of range; with the place and the nearest name.
ParameterValues resolveParameters(std::string_view module, const std::vector<ParameterInfo>& known,
                                  const WrittenParameters& written, Diagnostics& diagnostics);

}  // namespace murosimf
