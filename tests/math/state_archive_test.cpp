// What is written is what is read, and what is cut short is refused.

#include "murosimf/math/state_archive.h"

#include <gtest/gtest.h>

#include "murosimf/math/transform.h"

namespace murosimf {
namespace {

struct Inner {
  std::vector<double> numbers;
  std::string name;
  void archive(StateArchive& archive) { archive(numbers, name); }
};
struct Outer {
  int count = 0;
  bool flag = false;
  Pose pose;
  std::vector<Inner> parts;
  void archive(StateArchive& archive) { archive(count, flag, pose, parts); }
};

Outer example() {
  return {7, true, {rotationZ(0.3), {1, 2, 3}}, {{{1.5, -0.0}, "left"}, {{}, ""}, {{4}, std::string("a\0b", 3)}}};
}

TEST(StateArchive, WhatIsWrittenIsRead) {
  Outer written = example(), read;
  StateArchive out;
  EXPECT_FALSE(out.loading());
  out(written);
  StateArchive in(out.bytes());
  EXPECT_TRUE(in.loading());
  in(read);
  EXPECT_TRUE(in.exhausted());
  EXPECT_EQ(read.count, 7);
  EXPECT_TRUE(read.flag);
  EXPECT_EQ(read.pose, written.pose);
  ASSERT_EQ(read.parts.size(), 3U);
  EXPECT_EQ(read.parts[0].numbers, written.parts[0].numbers);
  EXPECT_EQ(read.parts[2].name, std::string("a\0b", 3));
}

TEST(StateArchive, ReadingReplacesWhatWasThere) {
  Outer empty, full = example();
  StateArchive out;
  out(empty);
  StateArchive in(out.bytes());
  in(full);
  EXPECT_TRUE(full.parts.empty());
  EXPECT_EQ(full.count, 0);
}

TEST(StateArchive, BytesThatEndTooEarlyAreRefusedWhereverTheyEnd) {
  Outer written = example();
  StateArchive out;
  out(written);
  for (std::size_t length = 0; length < out.bytes().size(); ++length) {
    StateArchive in(std::vector<std::byte>(out.bytes().begin(), out.bytes().begin() + static_cast<long>(length)));
    Outer read;
    EXPECT_THROW(in(read), std::runtime_error) << length;
  }
}

TEST(StateArchive, AnAbsurdLengthIsRefusedBeforeMemoryIsTaken) {
  std::size_t huge = ~std::size_t{0} / 2;
  StateArchive out;
  out(huge);
  std::vector<double> numbers;
  std::string text;
  StateArchive list(out.bytes()), word(out.bytes());
  EXPECT_THROW(list(numbers), std::runtime_error);
  EXPECT_THROW(word(text), std::runtime_error);
}

}  // namespace
}  // namespace murosimf
