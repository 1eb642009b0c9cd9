#include "murosimf/scene/override.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <utility>

#include "murosimf/scene/robot_layers.h"

namespace murosimf {

namespace {

std::string_view trimmed(std::string_view text) {
  const auto space = [](char c) { return c == ' ' || c == '\t'; };
  while (!text.empty() && space(text.front())) text.remove_prefix(1);
  while (!text.empty() && space(text.back())) text.remove_suffix(1);
  return text;
}

/// The first `=` outside quotes.
std::size_t findEquals(std::string_view text) {
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '"') quoted = !quoted;
    if (text[i] == '=' && !quoted) return i;
  }
  return std::string_view::npos;
}

/// Parts between the dots; empty when one of them is empty or a quote is left open.
std::vector<std::string> splitPath(std::string_view path) {
  std::vector<std::string> parts(1);
  bool quoted = false;
  for (const char c : path) {
    if (c == '"') {
      quoted = !quoted;
    } else if (c == '.' && !quoted) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  const bool has_empty = std::any_of(parts.begin(), parts.end(), [](const std::string& p) { return p.empty(); });
  if (quoted || has_empty) parts.clear();
  return parts;
}

bool isBareWord(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
           std::string_view("_-+./ :@,").find(c) != std::string_view::npos;
  });
}

void placeAt(TextNode& node, const SourceLocation& where) {
  node.where = node.key_where = where;
  for (TextNode& child : node.children) placeAt(child, where);
}

std::optional<TextNode> parseValue(std::string_view text, const SourceLocation& where, Diagnostics& diagnostics) {
  Diagnostics of_value;
  std::optional<TextNode> node;
  const bool one_line = text.find_first_of("\n\r") == text.npos;
  if (one_line)
    if (std::optional<TextNode> table = parseToml(fmt::format("value = {}", text), where.file, of_value))
      if (table->children.size() == 1) node = table->take("value");
  if (!node && isBareWord(text)) {
    node.emplace();
    node->kind = TextNode::Kind::kText;
    node->scalar = std::string(text);
  }
  if (!node) {
    const std::string why = of_value.all().empty() ? "" : " (" + of_value.all().front().message + ")";
    diagnostics.error(where, fmt::format("the value is {}, expected a TOML value or a bare word{}",
                                         text.empty() ? "missing" : "\"" + printable(text) + "\"", why));
    return std::nullopt;
  }
  placeAt(*node, where);
  if (!node->isTable() && node->kind != TextNode::Kind::kArray) node->raw = std::string(text);
  return node;
}

/// The table at the path's next part; a value that stands there gives way.
TextNode& descend(TextNode& table, const std::string& part, const SourceLocation& where) {
  TextNode* child = table.find(part);
  if (child == nullptr) {
    child = &table.children.emplace_back();
    child->key = part;
    child->where = child->key_where = where;
  }
  return *child;
}

}  // namespace

bool applyOverride(TextNode& changes, std::string_view assignment, Diagnostics& diagnostics) {
  const SourceLocation where{fmt::format("--set {}", printable(assignment)), 0, 0};
  const std::size_t equals = findEquals(assignment);
  const std::vector<std::string> path = splitPath(trimmed(assignment.substr(0, equals)));
  if (equals == assignment.npos || path.empty() || path.size() > kDeepestNesting) {
    diagnostics.error(where, "expected PATH=VALUE with a PATH such as robots.red.1.motion.period");
    return false;
  }
  std::optional<TextNode> value = parseValue(trimmed(assignment.substr(equals + 1)), where, diagnostics);
  if (!value) return false;
  TextNode* at = &changes;
  for (const std::string& part : path) {
    if (!at->isTable()) {
      // `motion=walk` and then `motion.period=.02`: the name of the module stays.
      TextNode name = std::exchange(*at, TextNode{});
      at->key = name.key;
      at->where = at->key_where = where;
      name.key = nameKeyOf(at->key);
      at->children.push_back(std::move(name));
    }
    at = &descend(*at, part, where);
  }
  value->key = at->key;
  *at = std::move(*value);
  return true;
}

}  // namespace murosimf
