#include "murosimf/simulation/recording.h"

#include <fmt/format.h>

namespace murosimf {

namespace {

/// Paths of a subset's members; numbered where the world does not know them one by one.
std::vector<std::string> memberPaths(const World& world, ObjectId assembly, const ColumnLayout& layout) {
  std::vector<std::string> paths;
  const std::span<const ObjectId> members = world.members(assembly, layout.subset);
  for (int i = 0; i < layout.objects; ++i) {
    const auto place = static_cast<std::size_t>(i);
    paths.push_back(place < members.size() ? world.path(members[place])
                                           : fmt::format("{}.{}[{}]", world.path(assembly), layout.subset, i));
  }
  return paths;
}

std::uint32_t groupFor(const World& world, ObjectId assembly, const ColumnLayout& layout, RecordingHeader& header) {
  for (std::size_t i = 0; i < header.groups.size(); ++i) {
    const RecordedGroup& group = header.groups[i];
    if (group.assembly == world.path(assembly) && group.subset == layout.subset) return static_cast<std::uint32_t>(i);
  }
  header.groups.push_back({world.path(assembly), layout.subset, memberPaths(world, assembly, layout)});
  return static_cast<std::uint32_t>(header.groups.size() - 1);
}

}  // namespace

RecordingHeader describeState(const World& world, const LinkedWorld& linked) {
  RecordingHeader header;
  header.frame_length = linked.frameLength();
  for (const Resident& resident : linked.residents()) {
    linked.visitAllLevels(resident, [&](const ColumnLayout& layout, int object, int component, double) {
      if (object != 0 || component != 0) return;
      RecordedColumn column;
      column.group = groupFor(world, resident.assembly, layout, header);
      column.property = layout.property;
      column.unit = layout.unit;
      column.components = static_cast<std::uint32_t>(layout.components);
      column.first = header.numberCount();
      header.columns.push_back(std::move(column));
    });
  }
  return header;
}

}  // namespace murosimf
