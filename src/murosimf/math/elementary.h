#pragma once

/// @file Elementary functions with the same bits on every machine, compiler and lane width.
///
/// The C library's functions differ between versions and have no pack form; these are sums, products and selects only.
/// Accuracy (checked by tests/math): a few units in the last place over the ranges named.
/// Sources: argument reduction [Cody & Waite 1980]; kernel polynomials of sine and cosine [Ng, fdlibm]; arc tangent
/// rational approximation [Moshier, Cephes]; tanh by Lambert's continued fraction near zero.

#include "murosimf/math/bits.h"

namespace murosimf {
inline namespace MUROSIMF_ISA {

inline constexpr double kPi = 3.14159265358979323846;

template <class S>
struct SinCos {
  S sin, cos;
};

/// Sine of r, |r| <= pi/4.
template <class S>
inline S sinKernel(S r) {
  const S z = r * r;
  S p = fma(z, S(1.58969099521155010221e-10), S(-2.50507602534068634195e-08));
  p = fma(z, p, S(2.75573137070700676789e-06));
  p = fma(z, p, S(-1.98412698298579493134e-04));
  p = fma(z, p, S(8.33333333332248946124e-03));
  p = fma(z, p, S(-1.66666666666666324348e-01));
  return fma(z * r, p, r);
}

/// Cosine of r, |r| <= pi/4.
template <class S>
inline S cosKernel(S r) {
  const S z = r * r;
  S p = fma(z, S(-1.13596475577881948265e-11), S(2.08757232129817482790e-09));
  p = fma(z, p, S(-2.75573143513906633035e-07));
  p = fma(z, p, S(2.48015872894767294178e-05));
  p = fma(z, p, S(-1.38888888888741095749e-03));
  p = fma(z, p, S(4.16666666666666019037e-02));
  return fma(z * z, p, fma(S(-0.5), z, S(1)));
}

/// Sine and cosine of x [rad], |x| < 1e5.
template <class S>
inline SinCos<S> sincos(S x) {
  const S shifted = x * S(0.63661977236758134308) + S(kRoundingShift);  // 2/pi
  const S k = shifted - S(kRoundingShift);                              // quadrants
  S r = fnma(k, S(1.57079632679489655800e+00), x);                      // pi/2 in three pieces
  r = fnma(k, S(6.12323399573676603587e-17), r);
  r = fnma(k, S(-1.49738490485916983700e-33), r);
  const S s = sinKernel(r), c = cosKernel(r);
  const auto odd = isOdd(shifted);
  return {negatedInSecondHalf(select(odd, c, s), shifted, 0), negatedInSecondHalf(select(odd, s, c), shifted, 1)};
}
template <class S>
inline S sin(S x) {
  return sincos(x).sin;
}
template <class S>
inline S cos(S x) {
  return sincos(x).cos;
}
template <class S>
inline S tan(S x) {
  const SinCos<S> sc = sincos(x);
  return sc.sin / sc.cos;
}

/// Arc tangent of t in [0, inf]: folded to |t| <= 0.66 by pi/4 and pi/2.
template <class S>
inline S atanPositive(S t) {
  const auto steep = t > S(2.41421356237309504880);
  const auto middle = (!steep) & (t > S(0.66));
  const S folded = select(steep, S(-1) / t, select(middle, (t - S(1)) / (t + S(1)), t));
  const S offset = select(steep, S(kPi / 2), select(middle, S(kPi / 4), S(0)));
  const S z = folded * folded;
  S p = fma(z, S(-8.750608600031904122785e-01), S(-1.615753718733365076637e+01));
  p = fma(z, p, S(-7.500855792314704667340e+01));
  p = fma(z, p, S(-1.228866684490136173410e+02));
  p = fma(z, p, S(-6.485021904942025371773e+01));
  S q = z + S(2.485846490142306297962e+01);
  q = fma(z, q, S(1.650270098316988542046e+02));
  q = fma(z, q, S(4.328810604912902668951e+02));
  q = fma(z, q, S(4.853903996359136964868e+02));
  q = fma(z, q, S(1.945506571482613964425e+02));
  return offset + fma(folded * z, p / q, folded);
}

/// Angle of the point (x, y) [rad] in [-pi, pi]; 0 for the origin, pi for negative x and y of either zero.
template <class S>
inline S atan2(S y, S x) {
  const S height = abs(y), width = abs(x);
  const auto origin = (height == S(0)) & (width == S(0));
  const S angle = atanPositive(height / select(origin, S(1), width));
  const S upper = select(x < S(0), S(kPi) - angle, angle);
  return select(y < S(0), -upper, upper);
}
/// Arc sine and cosine [rad]; x outside [-1, 1] counts as the nearer end, so rounding never makes a NaN.
template <class S>
inline S asin(S x) {
  const S u = clamp(x, S(-1), S(1));
  return atan2(u, sqrt((S(1) - u) * (S(1) + u)));
}
template <class S>
inline S acos(S x) {
  const S u = clamp(x, S(-1), S(1));
  return atan2(sqrt((S(1) - u) * (S(1) + u)), u);
}

/// e^x for |x| <= 700; beyond it stays at e^-700 or e^700.
template <class S>
inline S exp(S x) {
  const S u = clamp(x, S(-700), S(700));
  const S k = roundToInteger(u * S(1.44269504088896338700));  // 1/ln 2
  const S r = fnma(k, S(1.90821492927058770002e-10), fnma(k, S(6.93147180369123816490e-01), u));
  S p = S(1.0 / 6227020800.0);  // Taylor series to r^13: |r| <= ln 2 / 2 leaves 5e-18
  constexpr double kInverseFactorial[] = {
      1.0 / 479001600, 1.0 / 39916800, 1.0 / 3628800, 1.0 / 362880, 1.0 / 40320, 1.0 / 5040, 1.0 / 720,
      1.0 / 120,       1.0 / 24,       1.0 / 6,       0.5,          1.0,         1.0};
  for (const double c : kInverseFactorial) p = fma(r, p, S(c));
  return p * powerOfTwo(k);
}

/// Natural logarithm of a positive normal x.
template <class S>
inline S log(S x) {
  const MantissaExponent<S> split = splitExponent(x);
  const auto large = split.mantissa > S(1.41421356237309504880);
  const S m = select(large, split.mantissa * S(0.5), split.mantissa);
  const S e = select(large, split.exponent + S(1), split.exponent);
  const S f = (m - S(1)) / (m + S(1));  // ln m = 2 artanh f = 2 (f + f^3/3 + f^5/5 + ...), |f| <= 0.172
  const S z = f * f;
  S p = S(1.0 / 23);
  for (int n = 21; n >= 3; n -= 2) p = fma(z, p, S(1.0 / n));
  return fma(e, S(6.93147180369123816490e-01), fma(S(2) * f * z, p, fma(e, S(1.90821492927058770002e-10), S(2) * f)));
}

/// Hyperbolic tangent.
template <class S>
inline S tanh(S x) {
  const S z = x * x;  // x / (1 + z / (3 + z / (5 + ...))) for |x| < 1/4
  const S fraction = x / (S(1) + z / (S(3) + z / (S(5) + z / (S(7) + z / (S(9) + z / (S(11) + z / S(13)))))));
  const S e = exp(S(2) * clamp(x, S(-20), S(20)));
  return select(z < S(0.0625), fraction, (e - S(1)) / (e + S(1)));
}

/// The angle x moved into [-pi, pi] [rad].
template <class S>
inline S wrapAngle(S x) {
  return fnma(roundToInteger(x * S(0.5 / kPi)), S(2 * kPi), x);
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
