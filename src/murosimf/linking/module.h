#pragma once

/// @file Modules: algorithms that can be linked to objects.

#include <memory>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "murosimf/linking/block_memory.h"
#include "murosimf/linking/declaration.h"
#include "murosimf/linking/parameters.h"

namespace murosimf {

class Links;

/// Anything that takes and gives properties.
class Module {
 public:
  Module() = default;
  Module(const Module&) = delete;
  Module& operator=(const Module&) = delete;
  virtual ~Module() = default;
  /// Says what this module takes and gives. Touches no world, so it can be listed and checked without one.
  virtual void declare(Declaration& declaration) const = 0;
};

/// A module that steps robots, a block of them at a time. One instance serves one batch: robots of the same structure
/// with the same modules and parameters.
class BlockModule : public Module {
 public:
  /// Binds the columns of the batch, once. The only place where names are looked up.
  virtual void link(Links& links) = 0;
  /// Gives the variables it adds their first values where zero (or the identity pose) will not do.
  virtual void initialise(const BlockMemory& block) const { static_cast<void>(block); }
  /// Called when a robot came from another level of detail: its variables that both levels have hold what they held,
  /// all others their first values. Makes of them a state from which to go on. `one` is the memory of this robot alone,
  /// of width 1.
  virtual void adopt(const BlockMemory& one) const { static_cast<void>(one); }
  /// Makes one step of all robots of one block. Called from any thread, for different blocks at once: const.
  virtual void step(const BlockMemory& block, const StepTime& time) const = 0;
  /// Computes the variables that it adds on demand (Storage::kOnDemand) from what its last step left in state. There is
  /// no step memory.
  virtual void answer(const BlockMemory& block) const { static_cast<void>(block); }
};

/// Copies a column of `numbers` per lane to another one of the same block: first values from a constant, for example.
void copyColumn(const BlockMemory& block, ColumnRef from, ColumnRef to, int numbers, int width);

/// One entry of the list of modules that a scenario may name.
struct ModuleEntry {
  std::string_view name;                  ///< "kinematic_walking"
  std::string_view concern;               ///< what it is an exchangeable part of: "motion", "actuation", "sensing", ...
  std::string_view summary;               ///< one line for people
  std::vector<ParameterInfo> parameters;  ///< of the method; the registry puts `period` before them
  std::unique_ptr<BlockModule> (*create)(const ParameterValues&) = nullptr;
};

/// The modules that can be linked by name. A program may add its own to those of allModules().
class ModuleRegistry {
 public:
  /// @throws std::invalid_argument when the name is taken.
  void add(ModuleEntry entry);
  /// Adds the module class M, made from its parameters where it has a constructor that takes them.
  template <class M>
  void add(std::string_view name, std::string_view concern, std::string_view summary,
           std::vector<ParameterInfo> parameters = {}) {
    add(ModuleEntry{name, concern, summary, std::move(parameters), &create<M>});
  }
  const ModuleEntry* find(std::string_view name) const;
  const std::vector<ModuleEntry>& entries() const { return entries_; }
  std::vector<std::string> names() const;

 private:
  template <class M>
  static std::unique_ptr<BlockModule> create(const ParameterValues& values) {
    if constexpr (std::is_constructible_v<M, const ParameterValues&>) {
      return std::make_unique<M>(values);
    } else {
      return std::make_unique<M>();
    }
  }
  std::vector<ModuleEntry> entries_;
};

}  // namespace murosimf
