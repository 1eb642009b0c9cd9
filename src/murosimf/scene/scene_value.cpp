#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "murosimf/scene/table_reader.h"

namespace murosimf {

namespace {

bool isNumber(const TextNode& node) {
  return node.kind == TextNode::Kind::kInteger || node.kind == TextNode::Kind::kNumber;
}

double numberOf(const TextNode& node) {
  if (node.kind == TextNode::Kind::kInteger) return static_cast<double>(std::get<std::int64_t>(node.scalar));
  return std::get<double>(node.scalar);
}

/// The angle of `{deg = 30}` in rad, or nothing after an error.
std::optional<double> readDegrees(const TextNode& node, std::string_view name, Diagnostics& diagnostics) {
  for (const TextNode& child : node.children) {
    if (child.key == "deg") continue;
    diagnostics.error(child.key_where, fmt::format("unknown key \"{}\" in {}, expected a number in rad or {{deg = "
                                                   "...}}{}",
                                                   printable(child.key), name, didYouMean(child.key, {"deg"})));
    return std::nullopt;
  }
  const TextNode* degrees = node.find("deg");
  if (degrees == nullptr) {
    diagnostics.error(node.where, fmt::format("{} is an empty table, expected a number in rad or {{deg = ...}}", name));
    return std::nullopt;
  }
  const std::optional<double> value = readNumber(*degrees, "deg", "a number in degrees", false, diagnostics);
  if (!value) return std::nullopt;
  return *value * (std::numbers::pi / 180);
}

}  // namespace

bool looksLikeAngle(const TextNode& node) {
  if (!node.isTable() || node.children.size() != 1 || node.children[0].isTable()) return false;
  const std::string& key = node.children[0].key;
  return key == "deg" || !didYouMean(key, {"deg"}).empty() || key == "degrees" || key == "degree";
}

std::optional<double> readNumber(const TextNode& node, std::string_view name, const std::string& expected, bool angle,
                                 Diagnostics& diagnostics) {
  if (angle && node.isTable()) return readDegrees(node, name, diagnostics);
  if (isNumber(node) && std::isfinite(numberOf(node))) return numberOf(node);
  diagnostics.error(node.where, fmt::format("{} is {}, expected {}{}", name, describe(node), expected,
                                            angle ? " in rad or {deg = ...}" : ""));
  return std::nullopt;
}

std::optional<std::string> readText(const TextNode& node) {
  if (node.kind == TextNode::Kind::kText) return std::get<std::string>(node.scalar);
  if (!node.raw.empty()) return node.raw;
  return std::nullopt;
}

namespace {

std::optional<SceneValue> readArray(const TextNode& node, std::string_view name, Diagnostics& diagnostics) {
  const auto isText = [](const TextNode& c) { return c.kind == TextNode::Kind::kText; };
  if (!node.children.empty() && std::all_of(node.children.begin(), node.children.end(), isText)) {
    std::vector<std::string> texts;
    for (const TextNode& c : node.children) texts.push_back(std::get<std::string>(c.scalar));
    return texts;
  }
  std::vector<double> numbers;
  for (const TextNode& c : node.children) {
    const std::optional<double> number =
        readNumber(c, fmt::format("a value of {}", name), "all numbers or all texts", c.isTable(), diagnostics);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

std::optional<SceneValue> readAny(const TextNode& node, std::string_view name, Diagnostics& diagnostics) {
  switch (node.kind) {
    case TextNode::Kind::kBool:
      return std::get<bool>(node.scalar);
    case TextNode::Kind::kText:
      return std::get<std::string>(node.scalar);
    case TextNode::Kind::kArray:
      return readArray(node, name, diagnostics);
    default:
      break;
  }
  if (const auto number = readNumber(node, name, "true, false, a text, an array, a number", true, diagnostics))
    return *number;
  return std::nullopt;
}

}  // namespace

std::optional<Located<SceneValue>> readSceneValue(const TextNode& node, std::string_view name,
                                                  Diagnostics& diagnostics) {
  std::optional<SceneValue> value = readAny(node, name, diagnostics);
  if (!value) return std::nullopt;
  return Located<SceneValue>{std::move(*value), node.where};
}

}  // namespace murosimf
