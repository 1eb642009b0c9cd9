#include <fmt/format.h>

#include <stdexcept>

#include "murosimf/robot/checks.h"
#include "murosimf/robot/mesh_file.h"
#include "murosimf/robot/mesh_path.h"
#include "murosimf/robot/urdf_parts.h"

namespace murosimf::urdf {
namespace {

constexpr double kLeastSize = 1e-4, kLargestSize = 10;  // [m] of a mesh
constexpr std::size_t kMostPoints = 100000, kManyVertices = 128;

Shape readPrimitive(const XmlElement& shape) {
  const std::string kind = shape.name();
  if (kind == "box") {
    shape.accept({"size"});
    return makeBox(shape.vector("size"));
  }
  if (kind == "sphere") {
    shape.accept({"radius"});
    return makeSphere(shape.number("radius"));
  }
  if (kind == "cylinder" || kind == "capsule") {
    shape.accept({"radius", "length"});
    const double radius = shape.number("radius"), length = shape.number("length");
    return kind == "capsule" ? makeCapsule(radius, length) : makeCylinder(radius, length);
  }
  shape.accept({"radii"});
  return makeEllipsoid(shape.vector("radii"));
}

/// What is wrong with the size of a mesh; "" when nothing is.
std::string sizeProblem(const HullShape& hull) {
  const double size = 2 * max(hull.shape.half_size.x, max(hull.shape.half_size.y, hull.shape.half_size.z));
  if (size >= kLeastSize && size <= kLargestSize) return "";
  return fmt::format(
      "is {:.3g} m large, expected {:g} to {:g} m (scale=\"0.001 0.001 0.001\" makes metres of millimetres)", size,
      kLeastSize, kLargestSize);
}

/// The hull of a file's points. Reports what is wrong with them.
std::optional<HullShape> readHull(const XmlElement& mesh, const std::filesystem::path& file, const Vector3& scale) {
  const auto fail = [&](const std::string& problem) {
    mesh.errorAt("filename", fmt::format("is {}, which {}", quoted(mesh.text("filename")), problem));
    return std::nullopt;
  };
  MeshPoints read = readMeshPoints(file);
  if (!read.problem.empty()) return fail(read.problem);
  if (read.points.size() > kMostPoints)
    return fail(fmt::format("has {} corners, expected at most {}: simplify it", read.points.size(), kMostPoints));
  for (Vector3& p : read.points) p = {p.x * scale.x, p.y * scale.y, p.z * scale.z};
  try {
    const HullShape made = makeConvex(read.points);
    if (const std::string problem = sizeProblem(made); !problem.empty()) return fail(problem);
    return made;
  } catch (const std::invalid_argument& fault) {
    return fail(std::string("encloses nothing: ") + fault.what());
  }
}

void readMesh(const XmlElement& mesh, RobotPart& robot, BodyShape& out) {
  mesh.accept({"filename", "scale"});
  const int before = mesh.diagnostics().errorCount();
  const std::string name = mesh.text("filename");
  const Vector3 scale = mesh.vector("scale", {1, 1, 1});
  if (mesh.diagnostics().errorCount() != before) return;
  if (scale.x == 0 || scale.y == 0 || scale.z == 0) return mesh.errorAt("scale", "has a zero, expected three factors");
  const MeshPath path = findMesh(name, mesh.where().file);
  if (!path.file) return mesh.errorAt("filename", fmt::format("is {}, {}", quoted(name), path.problem));
  const std::string key = fmt::format("{} {} {} {}", path.file->string(), scale.x, scale.y, scale.z);
  auto known = robot.hulls.find(key);
  if (known == robot.hulls.end()) {
    const std::optional<HullShape> made = readHull(mesh, *path.file, scale);
    if (!made) return;
    known = robot.hulls.emplace(key, *made).first;
    const std::size_t vertices = made->hull->vertices().size();
    if (vertices > kManyVertices)
      mesh.warning(
          fmt::format("the convex hull of {} has {} vertices, and contacts with it cost in proportion; a mesh of "
                      "at most {} does as well",
                      quoted(name), vertices, kManyVertices));
  }
  out.shape = known->second.shape;
  out.hull = known->second.hull;
  out.X_BS.translation = out.X_BS * known->second.p_LS;
}

}  // namespace

bool readGeometry(const XmlElement& geometry, RobotPart& robot, BodyShape& out) {
  static const std::vector<std::string> kKinds{"box", "sphere", "cylinder", "ellipsoid", "capsule", "mesh"};
  const int before = geometry.diagnostics().errorCount();
  geometry.accept({}, kKinds);
  std::vector<XmlElement> shapes;
  for (const std::string& kind : kKinds) {
    for (const XmlElement& shape : geometry.children(kind.c_str())) shapes.push_back(shape);
  }
  if (shapes.size() != 1) {
    geometry.error(fmt::format("holds {} shapes, expected one of {}", shapes.size(), fmt::join(kKinds, ", ")));
    return false;
  }
  if (shapes[0].name() == "mesh") {
    readMesh(shapes[0], robot, out);
  } else {
    out.shape = readPrimitive(shapes[0]);
  }
  if (geometry.diagnostics().errorCount() != before) return false;
  geometry.check(shapeProblem(out));
  return true;
}

}  // namespace murosimf::urdf
