#pragma once

/// @file Reads what ByteWriter wrote, from a file that may be damaged.
///
/// Nothing is believed: every count is compared with what is left of the file before memory is taken for it, and every
/// error says `FILE: byte N: found ..., expected ...`.

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace murosimf {

class ByteSource {
 public:
  /// @throws std::runtime_error when the file cannot be read.
  explicit ByteSource(const std::filesystem::path& file);

  const std::filesystem::path& file() const { return file_; }
  std::uint64_t offset() const { return offset_; }  ///< of the next byte
  std::uint64_t remaining() const { return size_ - offset_; }
  bool atEnd() const { return remaining() == 0; }

  // Each names what it is about to read, for the error. @throws std::runtime_error where the file ends too early.
  std::uint8_t u8(std::string_view what);
  std::uint32_t u32(std::string_view what);
  std::uint64_t u64(std::string_view what);
  double f64(std::string_view what);
  /// A text of at most kLongestText characters.
  std::string text(std::string_view what);
  /// A count of things that take at least `least_size` bytes each of what is left, and at most `most` of them.
  std::uint32_t count(std::string_view what, std::uint64_t least_size, std::uint64_t most);
  /// This many bytes; valid until the next call.
  std::span<const std::uint8_t> bytes(std::size_t size, std::string_view what);

  /// Throws `FILE: byte N: found F, expected E`; N is where the last value read began.
  [[noreturn]] void fail(std::string_view found, std::string_view expected) const;

  static constexpr std::uint32_t kLongestText = 4096;

 private:
  struct CloseFile {
    void operator()(std::FILE* f) const { std::fclose(f); }
  };
  std::uint64_t number(int size, std::string_view what);

  std::filesystem::path file_;
  std::unique_ptr<std::FILE, CloseFile> stream_;
  std::uint64_t size_ = 0, offset_ = 0, value_offset_ = 0;
  std::vector<std::uint8_t> buffer_;
};

}  // namespace murosimf
