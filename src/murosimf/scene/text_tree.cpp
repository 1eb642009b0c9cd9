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
      return fmt::format("{}", std::get<std::int64_t>(node.scalar));
    case TextNode::Kind::kNumber:
      return fmt::format("{}", std::get<double>(node.scalar));
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

/// What stands at a place and after it in the same line. Columns count characters, not bytes.
std::string_view restOfLine(std::string_view text, const SourceLocation& where) {
  for (int line = 1; line < where.line; ++line) {
    const std::size_t end = text.find('\n');
    if (end == text.npos) return {};
    text.remove_prefix(end + 1);
  }
  text = text.substr(0, text.find('\n'));
  const auto continues = [](char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; };
  for (int column = 1; column < where.column && !text.empty(); ++column) {
    text.remove_prefix(1);
    while (!text.empty() && continues(text.front())) text.remove_prefix(1);
  }
  return text;
}

/// Bytes of the UTF-8 character at the start of a text, 0 when there is none. [RFC 3629, section 4]
std::size_t characterLength(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
  const unsigned first = byte(0), second = byte(1);
  if (first < 0x80) return 1;
  if (first < 0xc2 || first > 0xf4) return 0;
  const std::size_t length = first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xc0) != 0x80) return 0;
  const bool overlong = (first == 0xe0 && second < 0xa0) || (first == 0xf0 && second < 0x90);
  const bool outside = (first == 0xed && second > 0x9f) || (first == 0xf4 && second > 0x8f);
  return overlong || outside ? 0 : length;
}

/// Reports the first byte that no text has. The parser would report the last good character before it.
bool isText(std::string_view text, const std::string& file, Diagnostics& diagnostics) {
  SourceLocation where{file, 1, 1};
  for (std::size_t length = 0; !text.empty(); text.remove_prefix(length)) {
    length = characterLength(text);
    if (length == 0) {
      diagnostics.error(where, fmt::format("byte 0x{:02x} is not UTF-8, expected a text file (TOML)",
                                           static_cast<unsigned char>(text.front())));
      return false;
    }
    const bool new_line = text.front() == '\n';
    where.line += new_line ? 1 : 0;
    where.column = new_line ? 1 : where.column + 1;
  }
  return true;
}

}  // namespace

std::optional<TextNode> parseToml(std::string_view text, const std::string& file, Diagnostics& diagnostics) {
  if (!isText(text, file, diagnostics)) return std::nullopt;
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
    const std::string_view rest = restOfLine(text, where);
    const std::string found = rest.empty() ? "the end of the line" : fmt::format("\"{}\"", printable(rest));
    diagnostics.error(where, fmt::format("{}, at {}", words, found));
    return std::nullopt;
  }
}

}  // namespace murosimf
