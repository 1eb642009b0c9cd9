#include "murosimf/robot/urdf_reader.h"

#include <fmt/format.h>
#include <tinyxml2.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "murosimf/robot/checks.h"
#include "murosimf/robot/urdf_parts.h"

namespace murosimf {
namespace {

constexpr std::uintmax_t kLargestFile = 8U << 20U;

std::string xmlFault(const tinyxml2::XMLDocument& document) {
  switch (document.ErrorID()) {
    case tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED:
      return "elements are nested too deeply, expected at most 100 levels";
    case tinyxml2::XML_ERROR_MISMATCHED_ELEMENT:
      return "not XML: a closing tag does not fit the tag that is open";
    case tinyxml2::XML_ERROR_PARSING_ATTRIBUTE:
      return "not XML: an attribute of the element that begins here has no value in quotes, or is given twice";
    case tinyxml2::XML_ERROR_EMPTY_DOCUMENT:
      return "file is empty, expected <robot>";
    default: {
      std::string name = tinyxml2::XMLDocument::ErrorIDToName(document.ErrorID());
      name = name.starts_with("XML_ERROR_PARSING_") ? name.substr(18)
                                                    : name.substr(name.starts_with("XML_ERROR_") ? 10 : 0);
      std::transform(name.begin(), name.end(), name.begin(), [](char c) {
        return c == '_' ? ' ' : c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
      });
      return "not XML: fault in the " + name + " that begins here";
    }
  }
}

/// Elements of other programs that may stand in a robot: they say nothing about its body.
const std::vector<std::string> kForeign{"gazebo", "transmission", "ros2_control", "mujoco", "drake"};

void readRobot(const XmlElement& root, urdf::RobotPart& robot) {
  std::vector<std::string> known{"link", "joint", "material", "murosimf"};
  known.insert(known.end(), kForeign.begin(), kForeign.end());
  root.accept({"name", "version"}, known);
  for (const std::string& foreign : kForeign) {
    for (const XmlElement& element : root.children(foreign.c_str()))
      element.warning("belongs to another program: ignored");
  }
  robot.name = urdf::readName(root);
  robot.where = root.where();
  if (const std::optional<XmlElement> extension = root.child("murosimf")) urdf::readRobotExtension(*extension, robot);
  urdf::readMaterials(root, robot);
  for (const XmlElement& link : root.children("link")) urdf::readLink(link, robot);
  for (const XmlElement& joint : root.children("joint")) urdf::readJoint(joint, robot);
}

/// Places in the text that tinyxml2 would stop at or pass over without a word.
bool isText(const std::string& text, const std::string& file, Diagnostics& diagnostics) {
  const std::size_t zero = text.find('\0');
  if (zero == std::string::npos) return true;
  const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(zero), '\n');
  diagnostics.error({file, static_cast<int>(line), 0}, "not a text file: it holds a zero byte, expected XML");
  return false;
}

}  // namespace

ReadResult readUrdfText(const std::string& text, const std::string& file, Diagnostics& diagnostics) {
  if (!isText(text, file, diagnostics)) return std::nullopt;
  tinyxml2::XMLDocument document;
  if (document.Parse(text.data(), text.size()) != tinyxml2::XML_SUCCESS) {
    diagnostics.error({file, document.ErrorLineNum(), 0}, xmlFault(document));
    return std::nullopt;
  }
  const tinyxml2::XMLElement* element = document.RootElement();
  if (element == nullptr) {
    diagnostics.error({file, 1, 0}, "file holds no element, expected <robot>");
    return std::nullopt;
  }
  if (std::string_view(element->Name()) != "robot") {
    diagnostics.error({file, element->GetLineNum(), 0},
                      "found the element " + quoted(element->Name()) + ", expected <robot>");
    return std::nullopt;
  }
  const int before = diagnostics.errorCount();
  if (const tinyxml2::XMLElement* second = element->NextSiblingElement()) {
    diagnostics.error({file, second->GetLineNum(), 0},
                      "a second element follows <robot>, expected the end of the file");
  }
  urdf::RobotPart robot;
  readRobot(XmlElement(*element, file, diagnostics), robot);
  std::optional<RobotModel> model = urdf::assembleRobot(robot, diagnostics, diagnostics.errorCount() == before);
  return diagnostics.errorCount() == before ? std::move(model) : std::nullopt;
}

ReadResult readUrdf(const std::string& path, Diagnostics& diagnostics) {
  std::error_code fault;
  const std::filesystem::file_status status = std::filesystem::status(path, fault);
  const auto fail = [&](const std::string& what) {
    diagnostics.error({path, 0, 0}, what);
    return std::nullopt;
  };
  if (!std::filesystem::exists(status)) return fail("file does not exist, expected a robot (URDF)");
  if (!std::filesystem::is_regular_file(status)) return fail("not a file, expected a robot (URDF)");
  const std::uintmax_t size = std::filesystem::file_size(path, fault);
  if (fault || size > kLargestFile)
    return fail(fmt::format("file has {} bytes, expected at most {}", size, kLargestFile));
  std::ifstream stream(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (!stream) return fail("file cannot be read");
  return readUrdfText(text, path, diagnostics);
}

}  // namespace murosimf
