// Streams of frames: what a client may send in any pieces, and what it may announce.

#include "murosimf/control/wire/frame_parser.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <string>
#include <vector>

namespace murosimf::testing {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// All frames of a stream that arrives in pieces of at most so many bytes.
std::vector<Bytes> framesOf(FrameParser& parser, const Bytes& stream, std::size_t piece) {
  std::vector<Bytes> frames;
  for (std::size_t i = 0; i < stream.size(); i += piece) {
    std::span<const std::uint8_t> bytes = std::span(stream).subspan(i, std::min(piece, stream.size() - i));
    while (!bytes.empty()) {
      if (parser.take(bytes)) frames.push_back(parser.frame());
    }
  }
  return frames;
}

TEST(FrameParser, LengthIsFourBytesHighestFirst) {
  FrameParser parser(1000);
  const Bytes stream{0, 0, 0, 3, 'a', 'b', 'c', 0, 0, 0, 1, 'd'};
  EXPECT_EQ(framesOf(parser, stream, stream.size()), (std::vector<Bytes>{{'a', 'b', 'c'}, {'d'}}));
  std::uint8_t header[4];
  writeFrameHeader(0x01020304, header);
  EXPECT_EQ(Bytes(header, header + 4), (Bytes{1, 2, 3, 4}));
}

TEST(FrameParser, PiecesDoNotMatter) {
  EXPECT_TRUE(rc::check("frames come out as they went in", [](const std::vector<std::string>& texts) {
    Bytes stream;
    std::vector<Bytes> sent;
    for (const std::string& text : texts) {
      sent.emplace_back(text.begin(), text.end());
      stream.resize(stream.size() + 4);
      writeFrameHeader(text.size(), stream.data() + stream.size() - 4);
      stream.insert(stream.end(), text.begin(), text.end());
    }
    const std::size_t piece = *rc::gen::inRange<std::size_t>(1, 9);
    FrameParser parser(100000);
    RC_ASSERT(framesOf(parser, stream, piece) == sent);
  }));
}

TEST(FrameParser, FrameOfNoBytesIsAFrame) {
  FrameParser parser(10);
  const Bytes stream{0, 0, 0, 0};
  std::span<const std::uint8_t> bytes(stream);
  EXPECT_TRUE(parser.take(bytes));
  EXPECT_TRUE(parser.frame().empty());
}

TEST(FrameParser, AnnouncingFourGibibytesKeepsNothing) {
  FrameParser parser(64 * 1024);
  const Bytes stream{0xFF, 0xFF, 0xFF, 0xFF, 'x', 'y'};
  EXPECT_TRUE(framesOf(parser, stream, 2).empty());
  EXPECT_TRUE(parser.isLost());
  EXPECT_EQ(parser.announced(), 0xFFFFFFFFU);
  EXPECT_EQ(parser.frame().capacity(), 0U);
}

TEST(FrameParser, WhatIsAnnouncedIsNotAllocatedBeforeItComes) {
  FrameParser parser(1 << 30);
  const Bytes stream{0x3F, 0xFF, 0xFF, 0xFF, 'x'};
  EXPECT_TRUE(framesOf(parser, stream, 1).empty());
  EXPECT_FALSE(parser.isLost());
  EXPECT_LT(parser.frame().capacity(), 100U);
}

TEST(FrameParser, NewStreamBeginsAnew) {
  FrameParser parser(2);
  const Bytes lost{0, 0, 0, 9}, good{0, 0, 0, 1, 'z'};
  framesOf(parser, lost, 4);
  EXPECT_TRUE(framesOf(parser, good, 5).empty()) << "where a frame begins is not known";
  parser.reset();
  EXPECT_EQ(framesOf(parser, good, 5), (std::vector<Bytes>{{'z'}}));
}

}  // namespace
}  // namespace murosimf::testing
