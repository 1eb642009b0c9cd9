#include "murosimf/scene/table_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace murosimf {

namespace {

/// What the check of a value needs to know of its key; the table names every key that the reader asks for.
const ScenarioKey& keyOf(std::string_view section, std::string_view key) {
  static constexpr ScenarioKey kMissing{"", "", ScenarioKey::Kind::kTable, "", 0, 0, false, "", "", ""};
  const ScenarioKey* found = findScenarioKey(section, key);
  return found == nullptr ? kMissing : *found;
}

bool isInside(double value, const ScenarioKey& key) {
  if (!(key.upper > key.lower)) return true;
  return value <= key.upper && (key.above_lower ? value > key.lower : value >= key.lower);
}

std::string withUnit(const TextNode& node, const ScenarioKey& key) {
  return key.unit.empty() || key.unit == "1" ? describe(node) : fmt::format("{} {}", describe(node), key.unit);
}

}  // namespace

TableReader::TableReader(const TextNode* table, std::string_view section, Diagnostics& diagnostics,
                         std::string_view name)
    : table_(table), section_(section), name_(name), diagnostics_(diagnostics) {
  if (table == nullptr) return;
  if (name_.empty()) name_ = printable(table->key);
  if (table->isTable()) return;
  diagnostics_.error(table->where, fmt::format("{} is {}, expected a table", name_, describe(*table)));
  table_ = nullptr;
}

bool TableReader::fail(const TextNode& node, const ScenarioKey& key) const {
  std::string hint;
  if (key.kind == ScenarioKey::Kind::kWord && node.kind == TextNode::Kind::kText)
    hint = didYouMean(std::get<std::string>(node.scalar), allowedWords(key));
  diagnostics_.error(node.where,
                     fmt::format("{} is {}, expected {}{}", key.key, withUnit(node, key), expectation(key), hint));
  return false;
}

bool TableReader::read(std::string_view key, Located<double>& target) const {
  const TextNode* node = child(key);
  if (node == nullptr) return false;
  const ScenarioKey& known = keyOf(section_, key);
  const std::optional<double> value = readNumber(*node, key, expectation(known), known.unit == "rad", diagnostics_);
  if (!value) return false;
  if (!isInside(*value, known)) return fail(*node, known);
  target = {*value, node->where};
  return true;
}

bool TableReader::read(std::string_view key, Located<std::uint64_t>& target) const {
  const TextNode* node = child(key);
  if (node == nullptr) return false;
  const ScenarioKey& known = keyOf(section_, key);
  if (node->kind != TextNode::Kind::kInteger) return fail(*node, known);
  const std::int64_t value = std::get<std::int64_t>(node->scalar);
  if (value < 0 || !isInside(static_cast<double>(value), known)) return fail(*node, known);
  target = {static_cast<std::uint64_t>(value), node->where};
  return true;
}

bool TableReader::read(std::string_view key, Located<int>& target) const {
  Located<std::uint64_t> wide;
  if (!read(key, wide)) return false;
  target = {static_cast<int>(wide.value), wide.where};
  return true;
}

bool TableReader::read(std::string_view key, Located<bool>& target) const {
  const TextNode* node = child(key);
  if (node == nullptr) return false;
  if (node->kind != TextNode::Kind::kBool) return fail(*node, keyOf(section_, key));
  target = {std::get<bool>(node->scalar), node->where};
  return true;
}

bool TableReader::read(std::string_view key, Located<std::string>& target) const {
  const TextNode* node = child(key);
  if (node == nullptr) return false;
  const ScenarioKey& known = keyOf(section_, key);
  const std::optional<std::string> text = readText(*node);
  if (!text) return fail(*node, known);
  if (known.kind == ScenarioKey::Kind::kWord) {
    const std::vector<std::string> words = allowedWords(known);
    if (std::find(words.begin(), words.end(), *text) == words.end()) return fail(*node, known);
  }
  target = {*text, node->where};
  return true;
}

bool TableReader::read(std::string_view key, Located<Colour>& target) const {
  const TextNode* node = child(key);
  if (node == nullptr) return false;
  const ScenarioKey& known = keyOf(section_, key);
  if (node->kind != TextNode::Kind::kArray || node->children.size() != 3) return fail(*node, known);
  std::array<float, 3> channels{};
  for (std::size_t i = 0; i < 3; ++i) {
    const TextNode& part = node->children[i];
    const auto value = readNumber(part, fmt::format("a value of {}", key), "a number from 0 to 1", false, diagnostics_);
    if (!value) return false;
    if (!(*value >= 0 && *value <= 1)) return fail(part, known);
    channels[i] = static_cast<float>(*value);
  }
  target = {{channels[0], channels[1], channels[2]}, node->where};
  return true;
}

namespace {

constexpr double kFarthest = 100;  ///< anything farther from the centre of a field is a slip of the pen [m]

std::optional<double> readCoordinate(const TextNode& node, std::string_view name, Diagnostics& diagnostics) {
  const std::optional<double> value = readNumber(node, name, "a number in m", false, diagnostics);
  if (!value || (*value >= -kFarthest && *value <= kFarthest)) return value;
  diagnostics.error(node.where, fmt::format("{} is {} m, expected at least -{} and at most {} m", name, *value,
                                            kFarthest, kFarthest));
  return std::nullopt;
}

/// The three parts of `[x, y, heading]` or `{x, y, heading}`; heading may be absent in a table.
struct PoseParts {
  const TextNode* x = nullptr;
  const TextNode* y = nullptr;
  const TextNode* heading = nullptr;
};

PoseParts partsOf(const TextNode& node) {
  if (node.isTable()) return {node.find("x"), node.find("y"), node.find("heading")};
  if (node.kind != TextNode::Kind::kArray || node.children.size() != 3) return {};
  return {&node.children[0], &node.children[1], &node.children[2]};
}

}  // namespace

bool TableReader::read(std::string_view key, Located<PlanarPose>& target) const {
  const TextNode* node = child(key);
  if (node == nullptr) return false;
  if (node->isTable()) TableReader(node, "POSE", diagnostics_).refuseUnknownKeys();
  const PoseParts parts = partsOf(*node);
  if (parts.x == nullptr || parts.y == nullptr) return fail(*node, keyOf(section_, key));
  const std::optional<double> x = readCoordinate(*parts.x, "x", diagnostics_);
  const std::optional<double> y = readCoordinate(*parts.y, "y", diagnostics_);
  const std::optional<double> heading =
      parts.heading == nullptr ? 0 : readNumber(*parts.heading, "heading", "a number", true, diagnostics_);
  if (!x || !y || !heading) return false;
  target = {{*x, *y, *heading}, node->where};
  return true;
}

bool TableReader::read(std::string_view key, Located<Vec3<double>>& target) const {
  const TextNode* node = child(key);
  if (node == nullptr) return false;
  const std::size_t size = node->children.size();
  if (node->kind != TextNode::Kind::kArray || size < 2 || size > 3) return fail(*node, keyOf(section_, key));
  Vec3<double> position;
  for (std::size_t i = 0; i < size; ++i) {
    const auto value = readCoordinate(node->children[i], std::string(1, "xyz"[i]), diagnostics_);
    if (!value) return false;
    position[static_cast<int>(i)] = *value;
  }
  target = {position, node->where};
  return true;
}

namespace {

/// One name, or an array of them that is not empty.
std::optional<std::vector<std::string>> namesOf(const TextNode& node) {
  if (node.kind == TextNode::Kind::kText) return std::vector{std::get<std::string>(node.scalar)};
  if (node.kind != TextNode::Kind::kArray || node.children.empty()) return std::nullopt;
  std::vector<std::string> names;
  for (const TextNode& child : node.children) {
    if (child.kind != TextNode::Kind::kText) return std::nullopt;
    names.push_back(std::get<std::string>(child.scalar));
  }
  return names;
}

}  // namespace

bool TableReader::read(std::string_view key, Located<std::vector<std::string>>& target) const {
  const TextNode* node = child(key);
  if (node == nullptr) return false;
  const std::optional<std::vector<std::string>> names = namesOf(*node);
  if (!names) return fail(*node, keyOf(section_, key));
  target = {*names, node->where};
  return true;
}

bool TableReader::read(std::string_view key, Located<std::vector<std::string>>& first,
                       Located<std::vector<std::string>>& second) const {
  const TextNode* node = child(key);
  if (node == nullptr) return false;
  const bool two = node->kind == TextNode::Kind::kArray && node->children.size() == 2;
  const auto a = two ? namesOf(node->children[0]) : std::nullopt;
  const auto b = two ? namesOf(node->children[1]) : std::nullopt;
  if (!a || !b) return fail(*node, keyOf(section_, key));
  first = {*a, node->where};
  second = {*b, node->where};
  return true;
}

void TableReader::refuseUnknownKeys(const std::vector<std::string>& more) const {
  constexpr std::size_t kFewKeys = 12;
  if (table_ == nullptr) return;
  std::vector<std::string> known = keysOfSection(section_);
  known.insert(known.end(), more.begin(), more.end());
  for (const TextNode& c : table_->children) {
    if (std::find(known.begin(), known.end(), c.key) != known.end()) continue;
    const std::string hint = didYouMean(c.key, known);
    const std::string in = name_.empty() ? "" : " in " + name_;
    const bool tell_all = hint.empty() || known.size() <= kFewKeys;
    const std::string expected = tell_all ? listWords(known) : fmt::format("one of its {} keys", known.size());
    diagnostics_.error(c.key_where,
                       fmt::format("unknown key \"{}\"{}, expected {}{}", printable(c.key), in, expected, hint));
  }
}

}  // namespace murosimf
