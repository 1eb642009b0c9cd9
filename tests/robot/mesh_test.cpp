/// @file Capsules and meshes of robot files: what is read, where files are looked for, what is wrong with them.

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "murosimf/robot/mesh_file.h"
#include "murosimf/robot/urdf_reader.h"

namespace murosimf {
namespace {

namespace fs = std::filesystem;

const std::string kData = MUROSIMF_SOURCE_DIR "/tests/data/";

struct Reading {
  ReadResult model;
  Diagnostics diagnostics;
  const std::vector<BodyShape>& shapes() const { return model->tree.bodies[0].shapes; }
};

std::string geometry(const std::string& shape) { return "<geometry>" + shape + "</geometry>"; }
std::string collision(const std::string& shape) { return "<collision>" + geometry(shape) + "</collision>\n"; }
std::string mesh(const std::string& file, const std::string& more = "") {
  return "<mesh filename='" + file + "' " + more + "/>";
}

/// Reads a robot of one link as if it were the file tests/data/test.urdf. What is given begins in line 2.
Reading read(const std::string& inside, const std::string& file = kData + "test.urdf") {
  Reading out;
  out.model = readUrdfText(
      "<robot name='test'><link name='trunk'><inertial><mass value='1'/><inertia ixx='1' iyy='1' "
      "izz='1'/></inertial>\n" +
          inside + "</link></robot>",
      file, out.diagnostics);
  return out;
}

/// A folder of this test's own, gone afterwards.
struct Folder {
  fs::path path = fs::temp_directory_path() / ("murosimf_mesh_test_" + std::to_string(::getpid()));
  Folder() { fs::create_directories(path); }
  ~Folder() { fs::remove_all(path); }
  std::string write(const std::string& name, const std::string& bytes) const {
    fs::create_directories((path / name).parent_path());
    std::ofstream(path / name, std::ios::binary) << bytes;
    return (path / name).string();
  }
};

using Triangle = std::array<std::array<float, 3>, 3>;

std::string binaryStl(const std::vector<Triangle>& triangles) {
  std::string bytes = "solid in name only";
  bytes.resize(80, ' ');
  const auto add = [&](const auto& value) {
    bytes.resize(bytes.size() + sizeof value);
    std::memcpy(bytes.data() + bytes.size() - sizeof value, &value, sizeof value);
  };
  add(static_cast<std::uint32_t>(triangles.size()));
  for (const Triangle& triangle : triangles) {
    add(std::array<float, 3>{});
    for (const auto& corner : triangle) add(corner);
    add(std::uint16_t{0});
  }
  return bytes;
}
std::vector<Triangle> tetrahedron(float size) {
  const std::array<float, 3> o{0, 0, 0}, x{size, 0, 0}, y{0, size, 0}, z{0, 0, size};
  return {Triangle{o, y, x}, {o, x, z}, {o, z, y}, {x, y, z}};
}
/// A surface of points spread evenly over a sphere, not closed: only its corners matter.
std::vector<Triangle> manyCorners(int count) {
  std::vector<Triangle> triangles;
  for (int i = 0; i < count; ++i) {
    std::array<float, 3> p{};
    const double z = 1 - (2 * i + 1.0) / count, angle = 2.399963229728653 * i, s = std::sqrt(1 - z * z);
    p = {static_cast<float>(0.1 * s * std::cos(angle)), static_cast<float>(0.1 * s * std::sin(angle)),
         static_cast<float>(0.1 * z)};
    triangles.push_back({p, p, p});
  }
  return triangles;
}

TEST(RobotFile, HasCapsulesWhoseLengthIsWithoutTheRoundEnds) {
  const Reading r = read(collision("<capsule radius='0.03' length='0.2'/>") + "<visual>" +
                         geometry("<capsule radius='0.03' length='0.2'/>") + "</visual>");
  ASSERT_TRUE(r.model.has_value()) << r.diagnostics.text();
  EXPECT_EQ(r.diagnostics.text(), "");
  ASSERT_EQ(r.shapes().size(), 1U) << "one shape, drawn and touching";
  EXPECT_EQ(r.shapes()[0].shape, makeCapsule(0.03, 0.2));
  EXPECT_EQ(r.shapes()[0].shape.half_size, (Vector3{0.03, 0.03, 0.1}));
  EXPECT_TRUE(r.shapes()[0].drawn && r.shapes()[0].collides);
}

TEST(RobotFile, HasMeshesThatCollideAsTheirConvexHullsAboutTheCentresOfTheirBoundingBoxes) {
  const Reading r = read("<collision><origin xyz='1 2 3' rpy='0 0 1.5707963267948966'/>" +
                         geometry(mesh("meshes/tetrahedron.obj", "scale='0.001 0.001 0.002'")) + "</collision>");
  ASSERT_TRUE(r.model.has_value()) << r.diagnostics.text();
  EXPECT_EQ(r.diagnostics.text(), "");
  const BodyShape& s = r.shapes()[0];
  EXPECT_EQ(s.shape.kind, ShapeKind::kConvex);
  EXPECT_NEAR(norm(s.shape.half_size - Vector3{0.03, 0.03, 0.06}), 0, 1e-8);
  EXPECT_NEAR(norm(s.X_BS.translation - Vector3{1, 2.1, 3}), 0, 1e-8) << "100 mm along x, turned";
  ASSERT_EQ(s.hull->vertices().size(), 4U);
  for (const Vector3& p : s.hull->vertices())
    EXPECT_NEAR(norm(Vector3{std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)} - s.shape.half_size), 0, 1e-8);
}

TEST(RobotFile, SharesOneHullAmongAllUsesOfAMeshOfOneScale) {
  const Reading r = read(collision(mesh("meshes/cube.stl")) + collision(mesh("../data/meshes/cube.stl")) +
                         collision(mesh("meshes/cube.stl", "scale='1 1 2'")) + "<visual>" +
                         geometry(mesh("meshes/cube.stl")) + "</visual>");
  ASSERT_TRUE(r.model.has_value()) << r.diagnostics.text();
  ASSERT_EQ(r.shapes().size(), 3U);
  EXPECT_TRUE(r.shapes()[0].drawn && r.shapes()[0].collides) << "drawn and touching in the same place: one shape";
  EXPECT_EQ(r.shapes()[0].hull, r.shapes()[1].hull);
  EXPECT_NE(r.shapes()[0].hull, r.shapes()[2].hull);
  EXPECT_NEAR(r.shapes()[2].shape.half_size.z, 0.1, 1e-8);
  EXPECT_EQ(r.diagnostics.text(), "");
  EXPECT_EQ(r.shapes()[0].mesh->triangleCount(), 12);
  EXPECT_EQ(r.shapes()[1].mesh, nullptr) << "not drawn";
}

TEST(RobotFile, DrawsMeshesAsTheirTrianglesAndNotAsTheirHulls) {
  const Folder folder;
  const std::string chair =  // an L of two squares that meet in an edge: its hull has other faces
      folder.write("chair.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 0 1 1\nf 1 2 3 4\nf 1 4 6 5\n");
  const Reading r = read("<visual><origin xyz='1 0 0'/>" + geometry(mesh(chair, "scale='0.1 0.1 -0.1'")) + "</visual>");
  ASSERT_TRUE(r.model.has_value()) << r.diagnostics.text();
  ASSERT_EQ(r.shapes().size(), 1U);
  EXPECT_EQ(r.shapes()[0].mesh->triangleCount(), 4);
  EXPECT_FALSE(r.shapes()[0].mesh->isClosed());
  EXPECT_EQ(r.shapes()[0].hull, nullptr) << "it touches nothing";
  EXPECT_NEAR(norm(r.shapes()[0].X_BS.translation - Vector3{1.05, 0.05, -0.05}), 0, 1e-8) << "middle of its box";
}

TEST(RobotFile, DrawsFlatMeshesThatCannotCollide) {
  const Reading r = read("<visual>" + geometry(mesh("meshes/square.stl")) + "</visual>");
  ASSERT_TRUE(r.model.has_value()) << r.diagnostics.text();
  EXPECT_EQ(r.shapes()[0].mesh->triangleCount(), 2);
}

TEST(RobotFile, TakesColoursOfAMeshFromItsFileWhereItNamesNone) {
  const Folder folder;
  folder.write("two.mtl", "newmtl rust\nKd 0.7 0.2 0.1\nnewmtl sky\nKd 0.1 0.2 0.9\n");
  const std::string file = folder.write(
      "two.obj", "mtllib two.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nusemtl rust\nf 1 2 3\nusemtl sky\nf 1 3 4\n");
  const MeshFile own = readMeshFile(file);
  ASSERT_EQ(own.colours.size(), 2U);
  EXPECT_EQ(own.colours[0], (Colour{0.7F, 0.2F, 0.1F}));
  EXPECT_EQ(own.colours[1], (Colour{0.1F, 0.2F, 0.9F}));
  const std::string shape = geometry(mesh(file));
  const Reading r = read("<visual>" + shape + "</visual><visual>" + shape +
                         "<material name='grey'><color rgba='0.5 0.5 0.5 1'/></material></visual>");
  ASSERT_TRUE(r.model.has_value()) << r.diagnostics.text();
  EXPECT_NE(r.shapes()[0].mesh->cast().colours, nullptr);
  EXPECT_EQ(r.shapes()[1].mesh->cast().colours, nullptr) << "the robot file's colour";
  EXPECT_TRUE(readMeshFile(kData + "meshes/cube.stl").colours.empty());
}

TEST(RobotFile, ReadsTextAndBinaryStlAndObjAlike) {
  const Folder folder;
  const std::string binary = folder.write("binary.STL", binaryStl(tetrahedron(0.5F)));
  const std::string object =
      folder.write("object.obj", "v 0 0 0\nv 0.5 0 0\nv 0 0.5 0\nv 0 0 0.5\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  const std::vector<Vector3> corners{{0, 0, 0}, {0, 0, 0.5}, {0, 0.5, 0}, {0.5, 0, 0}};
  EXPECT_EQ(readMeshFile(binary).points, corners);
  EXPECT_EQ(readMeshFile(object).points, corners);
  EXPECT_EQ(readMeshFile(object).triangles, (std::vector<TriangleCorners>{{0, 2, 3}, {0, 3, 1}, {0, 1, 2}, {3, 2, 1}}));
  EXPECT_EQ(readMeshFile(kData + "meshes/cube.stl").points.size(), 8U);
  EXPECT_EQ(readMeshFile(kData + "meshes/cube.stl").triangles.size(), 12U);
}

TEST(RobotFile, FindsMeshesByPackagesAboveItAndThenByRosPackagePath) {
  const Folder folder;
  const std::string stl = binaryStl(tetrahedron(0.5F));
  folder.write("here/bot/meshes/a.stl", stl), folder.write("there/arm/b.stl", stl), folder.write("hand/c.stl", stl);
  const std::string file = (folder.path / "here/bot/urdf/bot.urdf").string();
  const std::string packages = (folder.path / "there").string() + "::" + (folder.path / "hand").string();
  ::setenv("ROS_PACKAGE_PATH", packages.c_str(), 1);
  for (const std::string& name :
       {std::string("package://bot/meshes/a.stl"), std::string("package://arm/b.stl"),
        std::string("package://hand/c.stl"), std::string("../meshes/a.stl"),
        "file://" + (folder.path / "hand/c.stl").string(), (folder.path / "hand/c.stl").string()}) {
    const Reading r = read(collision(mesh(name)), file);
    EXPECT_TRUE(r.model.has_value()) << name << "\n" << r.diagnostics.text();
  }
  const std::string missing = read(collision(mesh("package://bot/meshes/b.stl")), file).diagnostics.text();
  ::unsetenv("ROS_PACKAGE_PATH");
  EXPECT_EQ(missing, file +
                         ":2: error: <mesh>: attribute \"filename\" is \"package://bot/meshes/b.stl\", which was not "
                         "found as \"bot/meshes/b.stl\" in " +
                         (folder.path / "here/bot/urdf").string() +
                         " and the folders above it, nor by ROS_PACKAGE_PATH: " + (folder.path / "there").string() +
                         " " + (folder.path / "hand").string() + "\n");
  const std::string unset = read(collision(mesh("package://bot/meshes/b.stl")), file).diagnostics.text();
  EXPECT_NE(unset.find("nor by ROS_PACKAGE_PATH, which is not set"), std::string::npos) << unset;
}

struct WrongMesh {
  const char *shape, *words;
};
class RobotFileWithAWrongMesh : public testing::TestWithParam<WrongMesh> {};

TEST_P(RobotFileWithAWrongMesh, IsToldOfItWithTheLine) {
  const Reading r = read(collision("<box size='1 1 1'/>") + collision(GetParam().shape));
  EXPECT_FALSE(r.model.has_value());
  EXPECT_EQ(r.diagnostics.errorCount(), 1) << r.diagnostics.text();
  EXPECT_EQ(r.diagnostics.all().front().where.line, 3);
  EXPECT_NE(r.diagnostics.text().find(GetParam().words), std::string::npos) << r.diagnostics.text();
}
INSTANTIATE_TEST_SUITE_P(
    Meshes, RobotFileWithAWrongMesh,
    testing::Values(
        WrongMesh{"<mesh/>", "attribute \"filename\" is missing"},
        WrongMesh{"<mesh filename='meshes/cub.stl'/>",
                  "is \"meshes/cub.stl\", a file that does not exist: looked for " MUROSIMF_SOURCE_DIR
                  "/tests/data/meshes/cub.stl"},
        WrongMesh{"<mesh filename='model://bot/a.stl'/>", "expected a path, file:// or package://PACKAGE/..."},
        WrongMesh{"<mesh filename='tumbler.urdf'/>", "is no mesh that can be read, expected a file .stl or .obj"},
        WrongMesh{"<mesh filename='meshes/text.stl'/>", "which cannot be read: \""},
        WrongMesh{"<mesh filename='meshes/lines.obj'/>", "which holds no triangles"},
        WrongMesh{"<mesh filename='meshes/not_a_number.stl'/>", "holds a coordinate that is no number"},
        WrongMesh{"<mesh filename='meshes/square.stl'/>",
                  "encloses nothing: convex hull: found points in one plane, expected points that enclose a body"},
        WrongMesh{"<mesh filename='meshes/tetrahedron.obj'/>",
                  "is 60 m large, expected 0.0001 to 10 m (scale=\"0.001 0.001 0.001\" makes metres of millimetres)"},
        WrongMesh{"<mesh filename='meshes/cube.stl' scale='1e-4 1e-4 1e-4'/>", "is 1e-05 m large"},
        WrongMesh{"<mesh filename='meshes/cube.stl' scale='1 0 1'/>", "attribute \"scale\" has a zero"},
        WrongMesh{"<mesh filename='meshes/cube.stl' scale='2'/>", "attribute \"scale\" is \"2\", expected 3 numbers"},
        WrongMesh{"<mesh filename='meshes/cube.stl' size='2'/>", "unknown attribute \"size\""},
        WrongMesh{"<capsule radius='0.1'/>", "attribute \"length\" is missing"},
        WrongMesh{"<capsule radius='0.1' length='-1'/>", "half sizes 0.1, 0.1, -0.5 m, expected all to be positive"}));

TEST(RobotFile, WarnsOfHullsWithManyVerticesAndRefusesTooManyCorners) {
  const Folder folder;
  const std::string rich = folder.write("rich.stl", binaryStl(manyCorners(300)));
  const Reading r = read(collision(mesh(rich)) + collision(mesh(rich)));
  ASSERT_TRUE(r.model.has_value()) << r.diagnostics.text();
  EXPECT_EQ(r.shapes()[0].hull->vertices().size(), 300U);
  EXPECT_EQ(r.diagnostics.all().size(), 1U) << "once";
  EXPECT_NE(r.diagnostics.text().find(":2: warning: <mesh>: the convex hull of"), std::string::npos);
  EXPECT_NE(r.diagnostics.text().find("has 300 vertices"), std::string::npos);
  const Reading refused = read(collision(mesh(folder.write("dust.stl", binaryStl(manyCorners(100001))))));
  EXPECT_NE(refused.diagnostics.text().find("has 100001 corners, expected at most 100000: simplify it"),
            std::string::npos)
      << refused.diagnostics.text();
  const std::vector<Triangle> many(200001, tetrahedron(0.5F)[0]);
  const Reading slow = read("<visual>" + geometry(mesh(folder.write("many.stl", binaryStl(many)))) + "</visual>");
  EXPECT_NE(slow.diagnostics.text().find("has 200001 triangles, expected at most 200000: simplify it"),
            std::string::npos)
      << slow.diagnostics.text();
}

TEST(RobotFile, DamagedMeshesNeverCrashTheReader) {
  const Folder folder;
  const std::string whole = binaryStl(tetrahedron(0.5F));
  for (std::size_t length = 0; length <= whole.size(); length += 7)
    readMeshFile(folder.write("cut.stl", whole.substr(0, length)));
  for (std::size_t at = 80; at < whole.size(); ++at) {
    std::string changed = whole;
    changed[at] = static_cast<char>(changed[at] ^ 0xff);
    const MeshFile read = readMeshFile(folder.write("changed.stl", changed));
    EXPECT_NE(read.points.empty(), read.problem.empty()) << at;
  }
  for (const char* text : {"f 1 2 3\n", "v 0 0 0\nf 1 99 3\nf -7 2 3\n", "v 1 2\nv\nf 1 1 1\n", "solid\nfacet\n"})
    for (const char* name : {"text.obj", "text.stl"}) readMeshFile(folder.write(name, text));
}

}  // namespace
}  // namespace murosimf
