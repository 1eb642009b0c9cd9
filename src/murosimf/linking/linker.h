#pragma once

/// @file Linking: brings objects and algorithms together, once, before the first frame.
///
/// Checks that every constant a module needs is there, that every variable read has exactly one writer and that no loop
/// is closed but by readsLast; puts modules in an order in which writers come before readers; leaves out those whose
/// results nobody reads; groups robots of equal structure into batches; lays out their columns.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "murosimf/linking/linked_world.h"

namespace murosimf {

struct LinkOptions {
  double frame_length = 1e-3;  ///< [s]
  int lanes = 0;               ///< robots per block: 1, 4 or 8; 0: chosen by their number and the processor
};

/// "This assembly is stepped by this module."
struct Assignment {
  ObjectId assembly;
  std::string module;
  WrittenParameters parameters;
  SourceLocation where;
  /// An assembly that may be exchanged has several levels of detail, each with modules of its own; it begins with 0.
  int level = 0;
};

/// Something outside the blocks that takes or gives properties of assemblies: a port, a camera, the pair phase; at all
/// levels of detail.
struct Attachment {
  std::string name;
  const Module* module = nullptr;
  std::vector<ObjectId> assemblies;
};

class Linker {
 public:
  /// @throws std::invalid_argument for a frame length that is not positive or lanes other than 0, 1, 4, 8.
  Linker(const World& world, const ModuleRegistry& registry, LinkOptions options);

  void assign(Assignment assignment) { assignments_.push_back(std::move(assignment)); }
  /// Attaching the same module to an assembly twice counts once.
  void attach(Attachment attachment) { attachments_.push_back(std::move(attachment)); }
  /// Constants that may be set on objects although no module declares them (used by readers and builders).
  void alsoKnows(std::vector<std::string> constants) { known_constants_ = std::move(constants); }

  /// Links everything. Reports all errors; returns null when there is one.
  std::unique_ptr<LinkedWorld> link(Diagnostics& diagnostics);

 private:
  struct Planned;   // a module of one assembly, before batches are formed
  struct Assembly;  // an assembly with its planned modules in order

  std::vector<Assembly> plan(Diagnostics& diagnostics) const;
  std::optional<Planned> planModule(const Assignment& assignment, Diagnostics& diagnostics) const;
  static void attach(const Attachment& attachment, Assembly& assembly);
  static void choosePhases(Assembly& assembly);
  void checkAssembly(const Assembly& assembly, Diagnostics& diagnostics) const;
  void checkIntegrator(const Assembly& assembly, Diagnostics& diagnostics) const;
  void checkConstant(const Assembly& assembly, const Planned& module, const DeclaredProperty& property,
                     Diagnostics& diagnostics) const;
  void checkWriter(const Assembly& assembly, const Planned& module, const DeclaredProperty& property,
                   Diagnostics& diagnostics) const;
  void checkReader(const Assembly& assembly, const Planned& module, const DeclaredProperty& property,
                   Diagnostics& diagnostics) const;
  void checkMeaning(const Assembly& assembly, const Planned& module, const DeclaredProperty& property,
                    Diagnostics& diagnostics) const;
  void checkWrittenProperties(Diagnostics& diagnostics) const;
  std::string modulesThatAdd(const DeclaredProperty& property) const;
  bool sameStructure(const Assembly& a, const Assembly& b) const;
  void makeBatch(const std::vector<Assembly*>& members, LinkedWorld& linked, Diagnostics& diagnostics) const;
  static void seat(const std::vector<Assembly>& assemblies, LinkedWorld& linked);
  void layOut(const std::vector<Assembly*>& members, Batch& batch) const;
  void fillConstants(Batch& batch, const std::vector<const DeclaredProperty*>& constants) const;
  void linkPasses(Assembly& representative, Batch& batch, Diagnostics& diagnostics) const;
  int chooseWidth(std::size_t robots) const;

  const World& world_;
  const ModuleRegistry& registry_;
  LinkOptions options_;
  std::vector<Assignment> assignments_;
  std::vector<Attachment> attachments_;
  std::vector<std::string> known_constants_;
};

}  // namespace murosimf
