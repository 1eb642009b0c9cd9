#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "murosimf/control/servo_bus/packet_reader.h"
#include "servo_bus/bytes.h"

namespace murosimf::servo_bus {
namespace {

struct Example {
  const char* sentence;
  Protocol protocol;
  const char* packet;
  int id, instruction;
  const char* parameters;
};

/// Packets printed in ROBOTIS' e-Manual, pages "DYNAMIXEL Protocol 1.0" and "DYNAMIXEL Protocol 2.0".
const Example kQuestions[] = {
    {"1.0 checksum of a write", Protocol::k1, "FF FF 01 05 03 0C 64 AA DC", 1, 3, "0C 64 AA"},
    {"1.0 ping", Protocol::k1, "FF FF 01 02 01 FB", 1, 1, ""},
    {"1.0 read", Protocol::k1, "FF FF 01 04 02 2B 01 CC", 1, 2, "2B 01"},
    {"1.0 write to all", Protocol::k1, "FF FF FE 04 03 03 01 F6", 254, 3, "03 01"},
    {"1.0 reg write", Protocol::k1, "FF FF 01 05 04 1E F4 01 E2", 1, 4, "1E F4 01"},
    {"1.0 action", Protocol::k1, "FF FF FE 02 05 FA", 254, 5, ""},
    {"1.0 factory reset", Protocol::k1, "FF FF 00 02 06 F7", 0, 6, ""},
    {"1.0 sync write", Protocol::k1, "FF FF FE 0E 83 1E 04 00 10 00 50 01 01 20 02 60 03 67", 254, 0x83,
     "1E 04 00 10 00 50 01 01 20 02 60 03"},
    {"1.0 bulk read", Protocol::k1, "FF FF FE 09 92 00 02 01 1E 02 02 24 1D", 254, 0x92, "00 02 01 1E 02 02 24"},
    {"2.0 ping", Protocol::k2, "FF FF FD 00 01 03 00 01 19 4E", 1, 1, ""},
    {"2.0 ping to all", Protocol::k2, "FF FF FD 00 FE 03 00 01 31 42", 254, 1, ""},
    {"2.0 read", Protocol::k2, "FF FF FD 00 01 07 00 02 84 00 04 00 1D 15", 1, 2, "84 00 04 00"},
    {"2.0 write", Protocol::k2, "FF FF FD 00 01 09 00 03 74 00 00 02 00 00 CA 89", 1, 3, "74 00 00 02 00 00"},
    {"2.0 reg write", Protocol::k2, "FF FF FD 00 01 09 00 04 68 00 C8 00 00 00 AE 8E", 1, 4, "68 00 C8 00 00 00"},
    {"2.0 action", Protocol::k2, "FF FF FD 00 01 03 00 05 02 CE", 1, 5, ""},
    {"2.0 factory reset", Protocol::k2, "FF FF FD 00 01 04 00 06 01 A1 E6", 1, 6, "01"},
    {"2.0 reboot", Protocol::k2, "FF FF FD 00 01 03 00 08 2F 4E", 1, 8, ""},
    {"2.0 clear", Protocol::k2, "FF FF FD 00 01 08 00 10 01 44 58 4C 22 B1 DC", 1, 0x10, "01 44 58 4C 22"},
    {"2.0 sync read", Protocol::k2, "FF FF FD 00 FE 09 00 82 84 00 04 00 01 02 CE FA", 254, 0x82, "84 00 04 00 01 02"},
    {"2.0 sync write", Protocol::k2, "FF FF FD 00 FE 11 00 83 74 00 04 00 01 96 00 00 00 02 AA 00 00 00 82 87", 254,
     0x83, "74 00 04 00 01 96 00 00 00 02 AA 00 00 00"},
    {"2.0 bulk read", Protocol::k2, "FF FF FD 00 FE 0D 00 92 01 90 00 02 00 02 92 00 01 00 1A 05", 254, 0x92,
     "01 90 00 02 00 02 92 00 01 00"},
    {"2.0 bulk write", Protocol::k2, "FF FF FD 00 FE 10 00 93 01 20 00 02 00 A0 00 02 1F 00 01 00 50 B7 68", 254, 0x93,
     "01 20 00 02 00 A0 00 02 1F 00 01 00 50"},
};

const Example kAnswers[] = {
    {"1.0 no error", Protocol::k1, "FF FF 01 02 00 FC", 1, 0, ""},
    {"1.0 two errors", Protocol::k1, "FF FF 01 02 24 D8", 1, 0x24, ""},
    {"1.0 temperature", Protocol::k1, "FF FF 01 03 00 20 DB", 1, 0, "20"},
    {"1.0 position", Protocol::k1, "FF FF 02 04 00 00 80 79", 2, 0, "00 80"},
    {"2.0 model and firmware", Protocol::k2, "FF FF FD 00 01 07 00 55 00 06 04 26 65 5D", 1, 0, "06 04 26"},
    {"2.0 position", Protocol::k2, "FF FF FD 00 02 08 00 55 00 1F 08 00 00 BA BE", 2, 0, "1F 08 00 00"},
    {"2.0 done", Protocol::k2, "FF FF FD 00 01 04 00 55 00 A1 0C", 1, 0, ""},
};

std::vector<InstructionPacket> readAll(Protocol protocol, const std::vector<Bytes>& parts) {
  PacketReader reader(protocol);
  std::vector<InstructionPacket> found;
  for (const Bytes& part : parts) {
    reader.take(part);
    while (std::optional<InstructionPacket> packet = reader.next()) found.push_back(*packet);
  }
  return found;
}

TEST(ServoBusPackets, QuestionsOfTheManualAreReadAndWrittenByteForByte) {
  for (const Example& example : kQuestions) {
    const auto found = readAll(example.protocol, {bytes(example.packet)});
    ASSERT_EQ(found.size(), 1u) << example.sentence;
    EXPECT_FALSE(found[0].damaged) << example.sentence;
    EXPECT_EQ(found[0].id, example.id) << example.sentence;
    EXPECT_EQ(found[0].instruction, example.instruction) << example.sentence;
    EXPECT_EQ(text(found[0].parameters), example.parameters) << example.sentence;
    Bytes written;
    appendInstruction(example.protocol, found[0].id, found[0].instruction, found[0].parameters, written);
    EXPECT_EQ(text(written), example.packet) << example.sentence;
  }
}

TEST(ServoBusPackets, AnswersOfTheManualAreWrittenByteForByte) {
  for (const Example& example : kAnswers) {
    Bytes written;
    appendStatus(example.protocol, static_cast<std::uint8_t>(example.id),
                 static_cast<std::uint8_t>(example.instruction), bytes(example.parameters), written);
    EXPECT_EQ(text(written), example.packet) << example.sentence;
  }
}

/// bit-bots' program for their board sends this answer, in which a byte is stuffed.
TEST(ServoBusPackets, AHeaderWithinDataIsStuffed) {
  Bytes written;
  appendStatus(Protocol::k2, 0x14, 0, bytes("25 00 F6 FF FF FF FD 07 00 00"), written);
  EXPECT_EQ(text(written), "FF FF FD 00 14 0F 00 55 00 25 00 F6 FF FF FF FD FD 07 00 00 E4 3B");
}

RC_GTEST_PROP(ServoBusPackets, WhatIsWrittenIsReadWhateverItsBytesAndHoweverItIsCut, ()) {
  const Protocol protocol = *rc::gen::element(Protocol::k1, Protocol::k2);
  const auto awkward = rc::gen::element<std::uint8_t>(0xFF, 0xFD, 0x00, 0xFE, 0x03);
  Bytes stream;
  std::vector<Bytes> sent;
  for (int i = 0; i < 3; ++i) {
    sent.push_back(*rc::gen::container<Bytes>(awkward));
    if (sent.back().size() > 200) sent.back().resize(200);
    appendInstruction(protocol, 7, 3, sent.back(), stream);
  }
  std::vector<Bytes> parts;
  for (std::size_t first = 0; first < stream.size();) {
    const std::size_t size = std::min(*rc::gen::inRange<std::size_t>(1, 9), stream.size() - first);
    const auto start = stream.begin() + static_cast<std::ptrdiff_t>(first);
    parts.emplace_back(start, start + static_cast<std::ptrdiff_t>(size));
    first += size;
  }
  const auto found = readAll(protocol, parts);
  RC_ASSERT(found.size() == sent.size());
  for (std::size_t i = 0; i < sent.size(); ++i) {
    RC_ASSERT(!found[i].damaged);
    RC_ASSERT(found[i].parameters == sent[i]);
  }
}

TEST(ServoBusPackets, NoiseBeforeAHeaderIsSkipped) {
  const auto one = readAll(Protocol::k1, {bytes("00 FF 13 FF FF FF FF 01 02 01 FB")});
  ASSERT_EQ(one.size(), 1u);
  EXPECT_EQ(one[0].id, 1);
  const auto two = readAll(Protocol::k2, {bytes("FF FD 00 FF FF FD FD FF FF FF FD 00 01 03 00 01 19 4E")});
  ASSERT_EQ(two.size(), 1u);
  EXPECT_EQ(two[0].id, 1);
}

TEST(ServoBusPackets, ADamagedPacketIsToldOfAndTheNextOneIsFound) {
  const auto found = readAll(Protocol::k2, {bytes("FF FF FD 00 01 03 00 01 19 4F FF FF FD 00 02 03 00 01 19 72")});
  ASSERT_EQ(found.size(), 2u);
  EXPECT_TRUE(found[0].damaged);
  EXPECT_EQ(found[0].id, 1);
  EXPECT_FALSE(found[1].damaged);
  EXPECT_EQ(found[1].id, 2);
  const auto one = readAll(Protocol::k1, {bytes("FF FF 01 02 01 FC FF FF 01 02 01 FB")});
  ASSERT_EQ(one.size(), 2u);
  EXPECT_TRUE(one[0].damaged);
  EXPECT_FALSE(one[1].damaged);
}

TEST(ServoBusPackets, ALengthThatNoPacketHasIsNoise) {
  PacketReader reader(Protocol::k2);
  reader.take(bytes("FF FF FD 00 01 FF FF 01"));
  EXPECT_FALSE(reader.next());
  EXPECT_EQ(reader.pending(), 0u) << "nothing of it is kept";
  reader.take(bytes("FF FF FD 00 01 02 00 01"));
  EXPECT_FALSE(reader.next());
  EXPECT_EQ(reader.pending(), 0u);
}

TEST(ServoBusPackets, APacketThatIsNeverFinishedDoesNotSwallowTheNext) {
  PacketReader reader(Protocol::k1);
  reader.take(bytes("FF FF 01 F0 03"));
  EXPECT_FALSE(reader.next());
  reader.take(bytes("FF FF 01 02 01 FB"));
  EXPECT_FALSE(reader.next());
  reader.giveUp();
  const auto packet = reader.next();
  ASSERT_TRUE(packet);
  EXPECT_EQ(packet->instruction, 1);
}

}  // namespace
}  // namespace murosimf::servo_bus
