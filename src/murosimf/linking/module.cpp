#include "murosimf/linking/module.h"

#include <algorithm>
#include <stdexcept>

namespace murosimf {

void copyColumn(const BlockMemory& block, ColumnRef from, ColumnRef to, int numbers, int width) {
  const auto first = [&](ColumnRef column) {
    return block.piece[static_cast<int>(column.memory)] + column.offset * width;
  };
  std::copy_n(first(from), numbers * width, first(to));
}

void ModuleRegistry::add(ModuleEntry entry) {
  if (find(entry.name) != nullptr) {
    throw std::invalid_argument("two modules have the name \"" + std::string(entry.name) + "\"");
  }
  entry.parameters.insert(entry.parameters.begin(), kPeriodParameter);
  entries_.push_back(std::move(entry));
}

const ModuleEntry* ModuleRegistry::find(std::string_view name) const {
  const auto found =
      std::find_if(entries_.begin(), entries_.end(), [&](const ModuleEntry& e) { return e.name == name; });
  return found == entries_.end() ? nullptr : &*found;
}

std::vector<std::string> ModuleRegistry::names() const {
  std::vector<std::string> all;
  for (const ModuleEntry& entry : entries_) all.emplace_back(entry.name);
  return all;
}

}  // namespace murosimf
