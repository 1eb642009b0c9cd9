#include "experiment/content_hash.h"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace murosimf {

namespace {

std::string hexadecimal(const unsigned char* bytes, std::size_t count) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) text += fmt::format("{:02x}", bytes[i]);
  return text;
}

void require(int succeeded) {
  if (succeeded != 1) throw std::runtime_error("libcrypto cannot compute SHA-256");
}

}  // namespace

struct ContentHash::Context {
  EVP_MD_CTX* digest = EVP_MD_CTX_new();
  ~Context() { EVP_MD_CTX_free(digest); }
};

ContentHash::ContentHash() : context_(std::make_unique<Context>()) {
  require(EVP_DigestInit_ex(context_->digest, EVP_sha256(), nullptr));
}

ContentHash::~ContentHash() = default;

void ContentHash::add(std::string_view part) {
  std::array<unsigned char, 8> length{};
  for (std::size_t i = 0; i < length.size(); ++i)
    length[i] = static_cast<unsigned char>(static_cast<std::uint64_t>(part.size()) >> (8 * i));
  require(EVP_DigestUpdate(context_->digest, length.data(), length.size()));
  require(EVP_DigestUpdate(context_->digest, part.data(), part.size()));
}

std::string ContentHash::text() {
  std::array<unsigned char, EVP_MAX_MD_SIZE> bytes{};
  unsigned count = 0;
  require(EVP_DigestFinal_ex(context_->digest, bytes.data(), &count));
  return hexadecimal(bytes.data(), count);
}

std::string sha256(std::string_view bytes) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> out{};
  unsigned count = 0;
  require(EVP_Digest(bytes.data(), bytes.size(), out.data(), &count, EVP_sha256(), nullptr));
  return hexadecimal(out.data(), count);
}

std::string sha256OfFile(const std::filesystem::path& file) { return sha256(readWholeFile(file)); }

std::string readWholeFile(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  if (stream.peek() != std::ifstream::traits_type::eof()) text << stream.rdbuf();
  if (!stream.is_open() || stream.bad() || text.fail()) {
    throw std::runtime_error(fmt::format("{}: cannot be read: {}", file.string(), std::strerror(errno)));
  }
  return text.str();
}

}  // namespace murosimf
