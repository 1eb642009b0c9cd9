// What the linker refuses, and in which words.

#include <fmt/format.h>

#include <algorithm>

#include "murosimf/linking/integrator.h"
#include "murosimf/linking/linker_plan.h"
#include "murosimf/linking/schedule.h"

namespace murosimf {

namespace {

/// Evaluations run inside of the integrator's step.
Phase partOfFrame(const Declaration& declaration) {
  return declaration.phase() == Phase::kEvaluate ? Phase::kAdvance : declaration.phase();
}

std::string kindOf(const DeclaredProperty& p) {
  const char* kind = p.isConstant() ? "constant" : "variable";
  if (p.components == 0) return fmt::format("{} that is no set of numbers", kind);
  return fmt::format("{} of {} number{}", kind, p.components, p.components == 1 ? "" : "s");
}

std::string unitOf(const DeclaredProperty& p) { return p.unit.empty() ? "" : fmt::format(" [{}]", p.unit); }

}  // namespace

void Linker::checkIntegrator(const Assembly& assembly, Diagnostics& diagnostics) const {
  const auto evaluated = std::find_if(assembly.modules.begin(), assembly.modules.end(), [](const Planned& module) {
    return module.declaration.phase() == Phase::kEvaluate;
  });
  const bool asked = std::any_of(assembly.modules.begin(), assembly.modules.end(), [](const Planned& module) {
    return dynamic_cast<const Integrator*>(module.module.get()) != nullptr;
  });
  if (asked || evaluated == assembly.modules.end()) return;
  std::vector<std::string_view> names;
  for (const ModuleEntry& entry : registry_.entries()) {
    if (dynamic_cast<const Integrator*>(makeDefault(entry).get()) != nullptr) names.push_back(entry.name);
  }
  diagnostics.error(evaluated->where, fmt::format("{}: module {} runs when an integrator asks for it, and there is none"
                                                  "{}{}",
                                                  world_.path(assembly.id), evaluated->name,
                                                  names.empty() ? "" : "; expected ", fmt::join(names, " or ")));
}

void Linker::checkAssembly(const Assembly& assembly, Diagnostics& diagnostics) const {
  checkIntegrator(assembly, diagnostics);
  for (const Planned& module : assembly.modules) {
    for (const DeclaredProperty& property : module.declaration.properties()) {
      checkMeaning(assembly, module, property, diagnostics);
      if (property.isConstant()) checkConstant(assembly, module, property, diagnostics);
      if (property.isRead()) checkReader(assembly, module, property, diagnostics);
      if (property.isWritten()) checkWriter(assembly, module, property, diagnostics);
    }
  }
}

void Linker::checkConstant(const Assembly& assembly, const Planned& module, const DeclaredProperty& property,
                           Diagnostics& diagnostics) const {
  for (const ObjectId object : world_.members(assembly.id, property.subset)) {
    std::vector<double> numbers;
    if (property.numbers(world_, object, property.name, numbers)) continue;
    const ConstantEntry* entry = world_.findEntry(object, property.name);
    if (entry != nullptr) {
      diagnostics.error(entry->where,
                        fmt::format("property {} of {} has another type than module {} expects: a {}{}", property.name,
                                    world_.path(object), module.name, kindOf(property), unitOf(property)));
    } else if (property.access == Access::kNeeds) {
      diagnostics.error(
          assembly.whereOf(module),
          fmt::format("{}: module {} needs property {}{} ({}) of {}, which has none", world_.path(assembly.id),
                      module.name, property.name, unitOf(property), property.meaning, world_.path(object)));
    }
  }
}

void Linker::checkWriter(const Assembly& assembly, const Planned& module, const DeclaredProperty& property,
                         Diagnostics& diagnostics) const {
  std::vector<const Planned*> writers;
  for (const Planned& other : assembly.modules) {
    if (other.added(property) != nullptr) writers.push_back(&other);
  }
  const bool all_add_to_it = std::all_of(writers.begin(), writers.end(), [&](const Planned* writer) {
    return writer->added(property)->access == Access::kAccumulates;
  });
  if (writers.size() < 2 || all_add_to_it || writers.front() != &module)
    return;  // reported once, where the first one stands
  std::vector<std::string> names;
  for (const Planned* writer : writers) names.push_back(writer->name);
  diagnostics.error(
      assembly.whereOf(module),
      fmt::format("{}: variable {}{} of {} is written by {} modules: {}; expected one", world_.path(assembly.id),
                  property.name, unitOf(property), property.subset, writers.size(), fmt::join(names, ", ")));
}

std::string Linker::modulesThatAdd(const DeclaredProperty& property) const {
  std::vector<std::string_view> names;
  for (const ModuleEntry& entry : registry_.entries()) {
    Declaration declaration;
    makeDefault(entry)->declare(declaration);
    for (const DeclaredProperty& p : declaration.properties()) {
      if (p.isWritten() && p.sameColumn(property)) names.push_back(entry.name);
    }
  }
  return names.empty() ? "" : fmt::format("; expected {}", fmt::join(names, " or "));
}

void Linker::checkReader(const Assembly& assembly, const Planned& module, const DeclaredProperty& property,
                         Diagnostics& diagnostics) const {
  const auto writer = std::find_if(assembly.modules.begin(), assembly.modules.end(),
                                   [&](const Planned& other) { return other.added(property) != nullptr; });
  const std::string start = fmt::format("{}: module {} reads variable {}{} of {}", world_.path(assembly.id),
                                        module.name, property.name, unitOf(property), property.subset);
  const SourceLocation& where = assembly.whereOf(module);
  if (writer == assembly.modules.end()) {
    if (property.access == Access::kReadsIfAdded) return;
    diagnostics.error(where, fmt::format("{}, which no module writes{}", start, modulesThatAdd(property)));
    return;
  }
  const bool together = !module.outside() && !writer->outside() && module.period == writer->period &&
                        partOfFrame(module.declaration) == partOfFrame(writer->declaration);
  const bool lasting = writer->added(property)->storage != Storage::kStep;
  if (!module.outside() && writer->added(property)->storage == Storage::kOnDemand) {
    diagnostics.error(where,
                      fmt::format("{}, which is computed only when somebody outside of the modules asks; expected "
                                  "a variable that is kept",
                                  start));
  } else if (!lasting && (!together || property.access == Access::kReadsLast)) {
    diagnostics.error(where, fmt::format("{}, which lives only while {} and what runs with it step (phase {}, every {} "
                                         "frame{}); expected a variable that is kept",
                                         start, writer->name, wordFor(writer->declaration.phase()), writer->period,
                                         writer->period == 1 ? "" : "s"));
  } else if (property.in_step && !writer->outside() && module.period != writer->period) {
    diagnostics.error(where, fmt::format("{} in step with {}, but every {} s instead of {} s; expected equal periods",
                                         start, writer->name, module.period * options_.frame_length,
                                         writer->period * options_.frame_length));
  }
}

void Linker::checkMeaning(const Assembly& assembly, const Planned& module, const DeclaredProperty& property,
                          Diagnostics& diagnostics) const {
  for (const Planned& other : assembly.modules) {
    if (&other == &module) return;  // every pair once
    for (const DeclaredProperty& p : other.declaration.properties()) {
      if (p.name != property.name) continue;
      const bool alike = p.isConstant() == property.isConstant() && p.components == property.components;
      const bool defaults_agree =
          p.access != Access::kUses || property.access != Access::kUses || p.initial == property.initial;
      if (alike && defaults_agree) continue;
      diagnostics.error(assembly.whereOf(module),
                        fmt::format("{}: property {} is a {} for module {} and a {}{} for module {}; expected one "
                                    "meaning",
                                    world_.path(assembly.id), property.name, kindOf(property), module.name, kindOf(p),
                                    alike ? " with another default" : "", other.name));
      return;
    }
  }
}

void Linker::checkWrittenProperties(Diagnostics& diagnostics) const {
  std::vector<std::string> known = known_constants_;
  const auto learn = [&](const Module& module) {
    Declaration declaration;
    module.declare(declaration);
    for (const DeclaredProperty& p : declaration.properties()) {
      if (p.isConstant()) known.emplace_back(p.name);
    }
  };
  for (const ModuleEntry& entry : registry_.entries()) learn(*makeDefault(entry));
  for (const Attachment& attachment : attachments_) learn(*attachment.module);
  for (int i = 0; i < world_.objectCount(); ++i) {
    for (const auto& [name, entry] : world_.constants({i})) {
      if (std::any_cast<WrittenValue>(&entry.value) == nullptr) continue;
      if (std::find(known.begin(), known.end(), name) != known.end()) continue;
      diagnostics.error(entry.where, fmt::format("unknown property \"{}\" of {}: no module declares it{}", name,
                                                 world_.path({i}), didYouMean(name, known)));
    }
  }
}

}  // namespace murosimf
