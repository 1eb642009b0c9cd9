#include "murosimf/world/world.h"

#include <stdexcept>

namespace murosimf {

World::World() {
  objects_.push_back({"", ObjectId{}, ObjectId{0}, {}, {}});
  by_path_.emplace("", ObjectId{0});
}

ObjectId World::add(ObjectId parent_id, std::string_view name) {
  if (name.empty()) throw std::invalid_argument("an object below \"" + path(parent_id) + "\" has an empty name");
  std::string full = path(parent_id).empty() ? std::string(name) : path(parent_id) + "." + std::string(name);
  const ObjectId id{objectCount()};
  if (!by_path_.emplace(full, id).second) throw std::invalid_argument("two objects have the path \"" + full + "\"");
  objects_.push_back({std::move(full), parent_id, id, {}, {}});
  return id;
}

ObjectId World::addPath(std::string_view path_text) {
  ObjectId current = root();
  while (!path_text.empty()) {
    const std::size_t dot = path_text.find('.');
    const std::string_view name = path_text.substr(0, dot);
    const std::string full = path(current).empty() ? std::string(name) : path(current) + "." + std::string(name);
    const ObjectId existing = find(full);
    current = existing.valid() ? existing : add(current, name);
    path_text = dot == std::string_view::npos ? std::string_view{} : path_text.substr(dot + 1);
  }
  return current;
}

ObjectId World::find(std::string_view path_text) const {
  const auto found = by_path_.find(path_text);
  return found == by_path_.end() ? ObjectId{} : found->second;
}

std::vector<std::string> World::paths() const {
  std::vector<std::string> all;
  for (const Object& object : objects_) all.push_back(object.path);
  return all;
}

void World::defineSubset(ObjectId assembly, std::string_view name, std::vector<ObjectId> members) {
  at(assembly).subsets.insert_or_assign(std::string(name), std::move(members));
}

std::span<const ObjectId> World::members(ObjectId assembly, std::string_view subset_name) const {
  const Object& object = at(assembly);
  if (subset_name == subset::kSelf) return {&object.self, 1};
  if (subset_name == subset::kWorld) return {&objects_.front().self, 1};
  const auto found = object.subsets.find(subset_name);
  return found == object.subsets.end() ? std::span<const ObjectId>{} : std::span<const ObjectId>(found->second);
}

void World::setWritten(ObjectId id, std::string_view property, WrittenValue value, SourceLocation where) {
  at(id).constants.insert_or_assign(std::string(property), ConstantEntry{std::move(value), std::move(where)});
}

const ConstantEntry* World::findEntry(ObjectId id, std::string_view property) const {
  const auto& constants = at(id).constants;
  const auto found = constants.find(property);
  return found == constants.end() ? nullptr : &found->second;
}

}  // namespace murosimf
