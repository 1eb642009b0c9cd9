#include "murosimf/robot/xml_element.h"

#include <fmt/format.h>
#include <tinyxml2.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "murosimf/robot/checks.h"

namespace murosimf {
namespace {

constexpr double kLargestNumber = 1e9;
constexpr const char* kSpace = " \t\r\n";

/// didYouMean on what may be any bytes of a file: only as much of the word as a name can have.
std::string nearest(const std::string& word, const std::vector<std::string>& candidates) {
  return didYouMean(std::string_view(word).substr(0, 100), candidates);
}

/// Why a text that should hold numbers does not, where the usual reasons show.
std::string numberHint(const std::string& text) {
  if (text.find("${") != std::string::npos) return " (xacro expressions are not evaluated: expand the file first)";
  if (text.find("deg") != std::string::npos) return " (angles are in rad)";
  if (text.find(',') != std::string::npos) return " (numbers stand apart by spaces and have a decimal point)";
  for (const std::string& word : splitWords(text)) {
    double x = 0;
    const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), x);
    const bool whole = end == word.data() + word.size();
    if (whole && (fault == std::errc::result_out_of_range || !(std::fabs(x) <= kLargestNumber))) {
      return " (numbers are finite and reach to 1e9)";
    }
  }
  return "";
}

std::string unknownElementHint(const std::string& name, const std::vector<std::string>& known) {
  if (name.starts_with("xacro:")) return " (xacro is not evaluated: expand the file first)";
  return nearest(name, known);
}

}  // namespace

std::string XmlElement::name() const { return element_->Name(); }
SourceLocation XmlElement::where() const { return {*file_, element_->GetLineNum(), 0}; }

SourceLocation XmlElement::where(const char* attribute) const {
  const tinyxml2::XMLAttribute* found = element_->FindAttribute(attribute);
  return found == nullptr ? where() : SourceLocation{*file_, found->GetLineNum(), 0};
}

void XmlElement::acceptAttributes(const std::vector<std::string>& known) const {
  for (const auto* a = element_->FirstAttribute(); a != nullptr; a = a->Next()) {
    const std::string attribute = a->Name();
    if (attribute.starts_with("xmlns") || std::find(known.begin(), known.end(), attribute) != known.end()) continue;
    diagnostics_->error({*file_, a->GetLineNum(), 0},
                        "<" + name() + ">: unknown attribute " + quoted(attribute) + nearest(attribute, known));
  }
}

void XmlElement::accept(const std::vector<std::string>& attributes, const std::vector<std::string>& children) const {
  acceptAttributes(attributes);
  for (const auto* node = element_->FirstChild(); node != nullptr; node = node->NextSibling()) {
    const SourceLocation line{*file_, node->GetLineNum(), 0};
    if (node->ToText() != nullptr) {
      diagnostics_->error(line, "<" + name() + ">: unexpected text " + quoted(node->Value()));
    } else if (const auto* child = node->ToElement()) {
      const std::string found = child->Name();
      if (std::find(children.begin(), children.end(), found) != children.end()) continue;
      diagnostics_->error(line, "unknown element <" + quoted(found).substr(1, quoted(found).size() - 2) + "> in <" +
                                    name() + ">" + unknownElementHint(found, children));
    }
  }
}

bool XmlElement::has(const char* attribute) const { return element_->FindAttribute(attribute) != nullptr; }

std::string XmlElement::text(const char* attribute) const {
  const char* value = element_->Attribute(attribute);
  if (value == nullptr) {
    error(std::string("attribute \"") + attribute + "\" is missing");
    return "";
  }
  if (splitWords(value).empty()) errorAt(attribute, "is empty");
  return value;
}

std::string XmlElement::text(const char* attribute, const std::string& fallback) const {
  return has(attribute) ? text(attribute) : fallback;
}

std::vector<double> XmlElement::numbers(const char* attribute, std::size_t count) const {
  const int before = diagnostics_->errorCount();
  const std::string all = text(attribute);
  std::vector<double> out;
  if (diagnostics_->errorCount() == before) {
    const std::vector<std::string> words = splitWords(all);
    for (const std::string& word : words) {
      if (const std::optional<double> x = parseNumber(word)) out.push_back(*x);
    }
    const bool wrong_count = count > 0 && words.size() != count;
    if (out.size() != words.size() || wrong_count) {
      const std::string wanted = count == 0 ? "numbers" : count == 1 ? "a number" : fmt::format("{} numbers", count);
      errorAt(attribute, "is " + quoted(all) + ", expected " + wanted + numberHint(all));
    }
  }
  if (count > 0) out.resize(count, 0.0);
  return out;
}

double XmlElement::number(const char* attribute) const { return numbers(attribute, 1)[0]; }
double XmlElement::number(const char* attribute, double fallback) const {
  return has(attribute) ? number(attribute) : fallback;
}

Vector3 XmlElement::vector(const char* attribute) const {
  const std::vector<double> v = numbers(attribute, 3);
  return {v[0], v[1], v[2]};
}
Vector3 XmlElement::vector(const char* attribute, const Vector3& fallback) const {
  return has(attribute) ? vector(attribute) : fallback;
}

int XmlElement::integer(const char* attribute, int least, int largest) const {
  const int before = diagnostics_->errorCount();
  const double x = number(attribute);
  if (diagnostics_->errorCount() != before) return least;
  if (x == std::floor(x) && x >= least && x <= largest) return static_cast<int>(x);
  errorAt(attribute, fmt::format("is {:g}, expected a whole number from {} to {}", x, least, largest));
  return least;
}

bool XmlElement::truth(const char* attribute, bool fallback) const {
  const std::string word = text(attribute, fallback ? "true" : "false");
  if (word != "true" && word != "false") errorAt(attribute, "is " + quoted(word) + ", expected true or false");
  return word == "true";
}

Pose XmlElement::pose() const {
  constexpr double kLargestAngle = 100;  // beyond it the angle cannot be meant
  const Vector3 p = vector("xyz", Vector3{});
  Vector3 roll_pitch_yaw = vector("rpy", Vector3{});
  for (int i = 0; i < 3; ++i) {
    if (std::fabs(roll_pitch_yaw[i]) <= kLargestAngle) continue;
    errorAt("rpy", fmt::format("has the angle {:g}, expected rad", roll_pitch_yaw[i]));
    roll_pitch_yaw[i] = 0;
  }
  return {fromRollPitchYaw(roll_pitch_yaw), p};
}

std::vector<XmlElement> XmlElement::children(const char* name) const {
  std::vector<XmlElement> out;
  for (const auto* c = element_->FirstChildElement(name); c != nullptr; c = c->NextSiblingElement(name)) {
    out.emplace_back(*c, *file_, *diagnostics_);
  }
  return out;
}

std::vector<XmlElement> XmlElement::children() const {
  std::vector<XmlElement> out;
  for (const auto* c = element_->FirstChildElement(); c != nullptr; c = c->NextSiblingElement()) {
    out.emplace_back(*c, *file_, *diagnostics_);
  }
  return out;
}

std::optional<XmlElement> XmlElement::child(const char* name) const {
  const std::vector<XmlElement> found = children(name);
  if (found.empty()) return std::nullopt;
  for (std::size_t i = 1; i < found.size(); ++i) {
    found[i].error(fmt::format("stands twice in <{}>, first in line {}", this->name(), found[0].where().line));
  }
  return found[0];
}

std::optional<XmlElement> XmlElement::requiredChild(const char* name) const {
  std::optional<XmlElement> found = child(name);
  if (!found) error(std::string("element <") + name + "> is missing");
  return found;
}

void XmlElement::error(const std::string& message) const {
  diagnostics_->error(where(), "<" + name() + ">: " + message);
}
void XmlElement::warning(const std::string& message) const {
  diagnostics_->warning(where(), "<" + name() + ">: " + message);
}
void XmlElement::errorAt(const char* attribute, const std::string& message) const {
  diagnostics_->error(where(attribute), "<" + name() + ">: attribute \"" + attribute + "\" " + message);
}
void XmlElement::check(const std::string& problem) const {
  if (!problem.empty()) error(problem);
}

std::vector<std::string> splitWords(std::string_view text) {
  std::vector<std::string> words;
  for (std::size_t begin = text.find_first_not_of(kSpace); begin != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(kSpace, begin), text.size());
    words.emplace_back(text.substr(begin, end - begin));
    begin = text.find_first_not_of(kSpace, end);
  }
  return words;
}

std::optional<double> parseNumber(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  double x = 0;
  const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), x);
  if (fault != std::errc{} || end != word.data() + word.size() || !(std::fabs(x) <= kLargestNumber))
    return std::nullopt;
  return x;
}

}  // namespace murosimf
