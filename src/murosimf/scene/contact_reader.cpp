#include "murosimf/scene/contact_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "murosimf/scene/field_reader.h"
#include "murosimf/scene/table_reader.h"

namespace murosimf {

namespace {

constexpr std::string_view kSection = "contacts.NAME";

/// Line of the file, beyond all lines where the rule is new.
std::pair<int, int> placeOf(const TextNode& rule, const TextNode* in_file) {
  const TextNode* original = in_file == nullptr ? nullptr : in_file->find(rule.key);
  if (original == nullptr) return {std::numeric_limits<int>::max(), 0};
  return {original->key_where.line, original->key_where.column};
}

bool saysAnything(const TextNode& node) {
  return std::any_of(node.children.begin(), node.children.end(),
                     [](const TextNode& c) { return c.key != "between" && c.key != "within" && c.key != "self"; });
}

void readRule(const TextNode& node, ContactRuleSettings& rule, Diagnostics& diagnostics) {
  const std::string name = "contacts." + printable(node.key);
  const TableReader reader(&node, kSection, diagnostics, name);
  reader.refuseUnknownKeys(keysOfSection("surfaces.A-B"));
  rule.name = node.key;
  rule.where = node.key_where;
  if (!node.isTable()) return;
  reader.read("between", rule.between, rule.with);
  reader.read("within", rule.within);
  reader.read("self", rule.self);
  reader.read("check", rule.check);
  reader.read("points", rule.points);
  readSurfacePair(TableReader(&node, "surfaces.A-B", diagnostics, name), rule.surface, diagnostics);
  const auto said = [&](const char* key) { return node.find(key) != nullptr ? 1 : 0; };
  const int selectors = said("between") + said("within") + said("self");
  if (selectors != 1) {
    diagnostics.error(node.key_where, fmt::format("{} has {} of between, within and self, expected one of them", name,
                                                  selectors == 0 ? "none" : "more than one"));
  }
  if (!saysAnything(node)) {
    diagnostics.error(node.key_where, fmt::format("{} says nothing of its pairs, expected check, points or a key of "
                                                  "[surfaces.A-B]",
                                                  name));
  }
}

}  // namespace

std::vector<ContactRuleSettings> readContacts(const TextNode* table, const TextNode* in_file,
                                              Diagnostics& diagnostics) {
  std::vector<ContactRuleSettings> rules;
  if (table == nullptr) return rules;
  if (!table->isTable()) {
    diagnostics.error(table->where, fmt::format("contacts is {}, expected a table", describe(*table)));
    return rules;
  }
  std::vector<const TextNode*> nodes;
  for (const TextNode& node : table->children) nodes.push_back(&node);
  std::stable_sort(nodes.begin(), nodes.end(),
                   [&](const TextNode* a, const TextNode* b) { return placeOf(*a, in_file) < placeOf(*b, in_file); });
  for (const TextNode* node : nodes) readRule(*node, rules.emplace_back(), diagnostics);
  return rules;
}

}  // namespace murosimf
