#pragma once

/// @file Counts the allocations of a test program by replacing its operator new. Include it in one file of a program.
///
/// All forms are replaced: sanitizers complain of memory that one form gave and another one's partner takes back.

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>

namespace murosimf::test {

inline std::atomic<long> allocations{0};

inline void* countedMemory(std::size_t size, std::size_t alignment = alignof(std::max_align_t)) {
  ++allocations;
  const std::size_t whole = (size + alignment - 1) / alignment * alignment;
  void* memory = std::aligned_alloc(alignment, whole == 0 ? alignment : whole);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

}  // namespace murosimf::test

// Replacements cannot be inline.
// NOLINTBEGIN(misc-definitions-in-headers)
void* operator new(std::size_t size) { return murosimf::test::countedMemory(size); }
void* operator new[](std::size_t size) { return murosimf::test::countedMemory(size); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return murosimf::test::countedMemory(size); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return murosimf::test::countedMemory(size); }
void* operator new(std::size_t size, std::align_val_t a) {
  return murosimf::test::countedMemory(size, static_cast<std::size_t>(a));
}
void* operator new[](std::size_t size, std::align_val_t a) {
  return murosimf::test::countedMemory(size, static_cast<std::size_t>(a));
}
void operator delete(void* p) noexcept { std::free(p); }
void operator delete[](void* p) noexcept { std::free(p); }
void operator delete(void* p, const std::nothrow_t&) noexcept { std::free(p); }
void operator delete[](void* p, const std::nothrow_t&) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }
void operator delete[](void* p, std::size_t) noexcept { std::free(p); }
void operator delete(void* p, std::align_val_t) noexcept { std::free(p); }
void operator delete[](void* p, std::align_val_t) noexcept { std::free(p); }
void operator delete(void* p, std::size_t, std::align_val_t) noexcept { std::free(p); }
void operator delete[](void* p, std::size_t, std::align_val_t) noexcept { std::free(p); }
// NOLINTEND(misc-definitions-in-headers)
