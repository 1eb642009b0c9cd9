#pragma once

/// @file An array whose elements are not set when it is made.
///
/// Vectors set themselves to zero; for working memory of ten kilobytes on the stack, of which a fraction is used, that
/// would take as long as the work. An element must be assigned before it is read.

#include <cstddef>
#include <span>
#include <type_traits>

namespace murosimf {

template <class T, std::size_t N>
class UnsetArray {
  static_assert(std::is_aggregate_v<T> || std::is_scalar_v<T>);  // so that the bytes may be taken for elements
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  template <class Index>
  T& operator[](Index i) {
    return elements()[i];
  }
  template <class Index>
  const T& operator[](Index i) const {
    return const_cast<UnsetArray*>(this)->elements()[i];
  }
  std::span<T> all() { return {elements(), N}; }

 private:
  T* elements() { return reinterpret_cast<T*>(bytes_); }

  alignas(T) std::byte bytes_[N * sizeof(T)];
};

}  // namespace murosimf
