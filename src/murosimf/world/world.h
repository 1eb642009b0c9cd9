#pragma once

/// @file The world: a tree of named objects with constant properties. It knows no algorithm and reads no file.

#include <any>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/math/transform.h"
#include "murosimf/world/diagnostics.h"
#include "murosimf/world/property.h"

namespace murosimf {

/// Number of an object in its world; stays valid for the world's life.
struct ObjectId {
  int index = -1;
  bool valid() const { return index >= 0; }
  friend auto operator<=>(const ObjectId&, const ObjectId&) = default;
};

/// A property's value as somebody wrote it in a file: numbers or text, not yet of the property's type.
struct WrittenValue {
  std::vector<double> numbers;
  std::string text;
};

/// One constant of one object: a value of the property's type or a WrittenValue, and where it came from.
struct ConstantEntry {
  std::any value;
  SourceLocation where;
};

/// Turns a written value into T; nothing when the count of numbers or the kind does not fit.
template <class T>
std::optional<T> fromWritten(const WrittenValue& written) {
  if constexpr (std::is_same_v<T, double>) {
    if (written.numbers.size() == 1) return written.numbers[0];
  } else if constexpr (std::is_same_v<T, Vector3>) {
    if (written.numbers.size() == 3) return Vector3{written.numbers[0], written.numbers[1], written.numbers[2]};
  } else if constexpr (std::is_same_v<T, std::string>) {
    if (written.numbers.empty()) return written.text;
  }
  return std::nullopt;
}

/// Objects, their names, groups and constants. Built once; const while a simulation runs.
class World {
 public:
  World();

  ObjectId root() const { return {0}; }
  /// Adds an object below a parent. Its path is the parent's path, a dot and the name ("robots.red.1.trunk").
  /// @throws std::invalid_argument when the path exists already or the name is empty.
  ObjectId add(ObjectId parent, std::string_view name);
  /// Finds or adds the objects along a dotted path.
  ObjectId addPath(std::string_view path);

  int objectCount() const { return static_cast<int>(objects_.size()); }
  const std::string& path(ObjectId id) const { return at(id).path; }
  ObjectId parent(ObjectId id) const { return at(id).parent; }
  /// The object with this path; invalid when there is none.
  ObjectId find(std::string_view path) const;
  std::vector<std::string> paths() const;

  /// Declares a group of objects of an assembly, in this order.
  void defineSubset(ObjectId assembly, std::string_view name, std::vector<ObjectId> members);
  /// The group's members; `self` is the assembly alone, `world` the root; empty when the assembly has no such group.
  std::span<const ObjectId> members(ObjectId assembly, std::string_view subset_name) const;

  /// Sets a constant, replacing an earlier value.
  template <class T>
  void set(ObjectId id, const Constant<T>& property, T value, SourceLocation where = {}) {
    at(id).constants.insert_or_assign(std::string(property.name), ConstantEntry{std::move(value), std::move(where)});
  }
  /// Sets a constant by name, as written in a file; its type is checked when a module needs it.
  void setWritten(ObjectId id, std::string_view property, WrittenValue value, SourceLocation where);

  /// The constant's value, or nothing when it is missing or was written with another type.
  template <class T>
  std::optional<T> find(ObjectId id, const Constant<T>& property) const {
    const ConstantEntry* entry = findEntry(id, property.name);
    if (entry == nullptr) return std::nullopt;
    if (const T* value = std::any_cast<T>(&entry->value)) return *value;
    if (const auto* written = std::any_cast<WrittenValue>(&entry->value)) return fromWritten<T>(*written);
    return std::nullopt;
  }
  /// Same, for values too large to copy: a pointer that stays valid, or null.
  template <class T>
  const T* findShared(ObjectId id, const Constant<T>& property) const {
    const ConstantEntry* entry = findEntry(id, property.name);
    return entry == nullptr ? nullptr : std::any_cast<T>(&entry->value);
  }
  const ConstantEntry* findEntry(ObjectId id, std::string_view property) const;
  const std::map<std::string, ConstantEntry, std::less<>>& constants(ObjectId id) const { return at(id).constants; }

 private:
  struct Object {
    std::string path;
    ObjectId parent, self;
    std::map<std::string, ConstantEntry, std::less<>> constants;
    std::map<std::string, std::vector<ObjectId>, std::less<>> subsets;
  };
  Object& at(ObjectId id) { return objects_.at(static_cast<std::size_t>(id.index)); }
  const Object& at(ObjectId id) const { return objects_.at(static_cast<std::size_t>(id.index)); }

  std::vector<Object> objects_;
  std::map<std::string, ObjectId, std::less<>> by_path_;
};

}  // namespace murosimf
