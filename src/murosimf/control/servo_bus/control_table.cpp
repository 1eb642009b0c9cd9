#include "murosimf/control/servo_bus/control_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "murosimf/control/servo_bus/servo_tables.h"

namespace murosimf::servo_bus {

namespace {

constexpr std::string_view kImuName = "IMU";
constexpr std::uint16_t kRam1 = 24, kRam2 = 64;
constexpr IndirectBlock kIndirect[] = {{168, 224, 28}, {578, 634, 28}};

void add(ControlTable& table, std::span<const Register> registers) {
  table.registers.insert(table.registers.end(), registers.begin(), registers.end());
}

Register& find(ControlTable& table, Item item) {
  return *std::find_if(table.registers.begin(), table.registers.end(),
                       [&](const Register& r) { return r.item == item; });
}

void addIndirect(ControlTable& table) {
  for (const IndirectBlock& block : kIndirect) {
    table.indirect.push_back(block);
    for (std::uint16_t i = 0; i < block.count; ++i) {
      const auto address = static_cast<std::uint16_t>(block.addresses + 2 * i);
      const auto data = static_cast<std::uint16_t>(block.data + i);
      table.registers.push_back({address, 2, "Indirect Address", Access::kReadWrite, data, 64, 661});
      table.registers.push_back({data, 1, "Indirect Data", Access::kReadWrite, 0, 0, 255});
    }
  }
}

/// Sorts, and finds the end.
ControlTable finished(ControlTable table) {
  std::sort(table.registers.begin(), table.registers.end(),
            [](const Register& a, const Register& b) { return a.address < b.address; });
  table.end = static_cast<std::uint16_t>(table.registers.back().address + table.registers.back().size);
  return table;
}

ControlTable oldTable(const Model& model) {
  ControlTable table{std::string(model.name), DeviceKind::kServo, true, {}, {}, kRam1, 0, model.figures};
  table.figures.velocity_unit = model.figures.velocity_unit * (0.114 / 0.229);
  if (model.has_current) table.figures.current_unit = 4.5e-3;
  add(table, registersOfVersion1());
  if (model.has_current) add(table, currentRegistersOfVersion1());
  find(table, Item::kModelNumber).initial = model.number1;
  find(table, Item::kLargestVoltage).initial = model.largest_voltage1;
  if (model.number1 == 320)
    table.registers.push_back({10, 1, "Drive Mode", Access::kReadWrite, 0, 0, 3, "bits", Item::kDriveMode});
  return finished(std::move(table));
}

ControlTable newTable(const Model& model) {
  ControlTable table{std::string(model.name), DeviceKind::kServo, false, {}, {}, kRam2, 0, model.figures};
  add(table, registersOfVersion2());
  add(table, model.has_current ? currentRegistersOfVersion2() : loadRegistersOfVersion2());
  add(table, model.is_x ? xRegistersOfVersion2() : mxRegistersOfVersion2());
  find(table, Item::kModelNumber).initial = model.number2;
  find(table, Item::kVelocityLimit).initial = model.velocity_limit;
  find(table, Item::kPositionP).initial = model.position_p;
  if (model.has_current) {
    Register& limit = find(table, Item::kCurrentLimit);
    limit.initial = limit.most = model.current_limit;
    find(table, Item::kGoalCurrent).initial = model.current_limit;
  }
  addIndirect(table);
  return finished(std::move(table));
}

}  // namespace

std::vector<std::string_view> modelNames() {
  std::vector<std::string_view> names;
  for (const Model& model : models()) names.emplace_back(model.name);
  names.push_back(kImuName);
  return names;
}

ControlTable tableOf(std::string_view model, Protocol protocol) {
  if (model == kImuName) {
    if (protocol == Protocol::k1) throw std::invalid_argument("model \"IMU\" speaks protocol 2 alone");
    ControlTable table{std::string(model), DeviceKind::kImu, false, {}, {}, 0, 0, {}};
    add(table, imuRegisters());
    return finished(std::move(table));
  }
  for (const Model& known : models()) {
    if (model == known.name) return protocol == Protocol::k1 && !known.is_x ? oldTable(known) : newTable(known);
  }
  throw std::invalid_argument(
      fmt::format("model \"{}\" is not known, expected one of {}", model, fmt::join(modelNames(), ", ")));
}

}  // namespace murosimf::servo_bus
