#pragma once

/// @file Writing a program's state into bytes, and reading it back, by one and the same function.

#include <cstddef>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace murosimf {

/// `archive(x, y, z)` writes the values when saving and restores them when loading, in the same order.
class StateArchive {
 public:
  /// An archive that writes.
  StateArchive() = default;
  /// An archive that reads. @throws std::runtime_error from operator() when the bytes end too early.
  explicit StateArchive(std::vector<std::byte> bytes) : bytes_(std::move(bytes)), loading_(true) {}

  bool loading() const { return loading_; }
  /// True when everything that was written has been read.
  bool exhausted() const { return position_ == bytes_.size(); }
  const std::vector<std::byte>& bytes() const { return bytes_; }

  template <class... Values>
  void operator()(Values&... values) {
    (value(values), ...);
  }

 private:
  template <class T>
  void value(T& x) {
    static_assert(std::is_trivially_copyable_v<T>, "give the type an archive(StateArchive&) function");
    raw(&x, sizeof(T));
  }
  template <class T>
  requires requires(T& t, StateArchive& a) { t.archive(a); }
  void value(T& x) { x.archive(*this); }
  template <class T>
  void value(std::vector<T>& list) {
    std::size_t size = list.size();
    value(size);
    if (loading_ && size > bytes_.size() - position_) throw std::runtime_error("state archive: list longer than data");
    list.resize(size);
    for (T& x : list) value(x);
  }
  void value(std::string& text) {
    std::size_t size = text.size();
    value(size);
    if (loading_ && size > bytes_.size() - position_) throw std::runtime_error("state archive: text longer than data");
    text.resize(size);
    raw(text.data(), size);
  }
  void raw(void* data, std::size_t size) {
    if (!loading_) {
      const auto* first = static_cast<const std::byte*>(data);
      bytes_.insert(bytes_.end(), first, first + size);
      return;
    }
    if (size > bytes_.size() - position_) throw std::runtime_error("state archive: data ends too early");
    std::memcpy(data, bytes_.data() + position_, size);
    position_ += size;
  }

  std::vector<std::byte> bytes_;
  std::size_t position_ = 0;
  bool loading_ = false;
};

}  // namespace murosimf
