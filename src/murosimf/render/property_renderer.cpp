#include "murosimf/render/property_renderer.h"

#include <algorithm>
#include <exception>

namespace murosimf {

bool hasProperty(const World& world, const LinkedWorld& linked, ObjectId object, std::string_view property,
                 std::string_view subset) {
  const auto members = world.members(object, subset);
  const auto is_constant = [&](ObjectId id) { return world.findEntry(id, property) != nullptr; };
  if (std::any_of(members.begin(), members.end(), is_constant)) return true;
  const auto found = std::find_if(linked.residents().begin(), linked.residents().end(),
                                  [&](const Resident& r) { return r.assembly == object; });
  if (found == linked.residents().end()) return false;
  return std::any_of(found->levels.begin(), found->levels.end(), [&](const LevelSeat& seat) {
    return linked.batches()[static_cast<std::size_t>(seat.batch)].column(property, subset) != nullptr;
  });
}

std::vector<Attachment> RendererRegistry::attachments(const std::vector<ObjectId>& assemblies) const {
  std::vector<Attachment> attachments;
  for (const RendererEntry& entry : entries_) {
    if (entry.reads != nullptr) attachments.push_back({"viewer", entry.reads, assemblies});
  }
  return attachments;
}

Renderings::Renderings(const RendererRegistry& registry, const World& world, LinkedWorld& linked,
                       const std::vector<ObjectId>& objects)
    : entries_(registry.entries()), objects_(objects) {
  for (std::size_t e = 0; e < entries_.size(); ++e) {
    const RendererEntry& entry = entries_[e];
    for (std::size_t i = 0; i < objects.size(); ++i) {
      if (!hasProperty(world, linked, objects[i], entry.property, entry.subset)) continue;
      Rendering& rendering = all_.emplace_back();
      rendering.entry = static_cast<int>(e);
      rendering.object = objects[i];
      rendering.shown = entry.shown;
      rendering.renderer = entry.make({world, linked, objects[i], static_cast<std::uint32_t>(i + 1)});
    }
  }
}

ObjectId Renderings::objectOf(std::uint32_t label) const {
  return label == 0 || label > objects_.size() ? ObjectId{} : objects_[label - 1];
}

void Renderings::show(std::string_view name, bool shown, ObjectId object) {
  for (Rendering& rendering : all_) {
    const bool meant = entryOf(rendering).name == name && (!object.valid() || rendering.object == object);
    if (meant) rendering.shown = shown && rendering.fault.empty();
  }
}

void Renderings::draw(const RenderMoment& now, DrawList& list) {
  list.clear();
  for (Rendering& rendering : all_) {
    if (!rendering.shown) continue;
    try {
      rendering.renderer->draw(now, list);
    } catch (const std::exception& fault) {
      rendering.fault = fault.what();
      rendering.shown = false;
    }
  }
}

}  // namespace murosimf
