#pragma once

/// @file An element of an XML file, read with complaints: every wrong attribute or child becomes an error with its
/// line, and reading goes on with a harmless value, so that one run finds all mistakes.
///
/// Whether values are good enough for further checks is seen from Diagnostics::errorCount() before and after.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/math/transform.h"
#include "murosimf/world/diagnostics.h"

namespace tinyxml2 {
class XMLElement;
}

namespace murosimf {

/// A light view: the document and the diagnostics must outlive it.
class XmlElement {
 public:
  XmlElement(const tinyxml2::XMLElement& element, const std::string& file, Diagnostics& diagnostics)
      : element_(&element), file_(&file), diagnostics_(&diagnostics) {}

  std::string name() const;
  SourceLocation where() const;
  /// Line of the attribute; of the element where it has no such attribute.
  SourceLocation where(const char* attribute) const;
  Diagnostics& diagnostics() const { return *diagnostics_; }

  /// Reports attributes and child elements that are not listed (with the nearest that is), and text between the tags.
  /// Call it once for each element.
  void accept(const std::vector<std::string>& attributes, const std::vector<std::string>& children = {}) const;

  bool has(const char* attribute) const;
  /// Attributes. Without a fallback they must be there. Text must not be empty.
  std::string text(const char* attribute) const;
  std::string text(const char* attribute, const std::string& fallback) const;
  double number(const char* attribute) const;
  double number(const char* attribute, double fallback) const;
  Vector3 vector(const char* attribute) const;
  Vector3 vector(const char* attribute, const Vector3& fallback) const;
  /// As many numbers as there are; with count > 0 exactly that many (zeros after an error).
  std::vector<double> numbers(const char* attribute, std::size_t count = 0) const;
  int integer(const char* attribute, int least, int largest) const;
  bool truth(const char* attribute, bool fallback) const;
  /// Pose of the attributes xyz [m] and rpy [rad] (fixed axes x, y, z: R = Rz Ry Rx); each defaults to zero.
  Pose pose() const;

  std::vector<XmlElement> children(const char* name) const;
  /// All of them, in the order of the file.
  std::vector<XmlElement> children() const;
  /// The one child of that name; a second one is an error.
  std::optional<XmlElement> child(const char* name) const;
  std::optional<XmlElement> requiredChild(const char* name) const;

  /// `<name>: message` at the element's line.
  void error(const std::string& message) const;
  void warning(const std::string& message) const;
  /// `<name>: attribute "x" message` at the attribute's line.
  void errorAt(const char* attribute, const std::string& message) const;
  /// Reports a problem when the text is not empty.
  void check(const std::string& problem) const;

 private:
  void acceptAttributes(const std::vector<std::string>& known) const;
  const tinyxml2::XMLElement* element_;
  const std::string* file_;
  Diagnostics* diagnostics_;
};

/// Words between white space.
std::vector<std::string> splitWords(std::string_view text);

/// A finite decimal number of at most 1e9, the whole word, whatever the locale; nothing otherwise.
std::optional<double> parseNumber(std::string_view word);

}  // namespace murosimf
