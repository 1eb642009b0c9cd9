#pragma once

/// @file What a module sees while it is being linked to a batch.

#include <span>

#include "murosimf/linking/batch.h"

namespace murosimf {

/// Resolves properties to columns and constants. Lives only while BlockModule::link() runs.
class Links {
 public:
  Links(const World& world, const Batch& batch, const ParameterValues& parameters)
      : world_(world), batch_(batch), parameters_(parameters) {}

  /// Robots per block: 1, 4 or 8.
  int width() const { return batch_.width; }
  /// How many objects a subset has; the same for every robot of the batch.
  int count(std::string_view subset_name) const {
    return static_cast<int>(world_.members(batch_.members.front(), subset_name).size());
  }
  double parameter(std::string_view name) const { return parameters_[name]; }

  /// The column of a declared variable.
  template <class T>
  ColumnRef column(const Variable<T>& property, std::string_view of = subset::kSelf) const {
    return find(property.name, of);
  }
  /// The column of a declared numeric constant: one value per lane, for kernels.
  template <class T>
  ColumnRef column(const Constant<T>& property, std::string_view of = subset::kSelf) const {
    return find(property.name, of);
  }
  /// The value that all robots of the batch share: a tree, a shape list.
  template <class T>
  const T& shared(const Constant<T>& property) const {
    return *world_.findShared(batch_.members.front(), property);
  }

 private:
  /// @throws std::logic_error when the module did not declare the property: a fault of the module.
  ColumnRef find(std::string_view property, std::string_view of) const;

  const World& world_;
  const Batch& batch_;
  const ParameterValues& parameters_;
};

}  // namespace murosimf
