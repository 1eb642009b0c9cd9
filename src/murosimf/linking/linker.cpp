#include "murosimf/linking/linker.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <tuple>

#include "murosimf/linking/integrator.h"
#include "murosimf/linking/linker_plan.h"
#include "murosimf/linking/links.h"
#include "murosimf/linking/schedule.h"

namespace murosimf {

Linker::Linker(const World& world, const ModuleRegistry& registry, LinkOptions options)
    : world_(world), registry_(registry), options_(options) {
  if (!(options.frame_length > 0)) {
    throw std::invalid_argument(fmt::format("frame length {} s; expected a positive number", options.frame_length));
  }
  if (options.lanes != 0 && options.lanes != 1 && options.lanes != 4 && options.lanes != 8) {
    throw std::invalid_argument(fmt::format("{} lanes; expected 1, 4, 8, or 0 for a choice", options.lanes));
  }
}

namespace {

/// Puts the modules of one assembly into running order and marks those that nobody reads.
template <class Assembly>
void schedule(Assembly& assembly, const std::string& whose, Diagnostics& diagnostics) {
  std::vector<ScheduledModule> modules;
  for (const auto& p : assembly.modules) {
    modules.push_back({p.name, &p.declaration, p.outside(), assembly.whereOf(p), true});
  }
  dropUnread(modules);
  const std::vector<std::size_t> order = orderModules(modules, whose, diagnostics);
  decltype(assembly.modules) sorted;
  for (const std::size_t i : order) {
    assembly.modules[i].scheduled = modules[i].wanted;
    sorted.push_back(std::move(assembly.modules[i]));
  }
  assembly.modules = std::move(sorted);
}

std::string addedNames(const Declaration& declaration) {
  std::string names;
  for (const DeclaredProperty& p : declaration.properties()) {
    if (p.isWritten()) names += (names.empty() ? "" : ", ") + std::string(p.name);
  }
  return names;
}

}  // namespace

std::unique_ptr<LinkedWorld> Linker::link(Diagnostics& diagnostics) {
  const int before = diagnostics.errorCount();
  std::vector<Assembly> assemblies = plan(diagnostics);
  checkWrittenProperties(diagnostics);
  for (Assembly& assembly : assemblies) {
    if (assembly.incomplete) continue;
    checkAssembly(assembly, diagnostics);
    schedule(assembly, world_.path(assembly.id), diagnostics);
  }
  if (diagnostics.errorCount() > before) return nullptr;

  auto linked = std::make_unique<LinkedWorld>(options_.frame_length);
  std::vector<bool> placed(assemblies.size(), false);
  for (std::size_t i = 0; i < assemblies.size(); ++i) {
    if (placed[i]) continue;
    std::vector<Assembly*> members;
    for (std::size_t k = i; k < assemblies.size(); ++k) {
      // All levels of an assembly follow one another.
      const bool other_level = !members.empty() && members.back()->id == assemblies[k].id;
      if (placed[k] || other_level || !sameStructure(assemblies[i], assemblies[k])) continue;
      placed[k] = true;
      members.push_back(&assemblies[k]);
    }
    std::stable_sort(members.begin(), members.end(),
                     [](const Assembly* a, const Assembly* b) { return (a->level == 0) > (b->level == 0); });
    makeBatch(members, *linked, diagnostics);
  }
  std::stable_sort(linked->reports_.begin(), linked->reports_.end(), [](const PassReport& a, const PassReport& b) {
    return std::tie(a.assembly, a.level) < std::tie(b.assembly, b.level);
  });
  if (diagnostics.errorCount() > before) return nullptr;
  seat(assemblies, *linked);
  return linked;
}

/// Residents in the order of paths, each in the lane that is its own at the beginning.
void Linker::seat(const std::vector<Assembly>& assemblies, LinkedWorld& linked) {
  for (const Batch& batch : linked.batches_) linked.seats_.emplace_back(batch.members.size(), -1);
  for (const Assembly& assembly : assemblies) {
    if (assembly.level == 0) linked.residents_.emplace_back().assembly = assembly.id;
    Resident& resident = linked.residents_.back();
    resident.levels.push_back({assembly.batch, {}, {}});
    if (assembly.level > 0) continue;
    const std::vector<ObjectId>& members = linked.batches_[static_cast<std::size_t>(assembly.batch)].members;
    resident.lane = static_cast<int>(std::find(members.begin(), members.end(), assembly.id) - members.begin());
    linked.seats_[static_cast<std::size_t>(assembly.batch)][static_cast<std::size_t>(resident.lane)] =
        static_cast<int>(linked.residents_.size()) - 1;
  }
  linked.finishSeating();
}

int Linker::chooseWidth(std::size_t robots) const {
  const bool wide = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq");
  if (options_.lanes == 1 || options_.lanes == 4) return options_.lanes;
  if (options_.lanes == 8 && wide) return 8;
  if (robots == 1) return 1;
  return robots <= 4 || !wide ? 4 : 8;
}

void Linker::makeBatch(const std::vector<Assembly*>& members, LinkedWorld& linked, Diagnostics& diagnostics) const {
  Batch& batch = linked.batches_.emplace_back();
  batch.width = chooseWidth(members.size());
  const int number = static_cast<int>(linked.batches_.size()) - 1;
  for (std::size_t i = 0; i < members.size(); ++i) {
    batch.members.push_back(members[i]->id);
    members[i]->batch = number;
    if (members[i]->level == 0) ++batch.seated;
    for (const Planned& p : members[i]->modules) {
      if (p.outside()) continue;
      linked.reports_.push_back({world_.path(members[i]->id), members[i]->level, p.name, p.declaration.phase(),
                                 p.period * options_.frame_length, p.scheduled,
                                 p.scheduled ? "" : addedNames(p.declaration)});
    }
  }
  layOut(members, batch);
  linkPasses(*members.front(), batch, diagnostics);
}

namespace {

/// Reserves room for a column behind the others of its memory.
void append(Batch& batch, const DeclaredProperty& p, MemoryKind memory, std::size_t& size, int objects) {
  batch.columns.push_back({std::string(p.name),
                           std::string(p.unit),
                           std::string(p.subset),
                           {static_cast<int>(size), memory},
                           objects,
                           p.components,
                           p.storage,
                           p.initial});
  size += static_cast<std::size_t>(objects) * static_cast<std::size_t>(p.components);
}

void fillInitial(const Batch& batch) {
  for (const ColumnLayout& column : batch.columns) {
    if (column.ref.memory != MemoryKind::kState) continue;
    for (std::size_t b = 0; b < batch.state.size(); ++b) {
      double* at = batch.state[b].data() + column.ref.offset * batch.width;
      for (int i = 0; i < column.objects; ++i) {
        for (const double value : column.initial) at = std::fill_n(at, batch.width, value);
      }
    }
  }
}

}  // namespace

void Linker::layOut(const std::vector<Assembly*>& members, Batch& batch) const {
  const Assembly& one = *members.front();
  std::vector<const DeclaredProperty*> variables, constants;
  for (const Planned& module : one.modules) {
    if (!module.scheduled) continue;
    for (const DeclaredProperty& p : module.declaration.properties()) {
      if (p.isConstant() && p.components > 0 && !module.outside()) constants.push_back(&p);
      if (p.isWritten()) variables.push_back(&p);
    }
  }
  const auto key = [](const DeclaredProperty* p) {  // sums first: they are cleared in one go; no frame reads the last
    return std::tuple(p->storage == Storage::kOnDemand, p->access != Access::kAccumulates, p->name, p->subset);
  };
  std::sort(variables.begin(), variables.end(),
            [&](const DeclaredProperty* a, const DeclaredProperty* b) { return key(a) < key(b); });
  variables.erase(std::unique(variables.begin(), variables.end(),
                              [](const DeclaredProperty* a, const DeclaredProperty* b) { return a->sameColumn(*b); }),
                  variables.end());
  for (const DeclaredProperty* p : variables) {
    const int objects = static_cast<int>(world_.members(one.id, p->subset).size());
    const bool step = p->storage == Storage::kStep;
    append(batch, *p, step ? MemoryKind::kStep : MemoryKind::kState, step ? batch.step_size : batch.state_size,
           objects);
    if (p->access == Access::kAccumulates) batch.sum_size = batch.step_size;
    if (p->storage != Storage::kOnDemand) batch.on_demand_size = batch.state_size;
  }
  batch.on_demand_size = batch.state_size - batch.on_demand_size;
  const std::size_t width = static_cast<std::size_t>(batch.width);
  const std::size_t blocks = (members.size() + width - 1) / width;
  batch.state = BlockPieces(blocks, batch.state_size * width);
  for (std::size_t b = 0; batch.on_demand_size > 0 && b < blocks; ++b)
    batch.answers.emplace_back(batch, static_cast<int>(b));
  fillInitial(batch);
  fillConstants(batch, constants);
}

void Linker::fillConstants(Batch& batch, const std::vector<const DeclaredProperty*>& constants) const {
  const auto valuesOf = [&](ObjectId robot, const DeclaredProperty& p) {
    std::vector<double> all, one;
    for (const ObjectId object : world_.members(robot, p.subset)) {
      if (!p.numbers(world_, object, p.name, one)) one = p.initial;
      all.insert(all.end(), one.begin(), one.end());
    }
    return all;
  };
  std::size_t shared_size = 0;
  std::vector<const DeclaredProperty*> laid_out;
  for (const DeclaredProperty* p : constants) {
    if (batch.column(p->name, p->subset) != nullptr) continue;
    const std::vector<double> first = valuesOf(batch.members.front(), *p);
    const bool equal = std::all_of(batch.members.begin(), batch.members.end(),
                                   [&](ObjectId robot) { return valuesOf(robot, *p) == first; });
    const int objects = static_cast<int>(world_.members(batch.members.front(), p->subset).size());
    append(batch, *p, equal ? MemoryKind::kSharedConstant : MemoryKind::kOwnConstant,
           equal ? shared_size : batch.own_size, objects);
    laid_out.push_back(p);
  }
  const std::size_t width = static_cast<std::size_t>(batch.width);
  batch.shared = AlignedDoubles(shared_size * width);
  batch.own = BlockPieces(batch.state.size(), batch.own_size * width);
  for (const DeclaredProperty* p : laid_out) {
    const ColumnLayout& column = *batch.column(p->name, p->subset);
    const bool own = column.ref.memory == MemoryKind::kOwnConstant;
    for (std::size_t lane = 0; lane < batch.state.size() * width; ++lane) {
      const ObjectId robot = batch.members[std::min(lane, batch.members.size() - 1)];
      double* base = own ? batch.own[lane / width].data() : batch.shared.data();
      const std::vector<double> values = valuesOf(robot, *p);
      for (std::size_t i = 0; i < values.size(); ++i) {
        base[(static_cast<std::size_t>(column.ref.offset) + i) * width + lane % width] = values[i];
      }
    }
  }
}

namespace {

/// What the integrators of a batch ask for: the evaluated modules that have been linked so far.
Evaluation evaluationOf(const Batch& batch) {
  std::vector<const BlockModule*> passes;
  for (const LinkedPass& pass : batch.passes) {
    if (pass.phase == Phase::kEvaluate) passes.push_back(pass.module.get());
  }
  return {std::move(passes), batch.sum_size, batch.width};
}

bool addsOnDemand(const Declaration& declaration) {
  const auto& properties = declaration.properties();
  return std::any_of(properties.begin(), properties.end(), [](const DeclaredProperty& p) {
    return p.access == Access::kAdds && p.storage == Storage::kOnDemand;
  });
}

}  // namespace

void Linker::linkPasses(Assembly& representative, Batch& batch, Diagnostics& diagnostics) const {
  for (Planned& planned : representative.modules) {
    if (planned.outside() || !planned.scheduled) continue;
    Links links(world_, batch, planned.declaration, planned.parameters);
    try {
      planned.module->link(links);
      // Numbers in which the batch's robots differ are seen here alone.
      for (int b = 0; b < batch.capacity(); ++b) planned.module->initialise(batch.block(b, nullptr));
    } catch (const std::invalid_argument& problem) {
      diagnostics.error(planned.where,
                        fmt::format("{}: module {}: {}", world_.path(representative.id), planned.name, problem.what()));
      continue;
    }
    if (auto* integrator = dynamic_cast<Integrator*>(planned.module.get())) integrator->use(evaluationOf(batch));
    batch.passes.push_back({std::move(planned.module), planned.name, planned.declaration.phase(), planned.period,
                            planned.period * options_.frame_length, true, addsOnDemand(planned.declaration)});
    for (ColumnLayout& column : batch.columns) {
      const DeclaredProperty* added = planned.added(column.property, column.subset);
      if (added != nullptr && added->access == Access::kAdds) column.writer = static_cast<int>(batch.passes.size()) - 1;
    }
  }
}

}  // namespace murosimf
