#include "murosimf-view/property_words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "murosimf/linking/schedule.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

namespace {

void addWords(const Module& module, PropertyWords& words) {
  Declaration declaration;
  module.declare(declaration);
  for (const DeclaredProperty& p : declaration.properties()) {
    words.insert_or_assign(std::string(p.name), PropertyWord{std::string(p.unit), std::string(p.meaning)});
  }
}

std::string numbersIn(const double* first, std::size_t count) {
  return fmt::format("{:.6g}", fmt::join(first, first + count, " "));
}

std::string wordsOf(const WrittenValue& written) {
  return written.numbers.empty() ? written.text : numbersIn(written.numbers.data(), written.numbers.size());
}

std::string wordsOf(const CameraModel& c) {
  return fmt::format("{} x {}, f {:.1f} {:.1f}, c {:.1f} {:.1f}, k {:.3g}", c.width, c.height, c.fx, c.fy, c.cx, c.cy,
                     fmt::join(c.kc, " "));
}

/// The value where it is a plain structure of doubles.
template <class T>
bool addNumbers(const std::any& value, std::string& words) {
  const T* found = std::any_cast<T>(&value);
  if (found == nullptr) return false;
  words = numbersIn(reinterpret_cast<const double*>(found), sizeof(T) / sizeof(double));
  return true;
}

}  // namespace

PropertyWords propertyWords(const ModuleRegistry& modules, const Participants& participants) {
  PropertyWords words;
  for (const ModuleEntry& entry : modules.entries()) addWords(*makeDefault(entry), words);
  for (const Attachment& attachment : frameAttachments(participants)) addWords(*attachment.module, words);
  return words;
}

std::string wordsOf(const ConstantEntry& entry) {
  const std::any& value = entry.value;
  std::string words;
  if (addNumbers<double>(value, words) || addNumbers<Vector3>(value, words) || addNumbers<Pose>(value, words) ||
      addNumbers<RigidInertia<double>>(value, words)) {
    return words;
  }
  if (const auto* text = std::any_cast<std::string>(&value)) return *text;
  if (const auto* written = std::any_cast<WrittenValue>(&value)) return wordsOf(*written);
  if (const auto* camera = std::any_cast<CameraModel>(&value)) return wordsOf(*camera);
  if (const auto* shapes = std::any_cast<std::vector<PlacedShape>>(&value))
    return fmt::format("{} shapes", shapes->size());
  if (const auto* soles = std::any_cast<std::vector<SolePlace>>(&value)) return fmt::format("{} soles", soles->size());
  if (const auto* tree = std::any_cast<TreeTable>(&value)) return fmt::format("{} rows", tree->rows.size());
  return "";
}

std::string componentName(int components, int component) {
  if (components == 1) return "";
  constexpr char kAxes[] = "xyz";
  const auto axis = [&](int i) { return std::string(1, kAxes[i % 3]); };
  if (components == 3) return axis(component);
  if (components == 6) return (component < 3 ? "w " : "v ") + axis(component);
  if (components == 12) return component < 9 ? "R " + axis(component) + axis(component / 3) : "p " + axis(component);
  return std::to_string(component);
}

std::string componentUnit(const std::string& unit, int components, int component) {
  return components == 12 && component < 9 ? "1" : unit;
}

std::vector<ObjectVariable> variablesOf(const World& world, const LinkedWorld& linked, ObjectId object) {
  std::vector<ObjectVariable> found;
  for (const Place& place : linked.places()) {
    const std::string& path = world.path(place.assembly);
    if (world.path(object).compare(0, path.size(), path) != 0) continue;
    for (const ColumnLayout& layout : linked.columnsOf(place)) {
      if (layout.ref.memory != MemoryKind::kState) continue;
      const auto members = world.members(place.assembly, layout.subset);
      const auto member = std::find(members.begin(), members.end(), object);
      if (member == members.end()) continue;
      found.push_back({place.assembly, &layout, &place, static_cast<int>(member - members.begin())});
    }
  }
  std::sort(found.begin(), found.end(),
            [](const ObjectVariable& a, const ObjectVariable& b) { return a.layout->property < b.layout->property; });
  return found;
}

}  // namespace murosimf
