#include <fmt/format.h>

#include <algorithm>

#include "murosimf/robot/checks.h"
#include "murosimf/robot/urdf_parts.h"

namespace murosimf::urdf {
namespace {

constexpr std::size_t kMostShapes = 1000;

Pose readOrigin(const XmlElement& owner) {
  const std::optional<XmlElement> origin = owner.child("origin");
  if (!origin) return {};
  origin->accept({"xyz", "rpy"});
  return origin->pose();
}

MassProperties readInertial(const XmlElement& inertial) {
  const Diagnostics& diagnostics = inertial.diagnostics();
  const int before = diagnostics.errorCount();
  inertial.accept({}, {"origin", "mass", "inertia"});
  const Pose X_BC = readOrigin(inertial);
  MassProperties seen_from_c;
  if (const std::optional<XmlElement> mass = inertial.requiredChild("mass")) {
    mass->accept({"value"});
    seen_from_c.mass = mass->number("value");
  }
  std::optional<XmlElement> inertia = inertial.requiredChild("inertia");
  if (inertia) {
    inertia->accept({"ixx", "iyy", "izz", "ixy", "ixz", "iyz"});
    seen_from_c.I_C_B = {inertia->number("ixx"),    inertia->number("iyy"),    inertia->number("izz"),
                         inertia->number("ixy", 0), inertia->number("ixz", 0), inertia->number("iyz", 0)};
  }
  if (diagnostics.errorCount() != before) return {};
  const std::string problem = massProblem(seen_from_c);
  if (problem.starts_with("mass"))
    inertial.child("mass")->error(problem);
  else
    inertia->check(problem);
  return moved(X_BC, seen_from_c);
}

void readColour(const XmlElement& visual, const RobotPart& robot, BodyShape& shape) {
  if (const std::optional<XmlElement> material = visual.child("material")) {
    material->accept({"name"}, {"color", "texture"});
    const std::string name = material->text("name");
    const auto found = robot.materials.find(name);
    if (found != robot.materials.end()) {
      shape.colour = found->second;
    } else if (material->children("color").empty() && material->children("texture").empty() && !name.empty()) {
      material->errorAt("name", "is " + quoted(name) + ", which no material has" +
                                    nearestKey(material->diagnostics(), name, robot.materials));
    }
  }
  if (const std::optional<XmlElement> extension = visual.child("murosimf")) {
    extension->accept({"colour"});
    const std::string colour = extension->text("colour");
    if (colour != "team") extension->errorAt("colour", "is " + quoted(colour) + ", expected \"team\"");
    shape.team_colour = true;
  }
}

/// What <visual> and <collision> have in common.
std::optional<BodyShape> readPlacedShape(const XmlElement& element, GeometryUse use, RobotPart& robot) {
  BodyShape out;
  out.where = element.where();
  out.X_BS = readOrigin(element);
  const int before = element.diagnostics().errorCount();
  const std::optional<XmlElement> geometry = element.requiredChild("geometry");
  if (!geometry || element.diagnostics().errorCount() != before || !readGeometry(*geometry, use, robot, out))
    return std::nullopt;
  return out;
}

/// A colour in the robot file stands above those in a mesh's own file.
GeometryUse useOf(const XmlElement& visual) {
  const bool told = visual.child("material").has_value() || visual.child("murosimf").has_value();
  return told ? GeometryUse::kDrawn : GeometryUse::kDrawnInItsOwnColours;
}

void readVisuals(const XmlElement& link, RobotPart& robot, Body& body) {
  for (const XmlElement& visual : link.children("visual")) {
    visual.accept({"name"}, {"origin", "geometry", "material", "murosimf"});
    std::optional<BodyShape> shape = readPlacedShape(visual, useOf(visual), robot);
    BodyShape unknown;  // so that the colour's mistakes are found even where the shape is wrong
    BodyShape& target = shape ? *shape : unknown;
    readColour(visual, robot, target);
    target.collides = false;
    if (shape) body.shapes.push_back(*shape);
  }
}

bool isSame(const BodyShape& drawn, const BodyShape& touching) {
  if (drawn.mesh_source != touching.mesh_source || drawn.X_BS != touching.X_BS) return false;
  return touching.hull != nullptr || drawn.shape == touching.shape;
}

/// A collision shape that equals a drawn one in form and place is the same shape, drawn and touching.
void readCollisions(const XmlElement& link, const std::string& surface_of_link, RobotPart& robot, Body& body) {
  for (const XmlElement& collision : link.children("collision")) {
    collision.accept({"name"}, {"origin", "geometry", "murosimf"});
    std::optional<BodyShape> shape = readPlacedShape(collision, GeometryUse::kTouching, robot);
    std::string surface = surface_of_link;
    if (const std::optional<XmlElement> extension = collision.child("murosimf")) {
      extension->accept({"surface"});
      surface = extension->text("surface");
    }
    if (!shape) continue;
    const auto same = std::find_if(body.shapes.begin(), body.shapes.end(),
                                   [&](const BodyShape& drawn) { return !drawn.collides && isSame(drawn, *shape); });
    shape->drawn = false;
    BodyShape& kept = same != body.shapes.end() ? *same : body.shapes.emplace_back(*shape);
    kept.shape = shape->shape, kept.hull = shape->hull;
    kept.collides = true;
    kept.surface = surface;
  }
}

}  // namespace

void readMaterials(const XmlElement& robot_element, RobotPart& robot) {
  const auto define = [&robot](const XmlElement& material) {
    const std::optional<XmlElement> color = material.child("color");
    if (!color || !material.has("name")) return;
    color->accept({"rgba"});
    const int before = color->diagnostics().errorCount();
    const std::vector<double> rgba = color->numbers("rgba", 4);
    const bool in_range = std::all_of(rgba.begin(), rgba.end(), [](double c) { return c >= 0 && c <= 1; });
    if (!in_range && color->diagnostics().errorCount() == before) color->errorAt("rgba", "leaves the range 0 to 1");
    if (!in_range) return;
    robot.materials[material.text("name")] = {static_cast<float>(rgba[0]), static_cast<float>(rgba[1]),
                                              static_cast<float>(rgba[2])};
  };
  for (const XmlElement& material : robot_element.children("material")) {
    material.accept({"name"}, {"color", "texture"});
    material.text("name");
    define(material);
  }
  for (const XmlElement& link : robot_element.children("link")) {
    for (const XmlElement& visual : link.children("visual")) {
      for (const XmlElement& material : visual.children("material")) define(material);
    }
  }
}

void readLink(const XmlElement& element, RobotPart& robot) {
  element.accept({"name"}, {"inertial", "visual", "collision", "murosimf"});
  LinkPart link;
  link.body.name = readName(element);
  link.body.where = element.where();
  if (const std::optional<XmlElement> inertial = element.child("inertial")) link.body.mass = readInertial(*inertial);

  const std::optional<XmlElement> extension = element.child("murosimf");
  const std::string surface = extension ? extension->text("surface", robot.surface) : robot.surface;
  const bool collides = !extension || extension->truth("collides", true);
  const std::size_t shapes = element.children("visual").size() + element.children("collision").size();
  if (shapes > kMostShapes) {
    element.error(fmt::format("has {} visuals and collisions, expected at most {}", shapes, kMostShapes));
  } else {
    readVisuals(element, robot, link.body);
    readCollisions(element, surface, robot, link.body);
  }
  const bool has_collision = !element.children("collision").empty();
  if (collides && !has_collision && !link.body.shapes.empty()) {
    element.warning(
        quoted(link.body.name) +
        " is drawn but has no <collision>: it touches nothing; say <murosimf collides=\"false\"/> if that is "
        "meant");
  }
  if (!collides && has_collision) element.error("has a <collision>, and collides=\"false\"");
  if (extension) {
    extension->accept({"surface", "collides"},
                      {"sole", "camera", "imu", "pressure_sensor", "touch_sensor", "force_sensor", "laser_scanner",
                       "distance_sensor", "wheel", "castor", "property"});
    readMounts(*extension, link, robot);
    readProperties(*extension, link.body.name, robot);
  }
  if (!link.body.name.empty()) robot.links.push_back(std::move(link));
}

}  // namespace murosimf::urdf
