#include <fmt/format.h>

#include <stdexcept>

#include "murosimf/robot/checks.h"
#include "murosimf/robot/mesh_file.h"
#include "murosimf/robot/mesh_path.h"
#include "murosimf/robot/urdf_parts.h"

namespace murosimf::urdf {
namespace {

constexpr double kLeastSize = 1e-4, kLargestSize = 10;  // [m] of a mesh
constexpr double kFlat = 1e-6;                          // [m] half a thickness that is as good as none
constexpr std::size_t kMostPoints = 100000, kMostTriangles = 200000, kManyVertices = 128;

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
std::string sizeProblem(const Vector3& half_size) {
  const double size = 2 * max(half_size.x, max(half_size.y, half_size.z));
  if (size >= kLeastSize && size <= kLargestSize) return "";
  return fmt::format(
      "is {:.3g} m large, expected {:g} to {:g} m (scale=\"0.001 0.001 0.001\" makes metres of millimetres)", size,
      kLeastSize, kLargestSize);
}

/// A <mesh> whose file was found.
struct MeshElement {
  const XmlElement& element;
  std::filesystem::path file;
  Vector3 scale;
  std::string source() const { return fmt::format("{} {} {} {}", file.string(), scale.x, scale.y, scale.z); }
  void fail(const std::string& problem) const {
    element.errorAt("filename", fmt::format("is {}, which {}", quoted(element.text("filename")), problem));
  }
};

/// What the file holds, in metres. Reports what is wrong with it.
std::optional<MeshFile> readScaled(const MeshElement& mesh) {
  MeshFile read = readMeshFile(mesh.file);
  if (!read.problem.empty()) return mesh.fail(read.problem), std::nullopt;
  for (Vector3& p : read.points) p = {p.x * mesh.scale.x, p.y * mesh.scale.y, p.z * mesh.scale.z};
  return read;
}

/// The hull of a file's points. Reports what is wrong with them.
std::optional<HullShape> readHull(const MeshElement& mesh) {
  const std::optional<MeshFile> read = readScaled(mesh);
  if (!read) return std::nullopt;
  if (read->points.size() > kMostPoints) {
    mesh.fail(fmt::format("has {} corners, expected at most {}: simplify it", read->points.size(), kMostPoints));
    return std::nullopt;
  }
  try {
    const HullShape made = makeConvex(read->points);
    const std::string problem = sizeProblem(made.shape.half_size);
    if (problem.empty()) return made;
    mesh.fail(problem);
  } catch (const std::invalid_argument& fault) {
    mesh.fail(std::string("encloses nothing: ") + fault.what());
  }
  return std::nullopt;
}

/// The triangles of a file. Reports what is wrong with them.
std::optional<DrawnMesh> readDrawnMesh(const MeshElement& mesh, bool in_its_colours) {
  std::optional<MeshFile> read = readScaled(mesh);
  if (!read) return std::nullopt;
  if (read->triangles.size() > kMostTriangles) {
    mesh.fail(
        fmt::format("has {} triangles, expected at most {}: simplify it", read->triangles.size(), kMostTriangles));
    return std::nullopt;
  }
  Vector3 low = read->points.front(), high = low;
  for (const Vector3& p : read->points)
    for (int k = 0; k < 3; ++k) low[k] = min(low[k], p[k]), high[k] = max(high[k], p[k]);
  if (const std::string problem = sizeProblem((high - low) * 0.5); !problem.empty())
    return mesh.fail(problem), std::nullopt;
  DrawnMesh made{(low + high) * 0.5, nullptr};
  for (Vector3& p : read->points) p -= made.p_LS;
  if (mesh.scale.x * mesh.scale.y * mesh.scale.z < 0)  // a mirror turns triangles over
    for (TriangleCorners& t : read->triangles) std::swap(t[1], t[2]);
  if (!in_its_colours) read->colours.clear();
  try {
    made.mesh = std::make_shared<const TriangleMesh>(read->points, read->triangles, read->colours);
  } catch (const std::invalid_argument& fault) {
    return mesh.fail(std::string("cannot be drawn: ") + fault.what()), std::nullopt;
  }
  return made;
}

void useHull(const MeshElement& mesh, RobotPart& robot, BodyShape& out) {
  auto known = robot.hulls.find(out.mesh_source);
  if (known == robot.hulls.end()) {
    const std::optional<HullShape> made = readHull(mesh);
    if (!made) return;
    known = robot.hulls.emplace(out.mesh_source, *made).first;
    const std::size_t vertices = made->hull->vertices().size();
    if (vertices > kManyVertices)
      mesh.element.warning(
          fmt::format("the convex hull of {} has {} vertices, and contacts with it cost in proportion; a mesh of "
                      "at most {} does as well",
                      quoted(mesh.element.text("filename")), vertices, kManyVertices));
  }
  out.shape = known->second.shape;
  out.hull = known->second.hull;
  out.X_BS.translation = out.X_BS * known->second.p_LS;
}

void useTriangles(const MeshElement& mesh, bool in_its_colours, RobotPart& robot, BodyShape& out) {
  const std::string key = out.mesh_source + (in_its_colours ? " coloured" : "");
  auto known = robot.drawn_meshes.find(key);
  if (known == robot.drawn_meshes.end()) {
    const std::optional<DrawnMesh> made = readDrawnMesh(mesh, in_its_colours);
    if (!made) return;
    known = robot.drawn_meshes.emplace(key, *made).first;
  }
  const Vector3& half = known->second.mesh->halfSize();
  out.shape = {ShapeKind::kBox, {max(half.x, kFlat), max(half.y, kFlat), max(half.z, kFlat)}};
  out.mesh = known->second.mesh;
  out.X_BS.translation = out.X_BS * known->second.p_LS;
}

void readMesh(const XmlElement& element, GeometryUse use, RobotPart& robot, BodyShape& out) {
  element.accept({"filename", "scale"});
  const int before = element.diagnostics().errorCount();
  const std::string name = element.text("filename");
  const Vector3 scale = element.vector("scale", {1, 1, 1});
  if (element.diagnostics().errorCount() != before) return;
  if (scale.x == 0 || scale.y == 0 || scale.z == 0)
    return element.errorAt("scale", "has a zero, expected three factors");
  const MeshPath path = findMesh(name, element.where().file);
  if (!path.file) return element.errorAt("filename", fmt::format("is {}, {}", quoted(name), path.problem));
  const MeshElement mesh{element, *path.file, scale};
  out.mesh_source = mesh.source();
  if (use == GeometryUse::kTouching) return useHull(mesh, robot, out);
  useTriangles(mesh, use == GeometryUse::kDrawnInItsOwnColours, robot, out);
}

}  // namespace

bool readGeometry(const XmlElement& geometry, GeometryUse use, RobotPart& robot, BodyShape& out) {
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
    readMesh(shapes[0], use, robot, out);
  } else {
    out.shape = readPrimitive(shapes[0]);
  }
  if (geometry.diagnostics().errorCount() != before) return false;
  geometry.check(shapeProblem(out));
  return true;
}

}  // namespace murosimf::urdf
