#include "murosimf/linking/linker_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "murosimf/linking/schedule.h"

namespace murosimf {

bool Linker::Planned::adds(const DeclaredProperty& property) const {
  const auto& own = declaration.properties();
  return std::any_of(own.begin(), own.end(), [&](const DeclaredProperty& p) {
    return p.access == Access::kAdds && p.name == property.name && p.subset == property.subset;
  });
}

namespace {

/// The period in frames. Reports a period that is no whole number of frames.
int periodInFrames(const Assignment& assignment, const ParameterValues& values, double frame,
                   Diagnostics& diagnostics) {
  const double period = values["period"];
  if (period == 0) return 1;
  const double frames = std::round(period / frame);
  if (frames < 1 || std::abs(frames * frame - period) > 1e-9 * period) {
    diagnostics.error(assignment.where,
                      fmt::format("period of module {} is {} s; expected a multiple of the frame length, {} s",
                                  assignment.module, period, frame));
    return 1;
  }
  return static_cast<int>(frames);
}

}  // namespace

std::vector<Linker::Assembly> Linker::plan(Diagnostics& diagnostics) const {
  std::vector<Assembly> assemblies;
  const auto assemblyOf = [&](ObjectId id) -> Assembly& {
    for (Assembly& a : assemblies) {
      if (a.id == id) return a;
    }
    assemblies.push_back({id, {}});
    return assemblies.back();
  };
  for (const Assignment& assignment : assignments_) {
    const ModuleEntry* entry = registry_.find(assignment.module);
    if (entry == nullptr) {
      diagnostics.error(assignment.where,
                        fmt::format("{}: unknown module \"{}\"; expected one of {}{}", world_.path(assignment.assembly),
                                    assignment.module, fmt::join(registry_.names(), ", "),
                                    didYouMean(assignment.module, registry_.names())));
      continue;
    }
    Planned planned;
    planned.name = assignment.module;
    planned.parameters = resolveParameters(entry->name, entry->parameters, assignment.parameters, diagnostics);
    planned.module = entry->create(planned.parameters);
    planned.module->declare(planned.declaration);
    planned.where = assignment.where;
    planned.period = periodInFrames(assignment, planned.parameters, options_.frame_length, diagnostics);
    assemblyOf(assignment.assembly).modules.push_back(std::move(planned));
  }
  for (const Attachment& attachment : attachments_) {
    for (const ObjectId id : attachment.assemblies) {
      Planned planned;
      planned.name = attachment.name;
      attachment.module->declare(planned.declaration);
      assemblyOf(id).modules.push_back(std::move(planned));
    }
  }
  std::sort(assemblies.begin(), assemblies.end(),
            [&](const Assembly& a, const Assembly& b) { return world_.path(a.id) < world_.path(b.id); });
  return assemblies;
}

void Linker::checkConstant(const Assembly& assembly, const Planned& module, const DeclaredProperty& property,
                           Diagnostics& diagnostics) const {
  for (const ObjectId object : world_.members(assembly.id, property.subset)) {
    std::vector<double> numbers;
    if (property.numbers(world_, object, property.name, numbers)) continue;
    const ConstantEntry* entry = world_.findEntry(object, property.name);
    if (entry != nullptr) {
      diagnostics.error(entry->where,
                        fmt::format("property {} of {} has another type than module {} expects: {} number{} in {}",
                                    property.name, world_.path(object), module.name, property.components,
                                    property.components == 1 ? "" : "s", property.unit));
    } else if (property.access == Access::kNeeds) {
      diagnostics.error(module.where, fmt::format("{}: module {} needs property {} [{}] ({}) of {}, which has none",
                                                  world_.path(assembly.id), module.name, property.name, property.unit,
                                                  property.meaning, world_.path(object)));
    }
  }
}

void Linker::checkAssembly(const Assembly& assembly, Diagnostics& diagnostics) const {
  for (const Planned& module : assembly.modules) {
    for (const DeclaredProperty& property : module.declaration.properties()) {
      if (property.access == Access::kNeeds || property.access == Access::kUses) {
        checkConstant(assembly, module, property, diagnostics);
        continue;
      }
      std::vector<std::string> writers;
      for (const Planned& other : assembly.modules) {
        if (other.adds(property)) writers.push_back(other.name);
      }
      const std::string what = fmt::format("variable {} [{}] of {}'s {}", property.name, property.unit,
                                           world_.path(assembly.id), property.subset);
      if (writers.empty()) {
        diagnostics.error(module.where, fmt::format("module {} reads {}, which no module writes", module.name, what));
      } else if (writers.size() > 1 && property.access == Access::kAdds && writers.front() == module.name) {
        diagnostics.error(module.where, fmt::format("{} is written by {} modules: {}; expected one", what,
                                                    writers.size(), fmt::join(writers, ", ")));
      }
    }
  }
}

void Linker::checkWrittenProperties(Diagnostics& diagnostics) const {
  std::vector<std::string> known = known_constants_;
  const auto learn = [&](const Module& module) {
    Declaration declaration;
    module.declare(declaration);
    for (const DeclaredProperty& p : declaration.properties()) {
      if (p.access == Access::kNeeds || p.access == Access::kUses) known.emplace_back(p.name);
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

bool Linker::sameStructure(const Assembly& a, const Assembly& b) const {
  if (a.modules.size() != b.modules.size()) return false;
  for (std::size_t i = 0; i < a.modules.size(); ++i) {
    const Planned &x = a.modules[i], &y = b.modules[i];
    if (x.name != y.name || x.outside() != y.outside() || x.parameters != y.parameters || x.period != y.period) {
      return false;
    }
    for (const DeclaredProperty& p : x.declaration.properties()) {
      const auto members_a = world_.members(a.id, p.subset), members_b = world_.members(b.id, p.subset);
      if (members_a.size() != members_b.size()) return false;
      if (!p.structural) continue;
      for (std::size_t k = 0; k < members_a.size(); ++k) {
        if (!p.equal(world_, members_a[k], members_b[k], p.name)) return false;
      }
    }
  }
  return true;
}

}  // namespace murosimf
