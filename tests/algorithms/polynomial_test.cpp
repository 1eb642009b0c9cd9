#include "murosimf/algorithms/polynomial.h"

#include <gtest/gtest.h>

#include <cmath>

namespace murosimf {
namespace {

TEST(Polynomial, FirstFallIsTheSmallestRoot) {
  const Polynomial line{1, {3.0, -2.0}};
  EXPECT_NEAR(firstFall(line, 10), 1.5, 1e-15);
  EXPECT_TRUE(std::isinf(firstFall(line, 1.4)));
  const Polynomial three = product(product({1, {1.0, -1.0}}, {1, {2.0, -1.0}}), {1, {3.0, -1.0}});  // 1, 2, 3
  EXPECT_NEAR(firstFall(three, 1e12), 1.0, 1e-14);
  EXPECT_TRUE(std::isinf(firstFall({2, {1.0, 0.0, 1.0}}, 1e12)));
  EXPECT_TRUE(std::isinf(firstFall({0, {1.0}}, 1e12)));
}

TEST(Polynomial, FindsRootsThatStandCloseTogether) {
  const double a = 2.0, b = 2.0 + 1e-6;
  const Polynomial p = product({1, {a, -1.0}}, {1, {b, -1.0}});
  EXPECT_NEAR(firstFall(p, 1e12), a, 1e-9);
}

TEST(Polynomial, SumProductAndDerivativeFollowTheirDefinitions) {
  const Polynomial a{2, {1.0, 2.0, 3.0}}, b{1, {-1.0, 4.0}};
  const double x = 0.7;
  EXPECT_NEAR(valueAt(sum(a, b, 2.0), x), valueAt(a, x) + 2 * valueAt(b, x), 1e-15);
  EXPECT_NEAR(valueAt(product(a, b), x), valueAt(a, x) * valueAt(b, x), 1e-15);
  EXPECT_NEAR(valueAt(derivativeOf(a), x), 2.0 + 6.0 * x, 1e-15);
}

}  // namespace
}  // namespace murosimf
