#pragma once

/// @file The linker's notes about one assembly, between reading the assignments and laying out memory.

#include "murosimf/linking/linker.h"

namespace murosimf {

/// A module of one assembly. Attachments stand here too, with no block module of their own.
struct Linker::Planned {
  std::string name;
  std::unique_ptr<BlockModule> module;  ///< null for attachments
  Declaration declaration;
  ParameterValues parameters;
  SourceLocation where;
  int period = 1;  ///< in frames
  bool scheduled = true;

  bool outside() const { return module == nullptr; }
  bool adds(const DeclaredProperty& property) const;
};

struct Linker::Assembly {
  ObjectId id;
  std::vector<Planned> modules;
};

}  // namespace murosimf
