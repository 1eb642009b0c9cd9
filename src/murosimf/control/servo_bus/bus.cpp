#include "murosimf/control/servo_bus/bus.h"

#include <algorithm>
#include <array>
#include <set>

namespace murosimf::servo_bus {

namespace {

constexpr double kDelayUnit = 2e-6;           // [s], of Return Delay Time
constexpr std::uint16_t kLargestRead1 = 253;  // [bytes]

/// Least level that has this question answered.
std::int64_t levelOf(Instruction instruction) {
  if (instruction == Instruction::kPing) return 0;
  const bool reads = instruction == Instruction::kRead || instruction == Instruction::kSyncRead ||
                     instruction == Instruction::kBulkRead;
  return reads ? 1 : 2;
}

bool isForSeveral(Instruction instruction) { return static_cast<unsigned>(instruction) >= 0x80; }

}  // namespace

Device* Bus::find(std::uint8_t id) {
  const auto found = std::find_if(devices_.begin(), devices_.end(), [&](const Device& d) { return d.id() == id; });
  return found == devices_.end() ? nullptr : &*found;
}

/// An answer of version 1.0 has no room for more.
Fault Bus::readInto(const Device& device, std::uint16_t address, std::uint16_t length, Bytes& data) const {
  if (protocol_ == Protocol::k1 && length > kLargestRead1) return Fault::kRange;
  return device.read(address, length, data);
}

std::uint16_t Bus::word(Parameters parameters, std::size_t i) const {
  return static_cast<std::uint16_t>(parameters[i] + 256u * parameters[i + 1]);
}

Answer Bus::answer(const Device& device, Fault fault, std::span<const std::uint8_t> data) const {
  Answer result;
  appendStatus(protocol_, device.id(), device.errorByte(protocol_, fault), data, result.bytes);
  result.delay = kDelayUnit * static_cast<double>(device.get(Item::kReturnDelayTime));
  return result;
}

std::vector<Answer> Bus::handle(const InstructionPacket& packet) {
  std::vector<Answer> answers;
  const auto instruction = static_cast<Instruction>(packet.instruction);
  if (packet.damaged) {
    const Device* device = find(packet.id);
    if (device != nullptr && device->statusReturnLevel() > 1) answers.push_back(answer(*device, Fault::kChecksum, {}));
    return answers;
  }
  if (protocol_ == Protocol::k2 && instruction == Instruction::kStatus) return answers;
  for (Device& device : devices_) device.hear();
  const bool several = packet.id == kBroadcast && isForSeveral(instruction);
  const bool only1 = instruction == Instruction::kSyncWrite || instruction == Instruction::kBulkRead;
  if (!several || (protocol_ == Protocol::k1 && !only1)) {
    single(packet, answers);
  } else if (instruction == Instruction::kSyncRead || instruction == Instruction::kBulkRead) {
    readMany(packet, answers);
  } else if (instruction == Instruction::kFastSyncRead || instruction == Instruction::kFastBulkRead) {
    readFast(packet, answers);
  } else if (instruction == Instruction::kSyncWrite) {
    syncWrite(packet.parameters);
  } else if (instruction == Instruction::kBulkWrite) {
    bulkWrite(packet.parameters);
  }
  return answers;
}

void Bus::pingAll(std::vector<Answer>& answers) {
  std::vector<const Device*> order;
  for (const Device& device : devices_) order.push_back(&device);
  std::stable_sort(order.begin(), order.end(), [](const Device* a, const Device* b) { return a->id() < b->id(); });
  for (const Device* device : order) {
    const auto number = static_cast<std::uint16_t>(device->get(Item::kModelNumber));
    const std::array<std::uint8_t, 3> data = {static_cast<std::uint8_t>(number), static_cast<std::uint8_t>(number >> 8),
                                              static_cast<std::uint8_t>(device->get(Item::kFirmwareVersion))};
    answers.push_back(answer(*device, Fault::kNone, std::span(data).first(protocol_ == Protocol::k2 ? 3 : 0)));
  }
}

void Bus::single(const InstructionPacket& packet, std::vector<Answer>& answers) {
  const auto instruction = static_cast<Instruction>(packet.instruction);
  const bool to_all = packet.id == kBroadcast;
  if (to_all && instruction == Instruction::kPing) return pingAll(answers);
  const Device* addressed = to_all ? nullptr : find(packet.id);
  for (Device& device : devices_) {
    const bool shadowed = protocol_ == Protocol::k2 && device.get(Item::kSecondaryId) == packet.id && packet.id <= 252;
    if (!to_all && &device != addressed && !(shadowed && device.has(Item::kSecondaryId))) continue;
    const std::int64_t level = device.statusReturnLevel();
    Bytes data;
    const Fault fault = execute(device, packet, data);
    if (&device == addressed && level >= levelOf(instruction)) answers.push_back(answer(device, fault, data));
  }
}

Fault Bus::execute(Device& device, const InstructionPacket& packet, Bytes& data) {
  const auto instruction = static_cast<Instruction>(packet.instruction);
  const bool second = protocol_ == Protocol::k2;
  switch (instruction) {
    case Instruction::kPing:
      if (second) {
        const auto number = static_cast<std::uint16_t>(device.get(Item::kModelNumber));
        data = {static_cast<std::uint8_t>(number), static_cast<std::uint8_t>(number >> 8),
                static_cast<std::uint8_t>(device.get(Item::kFirmwareVersion))};
      }
      return Fault::kNone;
    case Instruction::kRead:
    case Instruction::kWrite:
    case Instruction::kRegWrite:
      return transfer(device, instruction, packet.parameters, data);
    case Instruction::kAction:
      return device.action();
    case Instruction::kFactoryReset: {
      if (!second) return device.factoryReset(0xFF);
      const std::uint8_t option = packet.parameters.empty() ? 0 : packet.parameters[0];
      return packet.id == kBroadcast && option == 0xFF ? Fault::kResult : device.factoryReset(option);
    }
    case Instruction::kReboot:
      if (!second) return Fault::kInstruction;
      device.reboot();
      return Fault::kNone;
    case Instruction::kClear:
      return second ? device.clear(packet.parameters) : Fault::kInstruction;
    default:
      return Fault::kInstruction;
  }
}

Fault Bus::transfer(Device& device, Instruction instruction, Parameters parameters, Bytes& data) {
  const std::size_t size = protocol_ == Protocol::k1 ? 1 : 2;  // of an address, and of a length
  const Fault malformed = protocol_ == Protocol::k1 ? Fault::kRange : Fault::kLength;
  if (parameters.size() < size + 1) return malformed;
  const std::uint16_t address = size == 1 ? parameters[0] : word(parameters, 0);
  const Parameters rest = parameters.subspan(size);
  if (instruction == Instruction::kWrite) return device.write(address, rest);
  if (instruction == Instruction::kRegWrite) return device.registerWrite(address, rest);
  if (rest.size() != size) return malformed;
  return readInto(device, address, size == 1 ? rest[0] : word(rest, 0), data);
}

std::vector<Bus::Request> Bus::readRequests(Instruction instruction, Parameters parameters) const {
  std::vector<Request> requests;
  const bool sync = instruction == Instruction::kSyncRead || instruction == Instruction::kFastSyncRead;
  if (sync) {
    for (std::size_t i = 4; i < parameters.size(); ++i) {
      requests.push_back({parameters[i], word(parameters, 0), word(parameters, 2)});
    }
  } else if (protocol_ == Protocol::k1) {
    for (std::size_t i = 1; i + 2 < parameters.size(); i += 3) {
      requests.push_back({parameters[i + 1], parameters[i + 2], parameters[i]});
    }
  } else {
    for (std::size_t i = 0; i + 4 < parameters.size(); i += 5) {
      requests.push_back({parameters[i], word(parameters, i + 1), word(parameters, i + 3)});
    }
  }
  std::set<std::uint8_t> named;  // each device answers once
  std::erase_if(requests, [&](const Request& request) { return !named.insert(request.id).second; });
  return requests;
}

void Bus::readMany(const InstructionPacket& packet, std::vector<Answer>& answers) {
  for (const Request& request : readRequests(static_cast<Instruction>(packet.instruction), packet.parameters)) {
    const Device* device = find(request.id);
    if (device == nullptr || device->statusReturnLevel() < 1) continue;
    Bytes data;
    const Fault fault = readInto(*device, request.address, request.length, data);
    answers.push_back(answer(*device, fault, data));
  }
}

void Bus::readFast(const InstructionPacket& packet, std::vector<Answer>& answers) {
  const auto requests = readRequests(static_cast<Instruction>(packet.instruction), packet.parameters);
  std::size_t length = 1;
  for (const Request& request : requests) length += 4u + request.length;
  if (requests.empty() || length + 7 > kLargestPacket) return;
  Answer all{{0xFF, 0xFF, 0xFD, 0x00, kBroadcast, static_cast<std::uint8_t>(length),
              static_cast<std::uint8_t>(length >> 8), static_cast<std::uint8_t>(Instruction::kStatus)},
             0};
  for (const Request& request : requests) {
    const Device* device = find(request.id);
    if (device == nullptr || device->statusReturnLevel() < 1) break;
    Bytes data;
    const Fault fault = readInto(*device, request.address, request.length, data);
    data.resize(request.length);
    all.bytes.push_back(device->errorByte(protocol_, fault));
    all.bytes.push_back(request.id);
    all.bytes.insert(all.bytes.end(), data.begin(), data.end());
    const std::uint16_t crc = crc16(all.bytes);
    all.bytes.push_back(static_cast<std::uint8_t>(crc));
    all.bytes.push_back(static_cast<std::uint8_t>(crc >> 8));
    if (&request == &requests.front()) all.delay = answer(*device, fault, {}).delay;
  }
  if (all.bytes.size() > 8) answers.push_back(std::move(all));
}

void Bus::syncWrite(Parameters parameters) {
  const std::size_t ahead = protocol_ == Protocol::k1 ? 2 : 4;
  if (parameters.size() < ahead) return;
  const std::uint16_t address = ahead == 2 ? parameters[0] : word(parameters, 0);
  const std::size_t length = ahead == 2 ? parameters[1] : word(parameters, 2);
  for (std::size_t i = ahead; i + length < parameters.size(); i += length + 1) {
    Device* device = find(parameters[i]);
    if (device != nullptr) device->write(address, parameters.subspan(i + 1, length));
  }
}

void Bus::bulkWrite(Parameters parameters) {
  for (std::size_t i = 0; i + 5 <= parameters.size();) {
    const std::size_t length = word(parameters, i + 3);
    if (i + 5 + length > parameters.size()) return;
    Device* device = find(parameters[i]);
    if (device != nullptr) device->write(word(parameters, i + 1), parameters.subspan(i + 5, length));
    i += 5 + length;
  }
}

}  // namespace murosimf::servo_bus
