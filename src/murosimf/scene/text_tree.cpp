#include "murosimf/scene/text_tree.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <utility>

namespace murosimf {

const TextNode* TextNode::find(std::string_view child_key) const {
  const auto at = std::find_if(children.begin(), children.end(), [&](const TextNode& c) { return c.key == child_key; });
  return isTable() && at != children.end() ? &*at : nullptr;
}

TextNode* TextNode::find(std::string_view child_key) {
  return const_cast<TextNode*>(std::as_const(*this).find(child_key));
}

std::optional<TextNode> TextNode::take(std::string_view child_key) {
  TextNode* child = find(child_key);
  if (child == nullptr) return std::nullopt;
  std::optional<TextNode> taken = std::move(*child);
  children.erase(children.begin() + (child - children.data()));
  return taken;
}

std::string printable(std::string_view text) {
  constexpr std::size_t kLongest = 60;
  std::string out;
  for (const char c : text.substr(0, kLongest)) {
    const auto byte = static_cast<unsigned char>(c);
    out += byte < 0x20 || byte == 0x7f ? fmt::format("\\x{:02x}", byte) : std::string(1, c);
  }
  // A cut inside a UTF-8 sequence would leave its first bytes alone.
  if (text.size() > kLongest) {
    while (!out.empty() && (static_cast<unsigned char>(out.back()) & 0xc0) == 0x80) out.pop_back();
    if (!out.empty() && static_cast<unsigned char>(out.back()) >= 0xc0) out.pop_back();
    out += "...";
  }
  return out;
}

std::string describe(const TextNode& node) {
  switch (node.kind) {
    case TextNode::Kind::kTable:
      return "a table";
    case TextNode::Kind::kArray:
      return fmt::format("an array of {} value{}", node.children.size(), node.children.size() == 1 ? "" : "s");
    case TextNode::Kind::kBool:
      return std::get<bool>(node.scalar) ? "true" : "false";
    case TextNode::Kind::kInteger:
      return fmt::format("number {}", std::get<std::int64_t>(node.scalar));
    case TextNode::Kind::kNumber:
      return fmt::format("number {}", std::get<double>(node.scalar));
    case TextNode::Kind::kText:
      return fmt::format("text \"{}\"", printable(std::get<std::string>(node.scalar)));
    case TextNode::Kind::kDate:
      return "a date or time";
  }
  return "nothing";
}

void layOver(TextNode& lower, const TextNode& upper) {
  if (!lower.isTable() || !upper.isTable()) {
    lower = upper;
    return;
  }
  lower.where = upper.where;
  lower.key_where = upper.key_where;
  for (const TextNode& child : upper.children) {
    if (TextNode* below = lower.find(child.key))
      layOver(*below, child);
    else
      lower.children.push_back(child);
  }
}

namespace {

/// Copies the parser's tree into ours.
class TreeCopier {
 public:
  TreeCopier(const std::string& file, Diagnostics& diagnostics) : file_(file), diagnostics_(diagnostics) {}

  TextNode copy(const toml::node& node, int depth) {
    TextNode out;
    out.where = place(node.source());
    if (depth > kDeepestNesting) {
      if (!too_deep_) diagnostics_.error(out.where, fmt::format("nested deeper than {} levels", kDeepestNesting));
      too_deep_ = true;
    } else if (const toml::table* table = node.as_table()) {
      copyTable(*table, out, depth);
    } else if (const toml::array* array = node.as_array()) {
      out.kind = TextNode::Kind::kArray;
      for (const toml::node& child : *array) out.children.push_back(copy(child, depth + 1));
    } else {
      copyScalar(node, out);
    }
    return out;
  }

 private:
  SourceLocation place(const toml::source_region& region) const {
    return {file_, static_cast<int>(region.begin.line), static_cast<int>(region.begin.column)};
  }
  void copyTable(const toml::table& table, TextNode& out, int depth) {
    for (const auto& [key, child] : table) {
      out.children.push_back(copy(child, depth + 1));
      out.children.back().key = std::string(key.str());
      out.children.back().key_where = place(key.source());
    }
  }
  static void copyScalar(const toml::node& node, TextNode& out) {
    if (const auto* b = node.as_boolean()) {
      out.kind = TextNode::Kind::kBool, out.scalar = b->get();
    } else if (const auto* i = node.as_integer()) {
      out.kind = TextNode::Kind::kInteger, out.scalar = i->get();
    } else if (const auto* d = node.as_floating_point()) {
      out.kind = TextNode::Kind::kNumber, out.scalar = d->get();
    } else if (const auto* s = node.as_string()) {
      out.kind = TextNode::Kind::kText, out.scalar = s->get();
    } else {
      out.kind = TextNode::Kind::kDate;
    }
  }

  const std::string& file_;
  Diagnostics& diagnostics_;
  bool too_deep_ = false;
};

}  // namespace

std::optional<TextNode> parseToml(std::string_view text, const std::string& file, Diagnostics& diagnostics) {
  const int errors_before = diagnostics.errorCount();
  try {
    const toml::table table = toml::parse(text, file);
    TextNode root = TreeCopier(file, diagnostics).copy(table, 0);
    if (diagnostics.errorCount() > errors_before) return std::nullopt;
    return root;
  } catch (const toml::parse_error& error) {
    const toml::source_position& at = error.source().begin;
    const SourceLocation where{file, static_cast<int>(at.line), static_cast<int>(at.column)};
    std::string words = fmt::format("this is not TOML: {}", error.description());
    for (char& c : words)
      if (static_cast<unsigned char>(c) < 0x20) c = ' ';
    diagnostics.error(where, words);
    return std::nullopt;
  }
}

}  // namespace murosimf
