#pragma once

/// @file Hash of contents: two things with the same hash are taken for the same thing.
///
/// SHA-256 [FIPS 180-4], by libcrypto. Parts are added with their lengths, so that "ab", "c" is not "a", "bc".

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace murosimf {

class ContentHash {
 public:
  ContentHash();
  ~ContentHash();
  ContentHash(const ContentHash&) = delete;
  ContentHash& operator=(const ContentHash&) = delete;

  void add(std::string_view part);
  /// 64 hexadecimal digits of all that was added. Call once.
  std::string text();

 private:
  struct Context;
  std::unique_ptr<Context> context_;
};

/// SHA-256 of the bytes alone, as `sha256sum` prints it.
std::string sha256(std::string_view bytes);
/// The same of a file. @throws std::runtime_error naming the file where it cannot be read.
std::string sha256OfFile(const std::filesystem::path& file);
/// Everything in a file. @throws std::runtime_error likewise
std::string readWholeFile(const std::filesystem::path& file);

}  // namespace murosimf
