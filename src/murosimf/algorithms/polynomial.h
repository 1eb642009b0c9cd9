#pragma once

/// @file Where a polynomial first falls to zero: found for certain, since between two places where its derivative
/// vanishes a polynomial is monotone and a change of sign is closed in by halving.

#include <array>

namespace murosimf {

/// c[0] + c[1] x + ... + c[degree] x^degree; what follows is not read.
struct Polynomial {
  static constexpr int kLargestDegree = 7;
  int degree = 0;
  std::array<double, kLargestDegree + 1> c{};
};

double valueAt(const Polynomial& p, double x);
Polynomial derivativeOf(const Polynomial& p);
Polynomial product(const Polynomial& a, const Polynomial& b);  ///< degrees together at most kLargestDegree
Polynomial sum(const Polynomial& a, const Polynomial& b, double factor_of_b = 1.0);

/// Smallest x in (0, highest] at which p, which is positive at 0, is zero or negative; infinity when there is none.
/// Cost: some 100 evaluations for each degree and each turn.
double firstFall(const Polynomial& p, double highest);

}  // namespace murosimf
