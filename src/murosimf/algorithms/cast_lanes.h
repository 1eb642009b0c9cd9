#pragma once

/// @file What the ray caster's kernels need of packs beyond arithmetic: memory, masks as bits, and unsigned words.
///
/// For kernels only. A function here exists for float (one lane), Pack<float, 8> and, where compiled for it,
/// Pack<float, 16>.

#include <cstdint>

#include "murosimf/math/pack.h"

namespace murosimf {
inline namespace MUROSIMF_ISA {

/// Number of lanes of S and its 32-bit unsigned words.
template <class S>
struct Lanes;
template <>
struct Lanes<float> {
  static constexpr int kWidth = 1;
  using Words = std::uint32_t;
};
template <>
struct Lanes<Pack<float, 8>> {
  static constexpr int kWidth = 8;
  typedef std::uint32_t Words __attribute__((vector_size(32)));
};
template <>
struct Lanes<Pack<float, 16>> {
  static constexpr int kWidth = 16;
  typedef std::uint32_t Words __attribute__((vector_size(64)));
};
template <class S>
using WordsOf = typename Lanes<S>::Words;

/// W numbers from and to memory of any alignment.
template <class S>
inline S load(const float* from) {
  S value;
  __builtin_memcpy(&value, from, sizeof value);
  return value;
}
template <class S>
inline void store(float* to, S value) {
  __builtin_memcpy(to, &value, sizeof value);
}
template <class S>
inline WordsOf<S> loadWords(const std::uint32_t* from) {
  WordsOf<S> words;
  __builtin_memcpy(&words, from, sizeof words);
  return words;
}
template <class S>
inline void storeWords(std::uint32_t* to, WordsOf<S> words) {
  __builtin_memcpy(to, &words, sizeof words);
}

/// Bit i is lane i's truth.
inline unsigned laneBits(bool mask) { return mask ? 1U : 0U; }
inline unsigned laneBits(Mask<float, 8> mask) {
  return static_cast<unsigned>(_mm256_movemask_ps(_mm256_castsi256_ps(reinterpret_cast<__m256i>(mask.v))));
}
#ifdef __AVX512DQ__
inline unsigned laneBits(Mask<float, 16> mask) {
  return static_cast<unsigned>(_mm512_movepi32_mask(reinterpret_cast<__m512i>(mask.v)));
}
#endif

/// The 32 bits of numbers as words, and back.
template <class S>
inline WordsOf<S> bitsOf(S numbers) {
  WordsOf<S> words;
  __builtin_memcpy(&words, &numbers, sizeof words);
  return words;
}
template <class S>
inline S numberOfBits(WordsOf<S> words) {
  S numbers;
  __builtin_memcpy(&numbers, &words, sizeof numbers);
  return numbers;
}

/// table[index], lane by lane.
template <class S>
inline WordsOf<S> gather(const std::uint32_t* table, WordsOf<S> index);
template <>
inline std::uint32_t gather<float>(const std::uint32_t* table, std::uint32_t index) {
  return table[index];
}
template <>
inline WordsOf<Pack<float, 8>> gather<Pack<float, 8>>(const std::uint32_t* table, WordsOf<Pack<float, 8>> index) {
  const __m256i found =
      _mm256_i32gather_epi32(reinterpret_cast<const int*>(table), reinterpret_cast<__m256i>(index), 4);
  return reinterpret_cast<WordsOf<Pack<float, 8>>>(found);
}
#ifdef __AVX512F__
template <>
inline WordsOf<Pack<float, 16>> gather<Pack<float, 16>>(const std::uint32_t* table, WordsOf<Pack<float, 16>> index) {
  const __m512i from =
      reinterpret_cast<__m512i>(index);  // the plain gather of g++ 12 begins with an undefined register
  const __m512i found = _mm512_mask_i32gather_epi32(from, 0xffff, from, table, 4);
  return reinterpret_cast<WordsOf<Pack<float, 16>>>(found);
}
#endif

/// Words below 2^31 as numbers, and numbers in [0, 2^31) as words, cut off.
inline float toNumber(std::uint32_t words) { return static_cast<float>(static_cast<std::int32_t>(words)); }
inline Pack<float, 8> toNumber(WordsOf<Pack<float, 8>> words) {
  return __builtin_convertvector(reinterpret_cast<Mask<float, 8>::Vector>(words), Pack<float, 8>::Vector);
}
inline std::uint32_t toWords(float x) { return static_cast<std::uint32_t>(static_cast<std::int32_t>(x)); }
inline WordsOf<Pack<float, 8>> toWords(Pack<float, 8> x) {
  return reinterpret_cast<WordsOf<Pack<float, 8>>>(__builtin_convertvector(x.v, Mask<float, 8>::Vector));
}
#ifdef __AVX512F__
inline Pack<float, 16> toNumber(WordsOf<Pack<float, 16>> words) {
  return __builtin_convertvector(reinterpret_cast<Mask<float, 16>::Vector>(words), Pack<float, 16>::Vector);
}
inline WordsOf<Pack<float, 16>> toWords(Pack<float, 16> x) {
  return reinterpret_cast<WordsOf<Pack<float, 16>>>(__builtin_convertvector(x.v, Mask<float, 16>::Vector));
}
#endif

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
