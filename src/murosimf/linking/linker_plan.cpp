#include "murosimf/linking/linker_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <tuple>

namespace murosimf {

const DeclaredProperty* Linker::Planned::added(std::string_view property, std::string_view of) const {
  for (const DeclaredProperty& p : declaration.properties()) {
    if (p.isWritten() && p.name == property && p.subset == of) return &p;
  }
  return nullptr;
}

const SourceLocation& Linker::Assembly::whereOf(const Planned& module) const {
  return module.outside() ? modules.front().where : module.where;
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

std::optional<Linker::Planned> Linker::planModule(const Assignment& assignment, Diagnostics& diagnostics) const {
  const std::string& whose = world_.path(assignment.assembly);
  const ModuleEntry* entry = registry_.find(assignment.module);
  if (entry == nullptr) {
    diagnostics.error(assignment.where, fmt::format("{}: unknown module \"{}\"; expected one of {}{}", whose,
                                                    assignment.module, fmt::join(registry_.names(), ", "),
                                                    didYouMean(assignment.module, registry_.names())));
    return std::nullopt;
  }
  Planned planned;
  planned.name = assignment.module;
  planned.where = assignment.where;
  planned.parameters = resolveParameters(entry->name, entry->parameters, assignment.parameters, diagnostics);
  planned.period = periodInFrames(assignment, planned.parameters, options_.frame_length, diagnostics);
  try {
    planned.module = entry->create(planned.parameters);
  } catch (const std::invalid_argument& problem) {
    diagnostics.error(assignment.where, fmt::format("{}: module {}: {}", whose, planned.name, problem.what()));
    return std::nullopt;
  }
  planned.declaration = Declaration(planned.period * options_.frame_length);
  planned.module->declare(planned.declaration);
  return planned;
}

void Linker::attach(const Attachment& attachment, Assembly& assembly) {
  std::vector<Planned>& modules = assembly.modules;
  const bool known =
      std::any_of(modules.begin(), modules.end(), [&](const Planned& p) { return p.attached == attachment.module; });
  if (known) return;
  Planned& planned = modules.emplace_back();
  planned.name = attachment.name;
  planned.attached = attachment.module;
  attachment.module->declare(planned.declaration);
}

/// Puts modules that follow a variable into its writer's phase.
void Linker::choosePhases(Assembly& assembly) {
  for (Planned& follower : assembly.modules) {
    const std::string_view followed = follower.declaration.followed();
    if (followed.empty()) continue;
    for (const Planned& writer : assembly.modules) {
      for (const DeclaredProperty& p : writer.declaration.properties()) {
        if (p.access == Access::kAdds && p.name == followed) follower.declaration.runsIn(writer.declaration.phase());
      }
    }
  }
}

std::vector<Linker::Assembly> Linker::plan(Diagnostics& diagnostics) const {
  std::map<std::pair<ObjectId, int>, Assembly> found;  // by level of each object
  const auto assemblyOf = [&](ObjectId id, int level) -> Assembly& {
    return found.try_emplace({id, level}, Assembly{id, level, -1, {}, false}).first->second;
  };
  for (const Assignment& assignment : assignments_) {
    std::optional<Planned> planned = planModule(assignment, diagnostics);
    assemblyOf(assignment.assembly, 0);
    Assembly& assembly = assemblyOf(assignment.assembly, assignment.level);
    if (planned) assembly.modules.push_back(std::move(*planned));
    if (!planned) assembly.incomplete = true;
  }
  for (const Attachment& attachment : attachments_) {
    for (const ObjectId id : attachment.assemblies) {
      assemblyOf(id, 0);
      for (auto level = found.find({id, 0}); level != found.end() && level->first.first == id; ++level)
        attach(attachment, level->second);
    }
  }
  std::vector<Assembly> assemblies;
  for (auto& [key, assembly] : found) {
    choosePhases(assembly);
    assemblies.push_back(std::move(assembly));
  }
  std::sort(assemblies.begin(), assemblies.end(), [&](const Assembly& a, const Assembly& b) {
    return std::tie(world_.path(a.id), a.level) < std::tie(world_.path(b.id), b.level);
  });
  return assemblies;
}

bool Linker::sameStructure(const Assembly& a, const Assembly& b) const {
  if (a.modules.size() != b.modules.size()) return false;
  for (std::size_t i = 0; i < a.modules.size(); ++i) {
    const Planned &x = a.modules[i], &y = b.modules[i];
    if (x.name != y.name || x.attached != y.attached || x.parameters != y.parameters || x.period != y.period) {
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
