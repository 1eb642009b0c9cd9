#include "murosimf/algorithms/polynomial.h"

#include <algorithm>
#include <limits>

namespace murosimf {
namespace {

struct Roots {
  int count = 0;
  std::array<double, Polynomial::kLargestDegree + 1> x{};
};

/// The place in (low, high] at which the sign that p has at `low` is lost.
double closeIn(const Polynomial& p, double low, double high) {
  const bool positive = valueAt(p, low) > 0.0;
  while (true) {
    const double middle = 0.5 * (low + high);
    if (middle <= low || middle >= high) return high;
    ((valueAt(p, middle) > 0.0) == positive ? low : high) = middle;
  }
}

/// Places of (0, highest] at which p changes between positive and not positive, in ascending order.
Roots signChanges(const Polynomial& p, double highest) {
  Roots roots;
  if (p.degree == 0) return roots;
  Roots turns = signChanges(derivativeOf(p), highest);
  turns.x[static_cast<std::size_t>(turns.count++)] = highest;
  double low = 0.0;
  for (int i = 0; i < turns.count; ++i) {
    const double high = turns.x[static_cast<std::size_t>(i)];
    if ((valueAt(p, low) > 0.0) != (valueAt(p, high) > 0.0))
      roots.x[static_cast<std::size_t>(roots.count++)] = closeIn(p, low, high);
    low = high;
  }
  return roots;
}

}  // namespace

double valueAt(const Polynomial& p, double x) {
  double value = 0.0;
  for (int i = p.degree; i >= 0; --i) value = value * x + p.c[static_cast<std::size_t>(i)];
  return value;
}

Polynomial derivativeOf(const Polynomial& p) {
  Polynomial result;
  result.degree = std::max(0, p.degree - 1);
  for (std::size_t i = 1; i <= static_cast<std::size_t>(p.degree); ++i)
    result.c[i - 1] = static_cast<double>(i) * p.c[i];
  return result;
}

Polynomial product(const Polynomial& a, const Polynomial& b) {
  Polynomial result;
  result.degree = a.degree + b.degree;
  for (std::size_t i = 0; i <= static_cast<std::size_t>(a.degree); ++i)
    for (std::size_t k = 0; k <= static_cast<std::size_t>(b.degree); ++k) result.c[i + k] += a.c[i] * b.c[k];
  return result;
}

Polynomial sum(const Polynomial& a, const Polynomial& b, double factor_of_b) {
  Polynomial result;
  result.degree = std::max(a.degree, b.degree);
  for (std::size_t i = 0; i < result.c.size(); ++i) result.c[i] = a.c[i] + factor_of_b * b.c[i];
  return result;
}

double firstFall(const Polynomial& p, double highest) {
  const Roots roots = signChanges(p, highest);
  return roots.count == 0 ? std::numeric_limits<double>::infinity() : roots.x[0];
}

}  // namespace murosimf
