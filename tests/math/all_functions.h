#pragma once

/// @file Everything of math/ that kernels use, applied to four numbers: the same for scalar and packs.

#include "murosimf/math/transform.h"

namespace murosimf {
inline namespace MUROSIMF_ISA {

inline constexpr int kInputs = 4, kOutputs = 64;

/// Fills `out` and returns how many numbers there are.
template <class S>
inline int allFunctions(const S* in, S* out) {
  const S a = in[0], b = in[1], c = in[2], d = in[3];
  int n = 0;
  const auto put = [&](S x) { out[n++] = x; };
  const auto putVector = [&](const Vec3<S>& v) { put(v.x), put(v.y), put(v.z); };
  put(a + b), put(a - b), put(a * b), put(a / b), put(-a);
  put(fma(a, b, c)), put(fnma(a, b, c)), put(sqrt(abs(a)));
  put(min(a, b)), put(max(a, b)), put(clamp(a, S(-0.5), S(0.5))), put(withSignOf(a, b));
  put(select(a < b, c, d)), put(select((a < b) & !(c > d), c, d)), put(select((a <= b) | (c == d), a, d));
  put(roundToInteger(S(10) * a));
  put(sin(a)), put(cos(S(100) * b)), put(tan(c));
  put(exp(a)), put(log(abs(b) + S(1e-3))), put(tanh(S(3) * c)), put(tanh(S(0.1) * c));
  put(atan2(a, b)), put(atan2(a, S(0))), put(asin(c)), put(acos(d)), put(wrapAngle(S(20) * a));
  const Vec3<S> v{a, b, c}, w{b, c, d};
  put(dot(v, w)), put(norm(v)), putVector(cross(v, w)), putVector(normalized(w));
  const Rotation<S> R = fromRollPitchYaw(v) * rotationExp(w);
  putVector(rotationLog(R)), putVector(toRollPitchYaw(R)), putVector(applyTransposed(R, v));
  const Transform<S> X{R, w};
  putVector(inverse(X) * v), putVector((X * X).translation), putVector(interpolate(X, inverse(X), S(0.3)).translation);
  putVector(orthonormalized(R).y);
  return n;
}

}  // namespace MUROSIMF_ISA

/// The same on eight lanes: in and out are [number][lane]. Compiled for AVX-512.
int allFunctionsInEight(const double* in, double* out);

}  // namespace murosimf
