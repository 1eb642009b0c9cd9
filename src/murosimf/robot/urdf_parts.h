#pragma once

/// @file What stands in a URDF file, element by element, before links and joints are put together to a tree.
///
/// Names are references still; they are resolved by assembleRobot(). Readers of single elements report their mistakes
/// and return what could be read.

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "murosimf/algorithms/collision/hull_shape.h"
#include "murosimf/robot/robot_model.h"
#include "murosimf/robot/xml_element.h"

namespace murosimf::urdf {

/// A name that must belong to something else in the file.
struct Reference {
  std::string name{};
  SourceLocation where{};
};

struct CameraPart {
  CameraMount mount{};
  std::vector<Reference> hides{};
};

struct RangeSensorPart {
  RangeSensorMount mount{};
  std::vector<Reference> hides{};
};

/// Mounts have no body index yet: they belong to the link that they stand in.
struct LinkPart {
  Body body{};
  std::vector<Sole> soles{};
  std::vector<CameraPart> cameras{};
  std::vector<ImuMount> imus{};
  std::vector<PressureSensorMount> pressure_sensors{};
  std::vector<TouchSensorMount> touch_sensors{};
  std::vector<ForceSensorMount> force_sensors{};
  std::vector<RangeSensorPart> range_sensors{};
  std::vector<WheelMount> wheels{};
};

struct JointPart {
  Joint joint{};
  bool fixed = false;
  Pose X_PJ{};  ///< the joint's frame on the parent link, at position 0
  Reference parent{}, child{};
  std::optional<double> sensor_resolution{};
};

/// A device of the robot's <player_api>, and the part of the robot that it is.
struct DevicePart {
  DeviceMount mount{};
  Reference part{};
};

using PropertyPart = std::pair<PropertyKey, PropertyText>;

/// A mesh in a frame S at the centre of its bounding box, parallel to the frame L of its file.
struct DrawnMesh {
  Vector3 p_LS{};  ///< [m]
  std::shared_ptr<const TriangleMesh> mesh{};
};
/// What a <geometry> is read for.
enum class GeometryUse { kTouching, kDrawn, kDrawnInItsOwnColours };

struct RobotPart {
  std::string name{};
  SourceLocation where{};
  std::string surface = "default";  ///< of shapes that name none
  int ignore_within = 1;            ///< joints between bodies that never touch
  std::map<std::string, Colour> materials{};
  std::map<std::string, ServoParameters> servo_types{};
  std::map<std::string, HullShape> hulls{};         ///< of meshes that touch, by file and scale
  std::map<std::string, DrawnMesh> drawn_meshes{};  ///< likewise; those in the colours of their file by a longer name
  std::vector<LinkPart> links{};
  std::vector<JointPart> joints{};
  std::vector<std::pair<Reference, Reference>> ignored_pairs{};
  std::vector<PropertyPart> properties{};
  std::vector<DevicePart> devices{};
  bool names_devices = false;  ///< has a <player_api>, though it may be empty
};

/// A required name attribute that keeps to the rules of names.
std::string readName(const XmlElement& element);
/// The attribute's text as a reference.
Reference readReference(const XmlElement& element, const char* attribute);
/// didYouMean for words of any length: looks at what a name can have, among the first 300 candidates, and no more after
/// 100 errors, so that a hostile file costs no time.
std::string nearestName(const Diagnostics& diagnostics, const std::string& word, std::vector<std::string> candidates);
template <class Value>
std::string nearestKey(const Diagnostics& diagnostics, const std::string& word,
                       const std::map<std::string, Value>& map) {
  if (diagnostics.errorCount() > 100) return "";
  std::vector<std::string> keys;
  for (const auto& [key, value] : map) {
    if (keys.size() < 300) keys.push_back(key);
  }
  return nearestName(diagnostics, word, std::move(keys));
}

/// The one shape of a <geometry>: overwrites out.shape, out.hull or out.mesh, and moves out.X_BS, given as the origin's
/// place, to the shape's. @return whether there is one; where not, an error was reported
bool readGeometry(const XmlElement& geometry, GeometryUse use, RobotPart& robot, BodyShape& out);
/// <material> definitions with a colour, at the top and within visuals.
void readMaterials(const XmlElement& robot_element, RobotPart& robot);
/// <murosimf> of the robot: servo types, surface, ignored contacts, properties, devices.
void readRobotExtension(const XmlElement& extension, RobotPart& robot);
/// <player_api> of the robot's <murosimf>.
void readPlayerApi(const XmlElement& element, RobotPart& robot);
/// Its devices, each with the part that it names: unknown parts are reported. Without <player_api> defaultDevices().
void resolveDevices(const RobotPart& robot, RobotModel& model, Diagnostics& diagnostics);
void readLink(const XmlElement& element, RobotPart& robot);
void readJoint(const XmlElement& element, RobotPart& robot);
/// A camera of a link's <murosimf>.
CameraPart readCamera(const XmlElement& element, RobotPart& robot);
/// A <laser_scanner> or a <distance_sensor> of a link's <murosimf>.
RangeSensorPart readLaserScanner(const XmlElement& element, RobotPart& robot);
RangeSensorPart readDistanceSensor(const XmlElement& element, RobotPart& robot);
/// A <wheel> or a <castor> of a link's <murosimf>.
WheelMount readWheel(const XmlElement& element, const LinkPart& link, RobotPart& robot);
WheelMount readCastor(const XmlElement& element, const LinkPart& link, RobotPart& robot);
/// Reports wheels in a link that this joint does not turn as wheels are turned; null: no joint does.
void checkWheels(const LinkPart& link, const JointPart* joint, Diagnostics& diagnostics);
/// Soles, cameras and sensors of a link's <murosimf>.
void readMounts(const XmlElement& extension, LinkPart& link, RobotPart& robot);
/// All <property> children, for this object ("" the robot).
void readProperties(const XmlElement& owner, const std::string& object, RobotPart& robot);

/// Puts the parts together: unique names, one root, no cycle, everything named exists, every joint moves mass. Returns
/// nothing when it reported an error, or when the parts are not whole: then it only looks at names and connections.
std::optional<RobotModel> assembleRobot(const RobotPart& robot, Diagnostics& diagnostics, bool parts_are_whole);

}  // namespace murosimf::urdf
