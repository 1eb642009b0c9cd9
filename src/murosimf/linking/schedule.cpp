#include "murosimf/linking/schedule.h"

#include <fmt/format.h>

#include <algorithm>

namespace murosimf {

namespace {

bool adds(const Declaration& d, const DeclaredProperty& p) {
  return std::any_of(d.properties().begin(), d.properties().end(),
                     [&](const DeclaredProperty& q) { return q.isWritten() && q.sameColumn(p); });
}

/// True for the state that an integrator steps and that evaluations read: they run inside of its step.
bool isStateOfTheMoment(const ScheduledModule& writer, const ScheduledModule& reader, const DeclaredProperty& p) {
  return reader.declaration->phase() == Phase::kEvaluate && writer.declaration->phase() == Phase::kAdvance &&
         p.storage == Storage::kState;
}

/// The first variable that `reader` reads and `writer` writes before; null when there is none.
const DeclaredProperty* link(const ScheduledModule& writer, const ScheduledModule& reader) {
  for (const DeclaredProperty& p : reader.declaration->properties()) {
    const bool now = p.access == Access::kReads || p.access == Access::kReadsIfAdded;
    if (now && adds(*writer.declaration, p) && !isStateOfTheMoment(writer, reader, p)) return &p;
  }
  return nullptr;
}

/// Depth-first search that appends a module after all its writers.
struct Search {
  const std::vector<ScheduledModule>& modules;
  const std::string& whose;
  Diagnostics& diagnostics;
  std::vector<int> mark;  // 0 new, 1 on the path, 2 done
  std::vector<std::size_t> path, order;

  void visit(std::size_t i) {
    if (mark[i] == 2) return;
    if (mark[i] == 1) return reportCycle(i);
    mark[i] = 1;
    path.push_back(i);
    for (std::size_t w = 0; w < modules.size(); ++w) {
      const DeclaredProperty* p = w == i || modules[w].outside ? nullptr : link(modules[w], modules[i]);
      if (p == nullptr || modules[i].outside) continue;
      if (modules[w].declaration->phase() > modules[i].declaration->phase()) {
        diagnostics.error(modules[i].where,
                          fmt::format("{}: module {} reads {}, which {} writes later in the frame; expected readsLast",
                                      whose, modules[i].name, p->name, modules[w].name));
        continue;
      }
      visit(w);
    }
    path.pop_back();
    mark[i] = 2;
    order.push_back(i);
  }
  void reportCycle(std::size_t i) {
    std::string names;
    for (auto it = std::find(path.begin(), path.end(), i); it != path.end(); ++it) names += modules[*it].name + " -> ";
    diagnostics.error(modules[i].where, fmt::format("{}: modules wait for each other: {}{}; one must use readsLast",
                                                    whose, names, modules[i].name));
  }
};

}  // namespace

std::vector<std::size_t> orderModules(const std::vector<ScheduledModule>& modules, const std::string& whose,
                                      Diagnostics& diagnostics) {
  Search search{modules, whose, diagnostics, std::vector<int>(modules.size(), 0), {}, {}};
  for (const Phase phase : {Phase::kPrescribe, Phase::kEvaluate, Phase::kAdvance, Phase::kSense}) {
    for (std::size_t i = 0; i < modules.size(); ++i) {
      if (modules[i].declaration->phase() == phase) search.visit(i);
    }
  }
  return search.order;
}

void dropUnread(std::vector<ScheduledModule>& modules) {
  for (ScheduledModule& m : modules) {
    const auto& properties = m.declaration->properties();
    m.wanted = m.outside || std::any_of(properties.begin(), properties.end(), [](const DeclaredProperty& p) {
                 return p.access == Access::kAdds && p.storage == Storage::kState;
               });
  }
  for (bool changed = true; changed;) {
    changed = false;
    for (ScheduledModule& m : modules) {
      if (m.wanted) continue;
      m.wanted = std::any_of(modules.begin(), modules.end(), [&](const ScheduledModule& reader) {
        if (!reader.wanted || &reader == &m) return false;
        return std::any_of(reader.declaration->properties().begin(), reader.declaration->properties().end(),
                           [&](const DeclaredProperty& p) { return p.isRead() && adds(*m.declaration, p); });
      });
      changed = changed || m.wanted;
    }
  }
}

std::unique_ptr<BlockModule> makeDefault(const ModuleEntry& entry) {
  Diagnostics none;
  return entry.create(resolveParameters(entry.name, entry.parameters, {}, none));
}

namespace {

std::string_view wordFor(Access access) {
  switch (access) {
    case Access::kNeeds:
      return "needs";
    case Access::kUses:
      return "uses";
    case Access::kReads:
      return "reads";
    case Access::kReadsIfAdded:
      return "may read";
    case Access::kReadsLast:
      return "reads last";
    case Access::kAdds:
      return "adds";
    case Access::kAccumulates:
      return "adds to";
    case Access::kSets:
      return "may set";
  }
  return "";
}

}  // namespace

std::string_view wordFor(Phase phase) {
  switch (phase) {
    case Phase::kPrescribe:
      return "prescribe";
    case Phase::kEvaluate:
      return "evaluate";
    case Phase::kAdvance:
      return "advance";
    case Phase::kSense:
      return "sense";
  }
  return "";
}

namespace {

std::string propertyLines(const Module& module) {
  std::string out;
  Declaration declaration;
  module.declare(declaration);
  for (const DeclaredProperty& p : declaration.properties()) {
    out += fmt::format("{:<20} {:<11} {:<22} {:<8} {:<7} {}\n", "", wordFor(p.access), p.name, p.subset, p.unit,
                       p.meaning);
  }
  return out;
}

}  // namespace

std::string moduleTable(const ModuleRegistry& registry, const std::vector<Attachment>& attachments) {
  std::string out =
      fmt::format("{:<20} {:<11} {:<22} {:<8} {:<7} {}\n", "module", "access", "property", "of", "unit", "meaning");
  for (const ModuleEntry& entry : registry.entries()) {
    out += fmt::format("\n{} ({}): {}\n", entry.name, entry.concern, entry.summary);
    out += propertyLines(*makeDefault(entry));
    for (const ParameterInfo& p : entry.parameters) {
      out += fmt::format("{:<20} {:<11} {:<22} {:<8} {:<7} {} (default {})\n", "", "parameter", p.name, "", p.unit,
                         p.meaning, p.initial);
    }
  }
  for (const Attachment& attachment : attachments) {
    out += fmt::format("\n{} (part of the frame)\n{}", attachment.name, propertyLines(*attachment.module));
  }
  return out;
}

std::string passTable(const LinkedWorld& linked) {
  std::string out = fmt::format("{:<20} {:<10} {:<20} {:<9} {}\n", "assembly", "phase", "module", "period", "");
  for (const PassReport& pass : linked.passes()) {
    out += fmt::format("{:<20} {:<10} {:<20} {:<9} {}\n",
                       pass.level == 0 ? pass.assembly : fmt::format("{} ({})", pass.assembly, pass.level),
                       wordFor(pass.phase), pass.module, fmt::format("{} s", pass.dt),
                       pass.scheduled ? "" : "not scheduled: nobody reads " + pass.unread);
  }
  return out;
}

}  // namespace murosimf
