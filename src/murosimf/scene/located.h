#pragma once

/// @file Values that know the place in a text file they were written at.

#include <string>
#include <variant>
#include <vector>

#include "murosimf/world/diagnostics.h"

namespace murosimf {

/// A value and where it was written.
template <class T>
struct Located {
  T value{};
  SourceLocation where;
  bool given() const { return !where.file.empty(); }  ///< false: a default
  const T& operator*() const { return value; }
  const T* operator->() const { return &value; }
};

/// A value of a property or of a module's parameter. Whole numbers arrive as double, angles in rad.
using SceneValue = std::variant<bool, double, std::string, std::vector<double>, std::vector<std::string>>;

/// `name = value` of something that the reader has no list of. The name's own place is in `name_where`.
struct NamedValue {
  std::string name;
  SourceLocation name_where;
  Located<SceneValue> value;
};

}  // namespace murosimf
