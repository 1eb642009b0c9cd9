#include "murosimf/simulation/byte_source.h"

#include <fmt/format.h>

#include <bit>
#include <cerrno>
#include <cstring>

namespace murosimf {

ByteSource::ByteSource(const std::filesystem::path& file) : file_(file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) {
    throw std::runtime_error(fmt::format("{}: cannot be read: {}", file.string(),
                                         std::filesystem::exists(file, error) ? "not a file" : "no such file"));
  }
  stream_.reset(std::fopen(file.c_str(), "rb"));
  if (stream_ == nullptr) {
    throw std::runtime_error(fmt::format("{}: cannot be read: {}", file.string(), std::strerror(errno)));
  }
  size_ = std::filesystem::file_size(file);
  std::setvbuf(stream_.get(), nullptr, _IOFBF, std::size_t{1} << 20);
}

void ByteSource::fail(std::string_view found, std::string_view expected) const {
  throw std::runtime_error(
      fmt::format("{}: byte {}: found {}, expected {}", file_.string(), value_offset_, found, expected));
}

std::span<const std::uint8_t> ByteSource::bytes(std::size_t size, std::string_view what) {
  value_offset_ = offset_;
  if (size > remaining())
    fail(fmt::format("{} bytes until the file ends", remaining()), fmt::format("{} of {}", size, what));
  if (buffer_.size() < size) buffer_.resize(size);
  if (std::fread(buffer_.data(), 1, size, stream_.get()) != size) fail("a file that cannot be read on", what);
  offset_ += size;
  return {buffer_.data(), size};
}

std::uint64_t ByteSource::number(int size, std::string_view what) {
  const std::span<const std::uint8_t> from = bytes(static_cast<std::size_t>(size), what);
  std::uint64_t x = 0;
  for (std::size_t i = 0; i < from.size(); ++i) x |= static_cast<std::uint64_t>(from[i]) << (8 * i);
  return x;
}

std::uint8_t ByteSource::u8(std::string_view what) { return static_cast<std::uint8_t>(number(1, what)); }
std::uint32_t ByteSource::u32(std::string_view what) { return static_cast<std::uint32_t>(number(4, what)); }
std::uint64_t ByteSource::u64(std::string_view what) { return number(8, what); }
double ByteSource::f64(std::string_view what) { return std::bit_cast<double>(number(8, what)); }

std::string ByteSource::text(std::string_view what) {
  const std::uint32_t length = count(what, 1, kLongestText);
  const std::span<const std::uint8_t> from = bytes(length, what);
  return {from.begin(), from.end()};
}

std::uint32_t ByteSource::count(std::string_view what, std::uint64_t least_size, std::uint64_t most) {
  const std::uint32_t n = u32(what);
  const std::uint64_t room = remaining() / least_size;
  if (n > room || n > most) {
    fail(fmt::format("a count of {}", n), fmt::format("at most {} ({})", std::min(room, most), what));
  }
  return n;
}

}  // namespace murosimf
