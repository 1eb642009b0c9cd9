#include "murosimf/scene/servo_builder.h"

#include <fmt/format.h>

#include "murosimf/modules/actuation/motor_properties.h"
#include "murosimf/scene/robot_reader.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

namespace {

/// Of the robot's and a joint's choice of file the one that holds; null when there is none.
const ConstantEntry* choice(const World& world, ObjectId robot, ObjectId joint, const std::string& robot_file) {
  const bool has_servo = world.findEntry(joint, kServoStiffness.name) != nullptr;
  const ConstantEntry* common = has_servo ? world.findEntry(robot, kServoFile.name) : nullptr;
  const ConstantEntry* own = world.findEntry(joint, kServoFile.name);
  if (common == nullptr || own == nullptr) return common == nullptr ? own : common;
  const auto by_scenario = [&](const ConstantEntry* entry) { return entry->where.file != robot_file; };
  return by_scenario(common) && !by_scenario(own) ? common : own;
}

bool isWritten(const ConstantEntry* entry) {
  return entry != nullptr && std::any_cast<WrittenValue>(&entry->value) != nullptr;
}

}  // namespace

const std::vector<ServoConstant>* ServoBuilder::read(const std::string& name, const SourceLocation& where) {
  const std::string found = findDataFile(name, where.file).string();
  const auto [at, fresh] = files_.emplace(found.empty() ? name : found, std::nullopt);
  if (fresh && found.empty()) {
    diagnostics_.error(where, fmt::format("there is no servo file {}", whereLooked(name, where.file)));
  } else if (fresh) {
    at->second = readServoFile(found, diagnostics_);
  }
  return at->second ? &*at->second : nullptr;
}

void ServoBuilder::apply(World& world, ObjectId robot, const std::string& robot_file) {
  for (const ObjectId joint : world.members(robot, subset::kJoints)) {
    const ConstantEntry* entry = choice(world, robot, joint, robot_file);
    if (entry == nullptr) continue;
    const bool own = entry == world.findEntry(joint, kServoFile.name);
    const std::optional<std::string> name = world.find(own ? joint : robot, kServoFile);
    const SourceLocation where = entry->where;
    if (!name) {
      diagnostics_.error(where, fmt::format("servo_file of {} is no text, expected the name of a file",
                                            world.path(own ? joint : robot)));
      if (!own) return;
      continue;
    }
    const std::vector<ServoConstant>* constants = *name == "none" ? nullptr : read(*name, where);
    if (constants == nullptr) continue;
    for (const ServoConstant& constant : *constants) {
      if (!isWritten(world.findEntry(joint, constant.property->name))) {
        world.set(joint, *constant.property, constant.value, where);
      }
    }
  }
}

}  // namespace murosimf
