#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "experiment/plan_reader.h"

namespace murosimf {

namespace {

/// As tables show it: texts without quotes.
std::string labelOf(const TextNode& value) {
  return value.kind == TextNode::Kind::kText ? std::get<std::string>(value.scalar) : valueText(value);
}

std::string joined(const std::string& path, const std::string& key) { return path.empty() ? key : path + "." + key; }

/// The parser sorts keys by letters; people mean the order in which they wrote them.
template <class T>
void inWrittenOrder(std::vector<T>& list) {
  std::stable_sort(list.begin(), list.end(), [](const T& a, const T& b) {
    return std::tie(a.where.line, a.where.column) < std::tie(b.where.line, b.where.column);
  });
}

}  // namespace

/// Seeds have a key of their own.
bool PlanReader::isOurs(const std::string& path, const TextNode& node) {
  if (path != "simulation.seed") return true;
  problems_.error(node.key_where, "simulation.seed stands here, expected the key seeds of the plan");
  return false;
}

void PlanReader::addChanges(const TextNode& table, const std::string& path, Changes& changes) {
  for (const TextNode& child : table.children) {
    const std::string own = joined(path, child.key);
    if (child.isTable() && !child.children.empty()) {
      addChanges(child, own, changes);
    } else if (isOurs(own, child)) {
      changes.push_back({fmt::format("{}={}", own, valueText(child)), child.where});
    }
  }
}

PlanReader::Changes PlanReader::readChanges(const TextNode* table, const std::string& name) {
  Changes changes;
  if (table == nullptr) return changes;
  if (!table->isTable())
    fail(*table, name, "a table of PATH = VALUE");
  else
    addChanges(*table, "", changes);
  inWrittenOrder(changes);
  return changes;
}

PlanReader::Axis PlanReader::readValues(const TextNode& list, const std::string& path) {
  Axis axis{path, list.where, {}};
  std::set<std::string> known;
  for (const TextNode& value : list.children) {
    const std::string text = valueText(value);
    if (!known.insert(text).second)
      problems_.error(value.where, fmt::format("{} has the value {} twice", path, printable(text)));
    axis.values.push_back({{labelOf(value)}, {{fmt::format("{}={}", path, text), value.where}}});
  }
  return axis;
}

void PlanReader::addParameters(const TextNode& table, const std::string& path, std::vector<Axis>& axes) {
  for (const TextNode& child : table.children) {
    const std::string own = joined(path, child.key);
    if (child.isTable() && !child.children.empty()) {
      addParameters(child, own, axes);
    } else if (child.kind != TextNode::Kind::kArray || child.children.empty()) {
      fail(child, own, "a list of values");
    } else if (isOurs(own, child)) {
      axes.push_back(readValues(child, own));
    }
  }
}

PlanReader::Axis PlanReader::readCases(const TextNode& list) {
  Axis axis{"case", list.where, {}};
  if (list.kind != TextNode::Kind::kArray || list.children.empty()) {
    fail(list, "cases", "tables [[cases]]");
    return axis;
  }
  std::set<std::string> known;
  for (const TextNode& one : list.children) {
    if (!one.isTable()) {
      fail(one, "a case", "a table [[cases]]");
      continue;
    }
    refuseUnknown(one, "[[cases]]", {"name", "set"});
    const TextNode* name = one.find("name");
    if (name == nullptr) {
      problems_.error(one.where, "name is missing in [[cases]], expected a text");
      continue;
    }
    const std::string label = text(*name, "name");
    if (!label.empty() && !known.insert(label).second)
      problems_.error(name->where, fmt::format("there are two cases \"{}\"", printable(label)));
    axis.values.push_back({{label}, readChanges(one.find("set"), "set")});
  }
  return axis;
}

std::vector<PlanReader::Axis> PlanReader::readAxes() {
  std::vector<Axis> axes;
  if (const TextNode* parameters = plan_.find("parameters")) {
    if (!parameters->isTable())
      fail(*parameters, "parameters", "a table of PATH = [VALUE, ...]");
    else
      addParameters(*parameters, "", axes);
  }
  inWrittenOrder(axes);
  if (const TextNode* cases = plan_.find("cases")) axes.insert(axes.begin(), readCases(*cases));
  return axes;
}

/// Each case with each value of each parameter.
void PlanReader::combine(SweepPlan& plan, const Changes& all) {
  plan.cases = {SweepCase{{}, all}};
  for (const Axis& axis : readAxes()) {
    plan.axes.push_back(axis.name);
    if (static_cast<double>(plan.cases.size()) * static_cast<double>(axis.values.size()) > kMostRuns)
      return problems_.error({file_.string(), 0, 0}, fmt::format("these are more than {} cases", kMostRuns));
    std::vector<SweepCase> longer;
    for (const SweepCase& before : plan.cases) {
      for (const SweepCase& value : axis.values) {
        SweepCase& one = longer.emplace_back(before);
        one.labels.insert(one.labels.end(), value.labels.begin(), value.labels.end());
        one.changes.insert(one.changes.end(), value.changes.begin(), value.changes.end());
      }
    }
    plan.cases = std::move(longer);
  }
}

}  // namespace murosimf
