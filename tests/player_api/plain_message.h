#pragma once

/// @file Protobuf's bytes by hand, from the description of its encoding alone (protobuf.dev, "Encoding"): a second
/// implementation that shares nothing with the schema or the library.

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

namespace murosimf::testing {

/// A message that is being written.
class PlainMessage {
 public:
  PlainMessage& number(int field, std::uint64_t value) {
    tag(field, 0);
    varint(value);
    return *this;
  }
  /// sint32: zigzag.
  PlainMessage& zigzag(int field, std::int32_t value) {
    return number(field, (static_cast<std::uint32_t>(value) << 1) ^ static_cast<std::uint32_t>(value >> 31));
  }
  PlainMessage& real(int field, double value) {
    tag(field, 1);
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    for (int i = 0; i < 8; ++i) bytes.push_back(static_cast<char>(bits >> (8 * i)));
    return *this;
  }
  PlainMessage& text(int field, const std::string& value) {
    tag(field, 2);
    varint(value.size());
    bytes += value;
    return *this;
  }
  PlainMessage& message(int field, const PlainMessage& value) { return text(field, value.bytes); }

  std::string bytes;

 private:
  void varint(std::uint64_t value) {
    for (; value >= 128; value >>= 7) bytes.push_back(static_cast<char>(value | 128));
    bytes.push_back(static_cast<char>(value));
  }
  void tag(int field, int kind) { varint(static_cast<std::uint64_t>(field) << 3 | static_cast<std::uint64_t>(kind)); }
};

/// A message that is being read: its fields in their order.
class PlainReader {
 public:
  struct Field {
    int number = 0, kind = 0;
    std::uint64_t value = 0;  // kinds 0 and 1
    std::string text;         // kind 2
    double real() const {
      double x = 0;
      std::memcpy(&x, &value, sizeof x);
      return x;
    }
    std::int32_t zigzag() const {
      return static_cast<std::int32_t>(value >> 1) ^ -static_cast<std::int32_t>(value & 1);
    }
  };

  explicit PlainReader(const std::string& bytes) : bytes_(bytes) {
    while (position_ < bytes_.size()) readField();
  }

  const std::vector<Field>& fields() const { return fields_; }
  /// All fields of this number.
  std::vector<Field> all(int number) const {
    std::vector<Field> found;
    for (const Field& field : fields_)
      if (field.number == number) found.push_back(field);
    return found;
  }
  /// The last one; of nothing where there is none, as proto3 leaves out what is zero.
  Field last(int number) const {
    const std::vector<Field> found = all(number);
    return found.empty() ? Field{} : found.back();
  }

 private:
  std::uint64_t varint() {
    std::uint64_t value = 0;
    for (int shift = 0;; shift += 7) {
      const auto byte = static_cast<std::uint8_t>(bytes_.at(position_++));
      value |= static_cast<std::uint64_t>(byte & 127) << shift;
      if (byte < 128) return value;
    }
  }
  void readField() {
    Field field;
    const std::uint64_t tag = varint();
    field.number = static_cast<int>(tag >> 3), field.kind = static_cast<int>(tag & 7);
    if (field.kind == 0) {
      field.value = varint();
    } else if (field.kind == 1) {
      for (int i = 0; i < 8; ++i)
        field.value |= static_cast<std::uint64_t>(static_cast<std::uint8_t>(bytes_.at(position_++))) << (8 * i);
    } else if (field.kind == 2) {
      const std::size_t size = varint();
      field.text = bytes_.substr(position_, size);
      if (field.text.size() != size) throw std::out_of_range("a field ends too early");
      position_ += size;
    } else {
      throw std::out_of_range("a field of unknown kind");
    }
    fields_.push_back(field);
  }

  std::string bytes_;
  std::size_t position_ = 0;
  std::vector<Field> fields_;
};

}  // namespace murosimf::testing
