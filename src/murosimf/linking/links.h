#pragma once

/// @file What a module sees while it is being linked to a batch.

#include "murosimf/linking/batch.h"
#include "murosimf/linking/robot_lane.h"

namespace murosimf {

/// Resolves properties to columns and constants. Lives only while BlockModule::link() runs. All its functions throw
/// std::logic_error for a property that the module has not declared: a fault of the module.
class Links {
 public:
  Links(const World& world, const Batch& batch, const Declaration& declaration, const ParameterValues& parameters)
      : world_(world), batch_(batch), declaration_(declaration), parameters_(parameters) {}

  /// Robots per block: 1, 4 or 8.
  int width() const { return batch_.width; }
  /// How many objects a subset has; the same for every robot of the batch.
  int count(std::string_view subset_name) const {
    return static_cast<int>(world_.members(batch_.members.front(), subset_name).size());
  }
  /// Whether a variable that the module reads if somebody adds it is there.
  template <class T>
  bool has(const Variable<T>& property, std::string_view of = subset::kSelf) const {
    return declared(property.name, of).isRead() && batch_.column(property.name, of) != nullptr;
  }
  /// Time between two steps of the module [s].
  double period() const { return declaration_.period(); }
  double parameter(std::string_view name) const { return parameters_[name]; }

  /// The column of a declared variable, for kernels.
  template <class T>
  ColumnRef column(const Variable<T>& property, std::string_view of = subset::kSelf) const {
    return find(property.name, of).ref;
  }
  /// The column of a declared numeric constant: one value per lane, for kernels.
  template <class T>
  ColumnRef column(const Constant<T>& property, std::string_view of = subset::kSelf) const {
    return find(property.name, of).ref;
  }
  /// The same for modules that step one robot at a time (linking/robot_module.h).
  template <class T>
  RobotValues<T> values(const Variable<T>& property, std::string_view of = subset::kSelf) const {
    const ColumnLayout& layout = find(property.name, of);
    return {layout.ref, layout.objects};
  }
  template <class T>
  RobotValues<const T> values(const Constant<T>& property, std::string_view of = subset::kSelf) const {
    const ColumnLayout& layout = find(property.name, of);
    return {layout.ref, layout.objects};
  }
  /// The value that all robots of the batch share: a tree, a shape list, a text. Of a subset: its object `number`.
  template <class T>
  T shared(const Constant<T>& property, std::string_view of = subset::kSelf, int number = 0) const {
    static_assert(!kIsNumeric<T>, "robots of a batch may differ in numbers: ask for their column");
    const DeclaredProperty& line = declared(property.name, of);
    const std::optional<T> value = world_.find(object(of, number), property);
    return value ? *value : std::any_cast<T>(line.otherwise);
  }

 private:
  const DeclaredProperty& declared(std::string_view property, std::string_view of) const;
  const ColumnLayout& find(std::string_view property, std::string_view of) const;
  ObjectId object(std::string_view of, int number) const;

  const World& world_;
  const Batch& batch_;
  const Declaration& declaration_;
  const ParameterValues& parameters_;
};

}  // namespace murosimf
