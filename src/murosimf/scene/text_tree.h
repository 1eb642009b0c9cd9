#pragma once

/// @file The tree of tables, arrays and values that a TOML text holds, with the place of every key and value.
///
/// Unlike the parser's own tree it can be copied, merged and changed by `--set` without losing those places.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "murosimf/world/diagnostics.h"

namespace murosimf {

struct TextNode {
  enum class Kind { kTable, kArray, kBool, kInteger, kNumber, kText, kDate };

  Kind kind = Kind::kTable;
  std::string key;           ///< in the table above; empty in arrays and at the root
  SourceLocation key_where;  ///< of the key; of the header for `[a.b]`
  SourceLocation where;      ///< of the value
  std::variant<std::monostate, bool, std::int64_t, double, std::string> scalar;
  std::string raw;                 ///< of `--set PATH=VALUE`: VALUE as typed, where it is a scalar
  std::vector<TextNode> children;  ///< of tables (each with its key) and arrays

  bool isTable() const { return kind == Kind::kTable; }
  const TextNode* find(std::string_view child_key) const;
  TextNode* find(std::string_view child_key);
  /// Removes a child from a table and returns it.
  std::optional<TextNode> take(std::string_view child_key);
};

/// Nested deeper than this is an error.
inline constexpr int kDeepestNesting = 64;

/// Reads TOML. A syntax error ends the reading, so only the first one is reported.
std::optional<TextNode> parseToml(std::string_view text, const std::string& file, Diagnostics& diagnostics);

/// Lays `upper` over `lower`: tables are joined key by key, everything else is replaced.
void layOver(TextNode& lower, const TextNode& upper);

/// The value as messages name it: `3.5`, `text "abc"`, `an array of 2 values`, `a table`.
std::string describe(const TextNode& node);

/// A text shortened and with its control characters replaced, fit to stand in a one-line message.
std::string printable(std::string_view text);

}  // namespace murosimf
