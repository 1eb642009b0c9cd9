#pragma once

/// @file Packs of numbers that are added, multiplied and compared together: one SIMD register per pack.
///
/// A kernel is a template on its scalar S: `double`, or Pack<double, W> with one robot per lane, or Pack<float, W> with
/// one pixel per lane. Lane i of every result holds exactly the bits that the scalar kernel gives for the numbers of
/// lane i, because each operation here is the same IEEE operation on each lane. For that, kernels
///   - write fma(a, b, c) where a fused product is wanted; the compiler never fuses by itself (-ffp-contract=off);
///   - branch on no value of S, they use select(mask, a, b);
///   - use the functions of elementary.h, never those of <cmath>.
/// The pack is ours because std::experimental::simd of GCC 12 compiles wrongly under clang 14.
///
/// Cost: each operation is one instruction (AVX2: 4 doubles or 8 floats, AVX-512: 8 doubles or 16 floats).

#include <immintrin.h>

#include "murosimf/math/isa.h"

/// For the functions that kernels are made of, and the lambdas that these hand to each other: a call passes vectors and
/// inertias through memory, which costs more than what most of them do with them.
#define MUROSIMF_INLINE __attribute__((always_inline)) inline
#define MUROSIMF_INLINE_LAMBDA __attribute__((always_inline))

namespace murosimf {
inline namespace MUROSIMF_ISA {

/// The register types of W numbers of type T and of their masks. Written out because g++ 12 does not tell a vector type
/// whose size depends on a template parameter from its element type.
template <class T, int W>
struct Register;
template <>
struct Register<double, 4> {
  typedef double Numbers __attribute__((vector_size(32)));
  typedef long long Words __attribute__((vector_size(32)));
};
template <>
struct Register<double, 8> {
  typedef double Numbers __attribute__((vector_size(64)));
  typedef long long Words __attribute__((vector_size(64)));
};
template <>
struct Register<float, 8> {
  typedef float Numbers __attribute__((vector_size(32)));
  typedef int Words __attribute__((vector_size(32)));
};
template <>
struct Register<float, 16> {
  typedef float Numbers __attribute__((vector_size(64)));
  typedef int Words __attribute__((vector_size(64)));
};

/// Truth values of W lanes: all bits set or none. Combine with &, |, !; ask with any() and all().
template <class T, int W>
struct Mask {
  using Vector = typename Register<T, W>::Words;
  Vector v;
};

/// W numbers of type T in one register.
template <class T, int W>
struct Pack {
  using Scalar = T;
  static constexpr int kWidth = W;
  using Vector = typename Register<T, W>::Numbers;
  Vector v;

  Pack() = default;
  Pack(Vector vector) : v(vector) {}        // NOLINT: a register is a pack
  Pack(T scalar) : v(scalar - Vector{}) {}  // NOLINT: a number fills all lanes; 0 + x would turn -0 into +0
  Pack& operator+=(Pack b) { return v += b.v, *this; }
  Pack& operator-=(Pack b) { return v -= b.v, *this; }
  Pack& operator*=(Pack b) { return v *= b.v, *this; }
  T operator[](int lane) const { return v[lane]; }

  friend Pack operator+(Pack a, Pack b) { return Pack(a.v + b.v); }
  friend Pack operator-(Pack a, Pack b) { return Pack(a.v - b.v); }
  friend Pack operator*(Pack a, Pack b) { return Pack(a.v * b.v); }
  friend Pack operator/(Pack a, Pack b) { return Pack(a.v / b.v); }
  friend Pack operator-(Pack a) { return Pack(-a.v); }
  friend Mask<T, W> operator<(Pack a, Pack b) { return {a.v < b.v}; }
  friend Mask<T, W> operator<=(Pack a, Pack b) { return {a.v <= b.v}; }
  friend Mask<T, W> operator>(Pack a, Pack b) { return {a.v > b.v}; }
  friend Mask<T, W> operator>=(Pack a, Pack b) { return {a.v >= b.v}; }
  friend Mask<T, W> operator==(Pack a, Pack b) { return {a.v == b.v}; }
  friend Mask<T, W> operator!=(Pack a, Pack b) { return {a.v != b.v}; }
};

template <class T, int W>
inline Mask<T, W> operator&(Mask<T, W> a, Mask<T, W> b) {
  return {a.v & b.v};
}
template <class T, int W>
inline Mask<T, W> operator|(Mask<T, W> a, Mask<T, W> b) {
  return {a.v | b.v};
}
template <class T, int W>
inline Mask<T, W> operator!(Mask<T, W> a) {
  return {~a.v};
}

/// True when at least one lane is.
template <class T, int W>
inline bool any(Mask<T, W> mask) {
  bool found = false;
  for (int i = 0; i < W; ++i) found |= mask.v[i] != 0;
  return found;
}
inline bool any(Mask<double, 4> mask) {
  return _mm256_movemask_pd(_mm256_castsi256_pd(reinterpret_cast<__m256i>(mask.v))) != 0;
}
inline bool any(Mask<float, 8> mask) {
  return _mm256_movemask_ps(_mm256_castsi256_ps(reinterpret_cast<__m256i>(mask.v))) != 0;
}
#ifdef __AVX512DQ__
inline bool any(Mask<double, 8> mask) { return _mm512_movepi64_mask(reinterpret_cast<__m512i>(mask.v)) != 0; }
inline bool any(Mask<float, 16> mask) { return _mm512_movepi32_mask(reinterpret_cast<__m512i>(mask.v)) != 0; }
#endif
inline bool any(bool mask) { return mask; }
/// True when every lane is.
template <class Truth>
inline bool all(Truth mask) {
  return !any(!mask);
}

/// Lane by lane: mask ? a : b. Both are computed; an invalid number in the lane that is not taken does no harm.
template <class T, int W>
inline Pack<T, W> select(Mask<T, W> mask, Pack<T, W> a, Pack<T, W> b) {
  return Pack<T, W>(mask.v ? a.v : b.v);
}
inline double select(bool mask, double a, double b) { return mask ? a : b; }
inline float select(bool mask, float a, float b) { return mask ? a : b; }
inline int select(bool mask, int a, int b) { return mask ? a : b; }

/// a b + c, rounded once.
inline double fma(double a, double b, double c) { return __builtin_fma(a, b, c); }
inline float fma(float a, float b, float c) { return __builtin_fmaf(a, b, c); }
inline Pack<double, 4> fma(Pack<double, 4> a, Pack<double, 4> b, Pack<double, 4> c) {
  return Pack<double, 4>(_mm256_fmadd_pd(a.v, b.v, c.v));
}
/// c - a b, rounded once.
inline double fnma(double a, double b, double c) { return __builtin_fma(-a, b, c); }
inline float fnma(float a, float b, float c) { return __builtin_fmaf(-a, b, c); }
inline Pack<double, 4> fnma(Pack<double, 4> a, Pack<double, 4> b, Pack<double, 4> c) {
  return Pack<double, 4>(_mm256_fnmadd_pd(a.v, b.v, c.v));
}

/// Correctly rounded square root; NaN below zero.
inline double sqrt(double x) { return __builtin_sqrt(x); }
inline float sqrt(float x) { return __builtin_sqrtf(x); }
inline Pack<double, 4> sqrt(Pack<double, 4> x) { return Pack<double, 4>(_mm256_sqrt_pd(x.v)); }
inline Pack<float, 8> sqrt(Pack<float, 8> x) { return Pack<float, 8>(_mm256_sqrt_ps(x.v)); }

#ifdef __AVX512F__
// Square roots in the masked form: the plain one of g++ 12 begins with an undefined register, which it warns about.
inline Pack<double, 8> fma(Pack<double, 8> a, Pack<double, 8> b, Pack<double, 8> c) {
  return Pack<double, 8>(_mm512_fmadd_pd(a.v, b.v, c.v));
}
inline Pack<double, 8> fnma(Pack<double, 8> a, Pack<double, 8> b, Pack<double, 8> c) {
  return Pack<double, 8>(_mm512_fnmadd_pd(a.v, b.v, c.v));
}
inline Pack<double, 8> sqrt(Pack<double, 8> x) { return Pack<double, 8>(_mm512_mask_sqrt_pd(x.v, 0xff, x.v)); }
inline Pack<float, 16> sqrt(Pack<float, 16> x) { return Pack<float, 16>(_mm512_mask_sqrt_ps(x.v, 0xffff, x.v)); }
#endif

/// Smaller and larger of two; b where they are equal or one is NaN, in scalar and pack alike.
template <class S>
inline S min(S a, S b) {
  return select(a < b, a, b);
}
template <class S>
inline S max(S a, S b) {
  return select(a > b, a, b);
}
/// x moved into [low, high]; what is not a number stays none, so that it is noticed.
template <class S>
inline S clamp(S x, S low, S high) {
  return select(x < low, low, select(x > high, high, x));
}
template <class S>
inline S abs(S x) {
  return select(x < S(0), -x, x);
}
/// |magnitude| with the sign of x; a zero x counts as positive.
template <class S>
inline S withSignOf(S magnitude, S x) {
  return select(x < S(0), -abs(magnitude), abs(magnitude));
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
