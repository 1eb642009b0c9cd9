#pragma once

/// @file Units and meanings of properties, from the declarations of all modules, and values in words.

#include <map>
#include <string>
#include <vector>

#include "murosimf/simulation/simulation.h"

namespace murosimf {

struct PropertyWord {
  std::string unit, meaning;
};

/// By the property's name.
using PropertyWords = std::map<std::string, PropertyWord, std::less<>>;
PropertyWords propertyWords(const ModuleRegistry& modules, const Participants& participants);

/// "0.125", "1 0 0", "box, ellipsoid, 12 more"; "" for types that have no words.
std::string wordsOf(const ConstantEntry& entry);

/// Names of the components of a variable of so many numbers: "", "x", "R yx", "p z", or their numbers.
std::string componentName(int components, int component);

/// Unit of one of its components: a rotation's numbers have none, though a pose is in metres.
std::string componentUnit(const std::string& unit, int components, int component);

/// A variable of an object: whose column it is, and which of its members.
struct ObjectVariable {
  ObjectId assembly;
  const ColumnLayout* layout = nullptr;
  const Place* place = nullptr;
  int object = 0;
};
/// All variables that an object has at its assembly's present level of detail, in the order of names.
std::vector<ObjectVariable> variablesOf(const World& world, const LinkedWorld& linked, ObjectId object);

}  // namespace murosimf
