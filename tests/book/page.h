#pragma once

/// @file Pages of the validation book (docs/validation.md): what a test compares with a closed form, written down for
/// `make book` to draw.

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

namespace murosimf::book {

enum class Chapter {
  kRestAndImpact,
  kFriction,
  kRolling,
  kCollisions,
  kMechanisms,
  kFlight,
  kOnTheGround,
  kIntegrators,
  kServos,
  kSensors,
  kLenses,
  kPictures,
  kRobots,
  kNumbers
};

/// A letter of the formula: in TeX without dollars, what it means, its unit ("" for a pure number).
struct Symbol {
  std::string symbol, meaning, unit;
};

/// What an axis of the plot shows; text with mathematics between dollars.
struct Axis {
  std::string name, unit;
  bool logarithmic = false;
};

/// What stands at the head of a page. Formula: TeX without dollars, as far as matplotlib's mathtext knows it; every
/// line is set as one. Source: as in docs/references.md, or a few words of derivation.
struct Head {
  Chapter chapter;
  std::string claim, formula, source;
  std::vector<Symbol> symbols;
  Axis x, y;
};

/// One test's page. Compares as EXPECT_NEAR and EXPECT_LE do, and writes down what it compared:
///
///     book::Page page({book::Chapter::kRolling, "A ball ...", R"(v = v_0 - c_r g t)", "[Author Year, 3]",
///                      {{"c_r", "rolling resistance", ""}}, {"time $t$", "s"}, {"speed $v$", "m/s"}});
///     page.curve(0, 2, [&](double t) { return speedAt(t); });
///     EXPECT_TRUE(page.near(t, ball.speed(), speedAt(t), 1e-3)) << "solid ball";
///
/// Declare it in the body of the test: tools/book_tests.sh finds it there. When the page goes out of scope it is
/// written to $MUROSIMF_BOOK/<test>.json; without that variable nothing is kept or written. The instances of a TEST_P
/// make one page together.
class Page {
 public:
  explicit Page(Head head);
  ~Page();
  Page(const Page&) = delete;
  Page& operator=(const Page&) = delete;

  /// Points and curves from here on belong to the series of this name, or of this name and number.
  Page& series(const std::string& name);
  Page& series(const std::string& name, double number);
  /// Whether |found - theory| <= tolerance (never for what is no number).
  testing::AssertionResult near(double x, double found, double theory, double tolerance);
  /// Whether |found| <= bound: an error, say. Drawn as a point below a line.
  testing::AssertionResult below(double x, double found, double bound);
  /// The theory between two abscissae, for the eye alone: 200 values of `theory`, evenly spread over the axis. Replaces
  /// the curve that the series had.
  void curve(double low, double high, const std::function<double(double)>& theory);

 private:
  struct Series {
    std::string name;
    bool bounded = false;  ///< points below a bound, not beside a theory
    std::vector<double> x, found, theory, tolerance;
    std::vector<double> curve_x, curve_y;
  };
  Series& current(bool bounded);
  void write() const;

  Head head_;
  std::string folder_;  ///< empty: nobody asked for the book
  std::string name_;    ///< of the current series
  std::vector<Series> series_;
};

}  // namespace murosimf::book
