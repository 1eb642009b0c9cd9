#pragma once

/// @file S-expressions, as the servers of the 3D Simulation League and their clients write them: (name value (name
/// ...)).
///
/// An expression is a word or a list of expressions; words are what stands between blanks and parentheses. What a
/// client may send is bounded: lists within lists to a depth, and how many words and lists there are in all.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace murosimf {

struct SExpression {
  std::string_view word;           ///< within the text that was read; empty: a list
  std::vector<SExpression> items;  ///< of a list

  bool isList() const { return word.data() == nullptr; }
  /// The first word of a list; empty: it has none.
  std::string_view name() const;
  /// The first list within this one with that name; null: there is none.
  const SExpression* find(std::string_view list) const;
  /// The number that stands at this place of a list; nothing where there is none, or no finite one.
  std::optional<double> number(std::size_t place) const;
  /// The word that stands there; empty: none.
  std::string_view text(std::size_t place) const;
};

struct SExpressionLimits {
  int depth = 16;             ///< of lists within lists
  std::size_t count = 10000;  ///< of words and lists
};

/// All expressions of a message. The words point into it.
/// @param problem  gets what is wrong where nothing is returned: "byte 12: a ) too many"
std::optional<std::vector<SExpression>> readSExpressions(std::string_view text, std::string& problem,
                                                         const SExpressionLimits& limits = {});

}  // namespace murosimf
