#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "murosimf/control/servo_bus/bus.h"
#include "murosimf/control/servo_bus/packet_reader.h"
#include "servo_bus/bytes.h"

namespace murosimf::servo_bus {
namespace {

Bus busOf(Protocol protocol, const std::vector<std::pair<const char*, int>>& models) {
  std::vector<Device> devices;
  for (const auto& [model, id] : models)
    devices.emplace_back(tableOf(model, protocol), static_cast<std::uint8_t>(id), 250);
  return {protocol, std::move(devices)};
}

/// Bytes of all answers to one packet.
std::string ask(Bus& bus, int id, Instruction instruction, const std::string& parameters) {
  Bytes all;
  for (const Answer& answer :
       bus.handle({static_cast<std::uint8_t>(id), static_cast<std::uint8_t>(instruction), bytes(parameters), false}))
    all.insert(all.end(), answer.bytes.begin(), answer.bytes.end());
  return text(all);
}

/// A packet as it goes over the wire.
std::string send(Bus& bus, const std::string& packet) {
  PacketReader reader(bus.protocol());
  reader.take(bytes(packet));
  Bytes all;
  while (const auto found = reader.next())
    for (const Answer& answer : bus.handle(*found)) all.insert(all.end(), answer.bytes.begin(), answer.bytes.end());
  return text(all);
}

/// Error byte of the one answer, behind the header.
int errorOf(Bus& bus, int id, Instruction instruction, const std::string& parameters) {
  const Bytes answer = bytes(ask(bus, id, instruction, parameters));
  const std::size_t place = bus.protocol() == Protocol::k1 ? 4 : 8;
  return answer.size() > place ? answer[place] : -1;
}

using enum Instruction;

TEST(ServoBus, ExamplesOfVersion1AreAnsweredAsTheManualPrintsThem) {
  Bus bus = busOf(Protocol::k1, {{"MX-64", 1}, {"MX-64", 2}, {"MX-28", 0}});
  bus.devices()[0].set(Item::kPresentTemperature, 0x20);
  EXPECT_EQ(send(bus, "FF FF 01 02 01 FB"), "FF FF 01 02 00 FC") << "ping";
  EXPECT_EQ(send(bus, "FF FF 01 04 02 2B 01 CC"), "FF FF 01 03 00 20 DB") << "read";
  EXPECT_EQ(send(bus, "FF FF 01 05 04 1E F4 01 E2"), "FF FF 01 02 00 FC") << "reg write";
  EXPECT_EQ(bus.devices()[0].get(Item::kRegistered), 1);
  EXPECT_EQ(bus.devices()[0].get(Item::kGoalPosition), 0) << "not before the action";
  EXPECT_EQ(send(bus, "FF FF FE 02 05 FA"), "") << "an action for all is not answered";
  EXPECT_EQ(bus.devices()[0].get(Item::kGoalPosition), 500);
  EXPECT_EQ(bus.devices()[0].get(Item::kRegistered), 0);
  EXPECT_EQ(send(bus, "FF FF FE 0E 83 1E 04 00 10 00 50 01 01 20 02 60 03 67"), "") << "sync write";
  EXPECT_EQ(bus.devices()[2].get(Item::kGoalPosition), 0x010);
  EXPECT_EQ(bus.devices()[2].get(Item::kProfileVelocity), 0x150);
  EXPECT_EQ(bus.devices()[0].get(Item::kGoalPosition), 0x220);
  EXPECT_EQ(bus.devices()[0].get(Item::kProfileVelocity), 0x360);
  EXPECT_EQ(send(bus, "FF FF 00 02 06 F7"), "FF FF 00 02 00 FD") << "factory reset";
  EXPECT_EQ(bus.devices()[2].get(Item::kGoalPosition), 0);
}

TEST(ServoBus, BulkReadOfVersion1AnswersInTheOrderOfTheQuestion) {
  Bus bus = busOf(Protocol::k1, {{"MX-28", 2}, {"MX-28", 1}});
  bus.devices()[1].set(Item::kGoalPosition, 0x8000);
  bus.devices()[0].set(Item::kPresentPosition, 0x8000);
  EXPECT_EQ(send(bus, "FF FF FE 09 92 00 02 01 1E 02 02 24 1D"), "FF FF 01 04 00 00 80 7A FF FF 02 04 00 00 80 79");
}

TEST(ServoBus, ExamplesOfVersion2AreAnsweredAsTheManualPrintsThem) {
  Bus bus = busOf(Protocol::k2, {{"XH540-W270", 2}, {"XH540-W270", 1}});
  for (Device& device : bus.devices()) device.set(Item::kModelNumber, 1030), device.set(Item::kFirmwareVersion, 38);
  Device &two = bus.devices()[0], &one = bus.devices()[1];
  one.set(Item::kPresentPosition, 166), two.set(Item::kPresentPosition, 2079);
  one.set(Item::kPresentVoltage, 119), two.set(Item::kPresentTemperature, 36);
  const std::string done = "FF FF FD 00 01 04 00 55 00 A1 0C";
  const std::string first = "FF FF FD 00 01 07 00 55 00 06 04 26 65 5D";
  EXPECT_EQ(send(bus, "FF FF FD 00 01 03 00 01 19 4E"), first) << "ping";
  EXPECT_EQ(send(bus, "FF FF FD 00 FE 03 00 01 31 42"), first + " FF FF FD 00 02 07 00 55 00 06 04 26 6F 6D")
      << "ping to all, in the order of ids";
  EXPECT_EQ(send(bus, "FF FF FD 00 01 07 00 02 84 00 04 00 1D 15"), "FF FF FD 00 01 08 00 55 00 A6 00 00 00 8C C0");
  EXPECT_EQ(send(bus, "FF FF FD 00 01 09 00 03 74 00 00 02 00 00 CA 89"), done) << "write";
  EXPECT_EQ(one.get(Item::kGoalPosition), 512);
  one.set(Item::kVelocityLimit, 300);
  EXPECT_EQ(send(bus, "FF FF FD 00 01 09 00 04 68 00 C8 00 00 00 AE 8E"), done) << "reg write";
  EXPECT_EQ(send(bus, "FF FF FD 00 01 03 00 05 02 CE"), done) << "action";
  EXPECT_EQ(one.get(Item::kGoalVelocity), 200);
  EXPECT_EQ(send(bus, "FF FF FD 00 01 08 00 10 01 44 58 4C 22 B1 DC"), done) << "clear";
  EXPECT_EQ(send(bus, "FF FF FD 00 FE 09 00 82 84 00 04 00 01 02 CE FA"),
            "FF FF FD 00 01 08 00 55 00 A6 00 00 00 8C C0 FF FF FD 00 02 08 00 55 00 1F 08 00 00 BA BE");
  EXPECT_EQ(send(bus, "FF FF FD 00 FE 0D 00 92 01 90 00 02 00 02 92 00 01 00 1A 05"),
            "FF FF FD 00 01 06 00 55 00 77 00 C3 69 FF FF FD 00 02 05 00 55 00 24 8B A9");
  EXPECT_EQ(send(bus, "FF FF FD 00 FE 11 00 83 74 00 04 00 01 96 00 00 00 02 AA 00 00 00 82 87"), "") << "sync write";
  EXPECT_EQ(one.get(Item::kGoalPosition), 150);
  EXPECT_EQ(two.get(Item::kGoalPosition), 170);
  two.set(Item::kTemperatureLimit, 0);
  EXPECT_EQ(send(bus, "FF FF FD 00 FE 10 00 93 01 20 00 02 00 A0 00 02 1F 00 01 00 50 B7 68"), "") << "bulk write";
  EXPECT_EQ(one.get(Item::kLargestVoltage), 160);
  EXPECT_EQ(two.get(Item::kTemperatureLimit), 80);
  EXPECT_EQ(send(bus, "FF FF FD 00 01 03 00 08 2F 4E"), done) << "reboot";
  EXPECT_EQ(one.get(Item::kGoalVelocity), 0);
}

TEST(ServoBus, FastSyncReadAnswersInOnePacketWithACrcADevice) {
  Bus bus = busOf(Protocol::k2, {{"MX-28", 1}, {"MX-28", 2}});
  bus.devices()[0].set(Item::kPresentPosition, 166);
  bus.devices()[1].set(Item::kPresentPosition, 2079);
  Bytes expected = bytes("FF FF FD 00 FE 11 00 55 00 01 A6 00 00 00");
  const auto close = [&] {
    const std::uint16_t crc = crc16(expected);
    expected.push_back(static_cast<std::uint8_t>(crc)), expected.push_back(static_cast<std::uint8_t>(crc >> 8));
  };
  close();
  for (const std::uint8_t byte : bytes("00 02 1F 08 00 00")) expected.push_back(byte);
  close();
  EXPECT_EQ(ask(bus, 254, kFastSyncRead, "84 00 04 00 01 02"), text(expected));
  EXPECT_EQ(ask(bus, 254, kFastBulkRead, "01 84 00 04 00 02 84 00 04 00"), text(expected));
}

TEST(ServoBus, StatusReturnLevelSaysWhatIsAnswered) {
  for (const Protocol protocol : {Protocol::k1, Protocol::k2}) {
    Bus bus = busOf(protocol, {{"MX-28", 1}});
    const bool first = protocol == Protocol::k1;
    const std::string read = first ? "24 02" : "84 00 04 00", write = first ? "19 01" : "41 00 01";
    for (int level = 0; level <= 2; ++level) {
      bus.devices()[0].set(Item::kStatusReturnLevel, level);
      EXPECT_NE(ask(bus, 1, kPing, ""), "") << level;
      EXPECT_EQ(ask(bus, 1, kRead, read) != "", level >= 1) << level;
      EXPECT_EQ(ask(bus, 1, kWrite, write) != "", level >= 2) << level;
    }
  }
}

TEST(ServoBus, WritesToAllAreFollowedWithoutAnAnswer) {
  Bus bus = busOf(Protocol::k2, {{"MX-28", 1}, {"MX-64", 2}});
  EXPECT_EQ(ask(bus, 254, kWrite, "40 00 01"), "");
  EXPECT_TRUE(bus.devices()[0].torqueEnabled());
  EXPECT_TRUE(bus.devices()[1].torqueEnabled());
  EXPECT_EQ(ask(bus, 9, kPing, ""), "") << "nobody has this id";
}

TEST(ServoBus, ASecondaryIdIsFollowedWithoutAnAnswer) {
  Bus bus = busOf(Protocol::k2, {{"MX-28", 1}, {"MX-28", 2}});
  bus.devices()[1].set(Item::kSecondaryId, 1);
  EXPECT_EQ(bytes(ask(bus, 1, kWrite, "41 00 01")).size(), 11u) << "one answer";
  Bytes led;
  bus.devices()[1].read(65, 1, led);
  EXPECT_EQ(led[0], 1);
}

struct Refusal {
  const char* sentence;
  Instruction instruction;
  const char* parameters;
  int error;
};

TEST(ServoBus, Version2NamesTheFault) {
  const Refusal kCases[] = {
      {"an instruction that is not defined", static_cast<Instruction>(0x30), "", 2},
      {"an action without a reg write", kAction, "", 2},
      {"a value beyond the range of its register", kWrite, "54 00 00 40", 4},
      {"two bytes of a register of four", kWrite, "74 00 00 02", 5},
      {"a goal beyond the limit", kWrite, "74 00 00 20 00 00", 6},
      {"a velocity beyond the limit", kWrite, "68 00 FF 03 00 00", 6},
      {"a register that can only be read", kWrite, "84 00 00 00 00 00", 7},
      {"an address where nothing is, written", kWrite, "0E 00 01", 7},
      {"an address where nothing is, read", kRead, "0E 00 02 00", 7},
      {"bytes behind the table", kRead, "90 02 20 00", 7},
      {"current control of a servo that measures no current", kWrite, "0B 00 00", 4},
      {"a read without a length", kRead, "84 00", 5},
      {"a read over registers and gaps", kRead, "40 00 20 00", 0},
  };
  for (const Refusal& refusal : kCases) {
    Bus bus = busOf(Protocol::k2, {{"MX-28", 1}});
    EXPECT_EQ(errorOf(bus, 1, refusal.instruction, refusal.parameters), refusal.error) << refusal.sentence;
  }
}

TEST(ServoBus, Version1SetsTheBitOfTheFault) {
  const Refusal kCases[] = {
      {"an instruction that is not defined", static_cast<Instruction>(0x30), "", 0x40},
      {"a reboot, which version 2 has", kReboot, "", 0x40},
      {"an action without a reg write", kAction, "", 0x40},
      {"a value beyond its range", kWrite, "1C FF", 0x08},
      {"an address behind the table", kRead, "60 01", 0x08},
      {"a register that can only be read", kWrite, "24 00 00", 0x08},
      {"a goal outside of the angle limits", kWrite, "1E 01 10", 0x02},
  };
  for (const Refusal& refusal : kCases) {
    Bus bus = busOf(Protocol::k1, {{"MX-28", 1}});
    EXPECT_EQ(errorOf(bus, 1, refusal.instruction, refusal.parameters), refusal.error) << refusal.sentence;
  }
}

TEST(ServoBus, AWrongChecksumIsToldToWhoSentIt) {
  Bus one = busOf(Protocol::k1, {{"MX-28", 1}});
  EXPECT_EQ(send(one, "FF FF 01 02 01 FC"), "FF FF 01 02 10 EC");
  Bus two = busOf(Protocol::k2, {{"MX-28", 1}});
  EXPECT_EQ(bytes(send(two, "FF FF FD 00 01 03 00 01 19 4F"))[8], 3);
}

TEST(ServoBus, RegistersThatOutliveARestartAreLockedWhileTorqueIsOn) {
  Bus bus = busOf(Protocol::k2, {{"MX-64", 1}});
  EXPECT_EQ(errorOf(bus, 1, kWrite, "0B 00 04"), 0);
  EXPECT_EQ(errorOf(bus, 1, kWrite, "40 00 01"), 0);
  EXPECT_EQ(errorOf(bus, 1, kWrite, "0B 00 03"), 7);
  EXPECT_EQ(errorOf(bus, 1, kWrite, "40 00 00"), 0);
  EXPECT_EQ(errorOf(bus, 1, kWrite, "0B 00 03"), 0);
  Bus old = busOf(Protocol::k1, {{"MX-64", 1}});
  EXPECT_EQ(errorOf(old, 1, kWrite, "2F 01"), 0);
  EXPECT_EQ(errorOf(old, 1, kWrite, "06 64 00"), 8);
  EXPECT_EQ(errorOf(old, 1, kWrite, "2F 00"), 8) << "until it starts again";
}

TEST(ServoBus, AFaultOfTheHardwareIsInEveryAnswer) {
  Bus bus = busOf(Protocol::k2, {{"MX-64", 1}});
  bus.devices()[0].setAlarms(kOverload);
  EXPECT_EQ(errorOf(bus, 1, kPing, ""), 0x80);
  EXPECT_EQ(errorOf(bus, 1, kWrite, "84 00 00 00 00 00"), 0x87);
  Bus old = busOf(Protocol::k1, {{"MX-64", 1}});
  old.devices()[0].setAlarms(kOverload | kOverheating);
  EXPECT_EQ(send(old, "FF FF 01 02 01 FB"), "FF FF 01 02 24 D8");
}

TEST(ServoBus, IndirectDataShowTheRegistersTheyPointTo) {
  Bus bus = busOf(Protocol::k2, {{"MX-106", 1}});
  bus.devices()[0].set(Item::kPresentTemperature, 44);
  EXPECT_EQ(errorOf(bus, 1, kWrite, "A8 00 92 00"), 0) << "first indirect address: 146";
  EXPECT_EQ(bytes(ask(bus, 1, kRead, "E0 00 01 00"))[9], 44);
  EXPECT_EQ(errorOf(bus, 1, kWrite, "AA 00 74 00"), 0);
  for (const char* pointer : {"AC 00 75 00", "AE 00 76 00", "B0 00 77 00"})
    EXPECT_EQ(errorOf(bus, 1, kWrite, pointer), 0);
  EXPECT_EQ(errorOf(bus, 1, kWrite, "E1 00 10 02 00 00"), 0) << "goal position through indirect data";
  EXPECT_EQ(bus.devices()[0].get(Item::kGoalPosition), 0x210);
}

TEST(ServoBus, FactoryResetKeepsTheIdWhereItIsTold) {
  Bus bus = busOf(Protocol::k2, {{"MX-28", 1}});
  EXPECT_EQ(errorOf(bus, 1, kWrite, "07 00 09"), 0);
  EXPECT_EQ(errorOf(bus, 9, kWrite, "1F 00 46"), 0);
  EXPECT_EQ(errorOf(bus, 9, kFactoryReset, "01"), 0);
  EXPECT_EQ(bus.devices()[0].id(), 9);
  EXPECT_EQ(bus.devices()[0].get(Item::kTemperatureLimit), 80);
  EXPECT_EQ(ask(bus, 254, kFactoryReset, "FF"), "");
  EXPECT_EQ(bus.devices()[0].id(), 9) << "all at once keep theirs";
}

TEST(ServoBus, EveryTableIsOrderedAndItsInitialValuesAreInRange) {
  for (const std::string_view model : modelNames()) {
    for (const Protocol protocol : {Protocol::k1, Protocol::k2}) {
      if (model == "IMU" && protocol == Protocol::k1) continue;
      const ControlTable table = tableOf(model, protocol);
      int end = 0;
      for (const Register& r : table.registers) {
        EXPECT_GE(r.address, end) << model << " " << r.name;
        end = r.address + r.size;
        if (r.access == Access::kReadWrite && r.item != Item::kSecondaryId) {
          EXPECT_GE(r.initial, r.least) << model << " " << r.name;
          EXPECT_LE(r.initial, r.most) << model << " " << r.name;
        }
      }
    }
  }
}

RC_GTEST_PROP(ServoBus, WhateverIsAskedAnswersArePackets, ()) {
  const Protocol protocol = *rc::gen::element(Protocol::k1, Protocol::k2);
  Bus bus = busOf(protocol, {{"MX-28", 1}, {"XH540-W150", 2}, {protocol == Protocol::k2 ? "IMU" : "MX-106", 3}});
  for (int i = 0; i < 20; ++i) {
    const auto id = *rc::gen::element<std::uint8_t>(1, 2, 3, 4, kBroadcast);
    const auto code =
        *rc::gen::element<std::uint8_t>(1, 2, 3, 4, 5, 6, 8, 0x10, 0x20, 0x55, 0x82, 0x83, 0x8A, 0x92, 0x93, 0x9A);
    const auto parameters = *rc::gen::container<Bytes>(
        rc::gen::element<std::uint8_t>(0, 1, 2, 3, 4, 7, 10, 11, 24, 30, 64, 116, 132, 146, 168, 224, 225, 255));
    for (const Answer& answer : bus.handle({id, code, parameters, false})) {
      PacketReader reader(protocol);
      reader.take(answer.bytes);
      const auto packet = reader.next();
      if (code == 0x8A || code == 0x9A) continue;  // ends with the first device that is missing
      RC_ASSERT(packet.has_value());
      RC_ASSERT(!packet->damaged);
      RC_ASSERT(reader.pending() == 0u);
    }
  }
}

TEST(ServoBus, AModelThatIsNotKnownIsRefusedWithTheNamesOfThoseThatAre) {
  try {
    tableOf("MX-29", Protocol::k2);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(),
                 "model \"MX-29\" is not known, expected one of MX-28, MX-64, MX-106, XH540-W150, XH540-W270, IMU");
  }
}

}  // namespace
}  // namespace murosimf::servo_bus
