#pragma once

/// @file The linker's notes about one assembly, between reading the assignments and laying out memory.

#include "murosimf/linking/linker.h"

namespace murosimf {

/// A module of one assembly. Attachments stand here too, with no block module of their own.
struct Linker::Planned {
  std::string name;
  std::unique_ptr<BlockModule> module;  ///< null for attachments
  const Module* attached = nullptr;     ///< of attachments
  Declaration declaration;
  ParameterValues parameters;
  SourceLocation where;
  int period = 1;  ///< in frames
  bool scheduled = true;

  bool outside() const { return module == nullptr; }
  /// The line with which it writes a column; null when it does not.
  const DeclaredProperty* added(std::string_view property, std::string_view of) const;
  const DeclaredProperty* added(const DeclaredProperty& property) const {
    return added(property.name, property.subset);
  }
};

struct Linker::Assembly {
  ObjectId id;
  int level = 0;
  int batch = -1;  ///< once it has one
  std::vector<Planned> modules;
  /// A module of it could not be made. Every module that reads it would miss it: one mistake, one error.
  bool incomplete = false;

  /// Where to point at for a fault of a module: its assignment, or for attachments the assembly's first one.
  const SourceLocation& whereOf(const Planned& module) const;
};

}  // namespace murosimf
