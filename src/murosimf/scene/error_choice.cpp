#include "murosimf/scene/error_choice.h"

#include <algorithm>

#include "murosimf/linking/schedule.h"

namespace murosimf {

namespace {

std::vector<DeclaredProperty> propertiesOf(const Assignment& assignment, const ModuleRegistry& registry) {
  const ModuleEntry* entry = registry.find(assignment.module);
  if (entry == nullptr) return {};
  Declaration declaration;
  makeDefault(*entry)->declare(declaration);
  return declaration.properties();
}

class SensorSearch {
 public:
  SensorSearch(const std::vector<Assignment>& assignments, const ModuleRegistry& registry)
      : assignments_(assignments), registry_(registry) {
    for (const Assignment& a : assignments) properties_.push_back(propertiesOf(a, registry));
  }
  bool isError(std::size_t i) const {
    const ModuleEntry* entry = registry_.find(assignments_[i].module);
    return entry != nullptr && entry->concern == "errors";
  }
  bool hasSensor(std::size_t i) const {
    return std::all_of(properties_[i].begin(), properties_[i].end(), [&](const DeclaredProperty& p) {
      return p.access != Access::kReads || isWritten(p, assignments_[i].level);
    });
  }
  bool hasSensorSomewhere(const std::string& module) const {
    for (std::size_t i = 0; i < assignments_.size(); ++i) {
      if (assignments_[i].module == module && hasSensor(i)) return true;
    }
    return false;
  }

 private:
  bool isWritten(const DeclaredProperty& wanted, int level) const {
    for (std::size_t i = 0; i < assignments_.size(); ++i) {
      if (assignments_[i].level != level) continue;
      const auto writes = [&](const DeclaredProperty& p) { return p.isWritten() && p.sameColumn(wanted); };
      if (std::any_of(properties_[i].begin(), properties_[i].end(), writes)) return true;
    }
    return false;
  }
  const std::vector<Assignment>& assignments_;
  const ModuleRegistry& registry_;
  std::vector<std::vector<DeclaredProperty>> properties_;  // of each assignment
};

}  // namespace

void dropErrorsWithoutSensor(std::vector<Assignment>& assignments, const ModuleRegistry& registry) {
  const SensorSearch search(assignments, registry);
  std::vector<Assignment> kept;
  for (std::size_t i = 0; i < assignments.size(); ++i) {
    const bool useless = search.isError(i) && !search.hasSensor(i) && search.hasSensorSomewhere(assignments[i].module);
    if (!useless) kept.push_back(assignments[i]);
  }
  assignments = std::move(kept);
}

}  // namespace murosimf
