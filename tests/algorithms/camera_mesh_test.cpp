/// @file Meshes and capsules in pictures: against primitives of the same form, and against every triangle in turn.

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>
#include <stdexcept>

#include "algorithms/camera_scene.h"
#include "algorithms/mesh_shapes.h"
#include "murosimf/algorithms/mesh_tree.h"

namespace murosimf {
namespace {

using camera_scene::cameraPose;
using mesh_shapes::Triangles;

constexpr int kThing = 5;
const Colour kOrange{0.8F, 0.4F, 0.2F};

struct Studio {
  explicit Studio(const CameraModel& model = camera_scene::headCamera()) : camera(model), rays(camera) {}
  Picture shoot(CastLanes lanes = CastLanes::kWidest) {
    CastOptions options;
    options.lanes = lanes;
    PreparedScene work;
    Picture picture;
    castPicture(rays, scene, X_WC, {}, options, work, picture);
    return picture;
  }
  Picture shoot(const Drawable& thing) {
    scene.drawables = {thing};
    return shoot();
  }

  CameraModel camera;
  RayTable rays;
  RayScene scene;
  Pose X_WC = cameraPose({0, 0, 1}, 0, 0.1);
};

Drawable draw(const Triangles& triangles, const Pose& X_WS, int label = kThing) {
  Drawable d = camera_scene::place({}, X_WS, kOrange, label);
  d.mesh = triangles.mesh();
  return d;
}

bool equal(const Picture& a, const Picture& b) {
  return a.rgb == b.rgb && a.label == b.label &&
         std::memcmp(a.depth.data(), b.depth.data(), a.depth.size() * sizeof(float)) == 0;
}

/// Pixels that two pictures do not agree on: label, depth beyond `tolerance` [m], colour by more than a step.
struct Difference {
  int labels = 0, depths = 0, colours = 0, seen = 0;
};
Difference compare(const Picture& a, const Picture& b, double tolerance) {
  Difference d;
  for (std::size_t i = 0; i < a.label.size(); ++i) {
    d.seen += a.label[i] == kThing;
    if (a.label[i] != b.label[i]) {
      ++d.labels;
      continue;
    }
    if (a.label[i] != kThing) continue;
    d.depths += std::fabs(a.depth[i] - b.depth[i]) > tolerance;
    for (std::size_t k = 0; k < 3; ++k) d.colours += std::abs(a.rgb[3 * i + k] - b.rgb[3 * i + k]) > 1;
  }
  return d;
}

TEST(CameraMesh, BoxOfTrianglesEqualsTheBox) {
  for (const int cells : {1, 4, 30})
    for (const double turn : {0.0, 0.4, 2.1}) {
      Studio s;
      const Pose X_WS{fromRollPitchYaw(Vector3{turn, 0.5 * turn, turn}), {1.6, 0.1, 0.9}};
      const Vector3 edges{0.5, 0.7, 0.3};
      const Picture box = s.shoot(camera_scene::place(makeBox(edges), X_WS, kOrange, kThing));
      const Difference d = compare(box, s.shoot(draw(mesh_shapes::boxOf(edges, cells), X_WS)), 1e-5);
      EXPECT_GT(d.seen, 10000);
      EXPECT_LT(d.labels, 8) << cells << " " << turn;  // pixels on its edges
      EXPECT_LT(d.depths + d.colours, 20) << cells << " " << turn;
    }
}

TEST(CameraMesh, SphereOfMoreTrianglesComesNearerToTheSphere) {
  Studio s;
  const Pose X_WS{rotationX(0.3), {1.5, 0.2, 0.8}};
  const Vector3 radii{0.3, 0.2, 0.25};
  const Picture ellipsoid = s.shoot(camera_scene::place(makeEllipsoid(radii), X_WS, kOrange, kThing));
  double before = 1e9;
  for (const int columns : {16, 32, 64, 128}) {
    const Picture mesh = s.shoot(draw(mesh_shapes::ellipsoidOf(radii, columns), X_WS));
    double worst = 0;
    int missing = 0, seen = 0;
    for (std::size_t i = 0; i < mesh.label.size(); ++i) {
      if (ellipsoid.label[i] == kThing) ++seen, missing += mesh.label[i] != kThing;
      if (mesh.label[i] == kThing) {
        EXPECT_EQ(ellipsoid.label[i], kThing) << "a mesh of chords lies within";
        worst = std::max<double>(worst, std::fabs(mesh.depth[i] - ellipsoid.depth[i]));
      }
    }
    const double chord = 0.3 * (1 - std::cos(kPi / columns));
    EXPECT_LT(missing, seen * 3 * chord / 0.2 + 5) << columns;
    EXPECT_LT(worst, 0.75 * before) << columns;
    before = worst;
  }
}

TEST(CameraMesh, HasNoHolesBetweenItsTriangles) {
  Studio s;
  s.scene.sky = {0, 0, 0};
  const double radius = 0.3;
  for (const double distance : {0.5, 1.5, 12.0}) {
    const Picture p =
        s.shoot(draw(mesh_shapes::ellipsoidOf({radius, radius, radius}, 400), {rotationX(1.0), {distance, 0, 0.9}}));
    const Vector3 p_C = applyInverse(s.X_WC, Vector3{distance, 0, 0.9});
    const double within = 0.9995 * radius, cosine = std::sqrt(1 - within * within / squaredNorm(p_C));
    int inside = 0;
    for (int v = 0; v < 480; ++v)
      for (int u = 0; u < 640; ++u) {
        const RaySlopes r = s.rays.ray(u, v);
        if (dot(normalized(Vector3{r.x, r.y, 1}), normalized(p_C)) < cosine) continue;
        ++inside;
        EXPECT_EQ(p.label[p.index(u, v)], kThing) << u << " " << v;
        EXPECT_LT(p.depth[p.index(u, v)], distance) << "its far side shone through";
      }
    EXPECT_GT(inside, 300) << distance;
  }
}

/// Triangles thrown about: large and small ones, needles, some turned this and some that way.
Triangles rubble(int count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-0.5, 0.5), size(-2.5, -0.5);
  Triangles out;
  for (int i = 0; i < count; ++i) {
    const Vector3 middle{place(random), place(random), place(random)};
    const double edge = std::pow(10.0, size(random));
    for (int k = 0; k < 3; ++k)
      out.corners.push_back(middle + Vector3{place(random), place(random), place(random)} * edge);
    out.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return out;
}

/// Depth along a ray of the nearest triangle, by the formula of Moeller and Trumbore in double precision, and how far
/// inside it lies: the smallest barycentric coordinate. Infinite depth: none.
struct Hit {
  double depth = std::numeric_limits<double>::infinity(), margin = 1;
};
Hit bruteForce(const Triangles& t, const Pose& X_CS, const Vector3& ray) {
  Hit hit;
  double nearest_miss = 1;
  for (const TriangleCorners& c : t.triangles) {
    const Vector3 a = X_CS * t.corners[std::size_t(c[0])], b = X_CS * t.corners[std::size_t(c[1])] - a,
                  e = X_CS * t.corners[std::size_t(c[2])] - a, p = cross(ray, e);
    const double d = dot(b, p);
    if (d == 0) continue;
    const double u = -dot(a, p) / d, v = -dot(ray, cross(a, b)) / d, depth = -dot(e, cross(a, b)) / d;
    const double margin = std::min({u, v, 1 - u - v});
    if (depth <= 0) continue;
    if (margin < 0) nearest_miss = std::min(nearest_miss, -margin);
    if (margin >= 0 && depth < hit.depth) hit = {depth, margin};
  }
  hit.margin = std::min(hit.margin, nearest_miss);
  return hit;
}

TEST(CameraMesh, TreeFindsWhatATestOfEveryTriangleFinds) {
  Studio s(camera_scene::headCamera(160, 120));
  const Triangles t = rubble(700, 3);
  for (const double distance : {0.2, 0.9, 4.0}) {  // 0.2: the camera stands amid the triangles
    const Pose X_WS{fromRollPitchYaw(Vector3{0.3, 1.0, distance}), {distance, 0.05, 0.95}};
    const Picture p = s.shoot(draw(t, X_WS));
    const Pose X_CS = inverse(s.X_WC) * X_WS;
    int wrong = 0, met = 0;
    for (int v = 0; v < 120; ++v)
      for (int u = 0; u < 160; ++u) {
        const RaySlopes r = s.rays.ray(u, v);
        const Hit hit = bruteForce(t, X_CS, {r.x, r.y, 1});
        if (hit.margin < 1e-3) continue;  // on an edge
        const bool seen = p.label[p.index(u, v)] == kThing;
        const double sink = -(s.X_WC.rotation * Vector3{r.x, r.y, 1}).z, floor = sink > 0 ? 1 / sink : 1e9;
        met += seen;
        wrong += seen != (hit.depth < floor) || (seen && std::fabs(p.depth[p.index(u, v)] / hit.depth - 1) > 1e-3);
      }
    EXPECT_GT(met, distance > 1 ? 100 : 2000);
    EXPECT_LT(wrong, 5) << distance;
  }
}

TEST(CameraMesh, OpenSurfacesAreSeenFromBothSidesAndClosedOnesFromOutside) {
  Studio s;
  Triangles sheet;
  mesh_shapes::addGrid(
      3, 3,
      [](int i, int j) {
        return Vector3{0, 0.1 * i - 0.15, 0.1 * j - 0.15};
      },
      sheet);
  EXPECT_FALSE(sheet.mesh()->isClosed());
  const Picture front = s.shoot(draw(sheet, {{}, {1, 0, 0.9}})),
                back = s.shoot(draw(sheet, {rotationZ(kPi), {1, 0, 0.9}}));
  EXPECT_GT(std::count(front.label.begin(), front.label.end(), kThing), 10000);
  EXPECT_LT(compare(front, back, 1e-5).labels, 5);
  Triangles box = mesh_shapes::boxOf({1, 1, 1}, 3);
  EXPECT_TRUE(box.mesh()->isClosed());
  const Picture outside = s.shoot(draw(box, {{}, {2, 0, 1}}));
  EXPECT_EQ(s.shoot(draw(box, {{}, {0.2, 0, 1}})).label, s.shoot(draw(box, {{}, {-9, 0, 1}})).label) << "from within";
  for (TriangleCorners& t : box.triangles) std::swap(t[0], t[1]);
  EXPECT_TRUE(equal(outside, s.shoot(draw(box, {{}, {2, 0, 1}})))) << "turned inside out";
}

TEST(CameraMesh, TrianglesHaveColoursOfTheirOwn) {
  Studio s;
  s.scene.ambient = 1.0F;
  const Triangles box = mesh_shapes::boxOf({0.4, 0.4, 0.4}, 1);
  std::vector<Colour> colours(box.triangles.size(), Colour{1, 0, 0});
  colours[0] = colours[1] = {0, 0, 1};  // the face at -x
  Drawable d = draw(box, {{}, {1, 0, 0.9}});
  d.mesh = std::make_shared<TriangleMesh>(box.corners, box.triangles, colours);
  const Picture p = s.shoot(d);
  const std::size_t middle = 3 * p.index(320, 240);
  EXPECT_EQ(p.rgb[middle], 0);
  EXPECT_EQ(p.rgb[middle + 2], 255);
}

TEST(CameraMesh, WrongOnesAreRefusedWithTheReason) {
  const Triangles box = mesh_shapes::boxOf({1, 1, 1}, 1);
  const auto reason = [](const auto& make) -> std::string {
    try {
      make();
    } catch (const std::invalid_argument& fault) {
      return fault.what();
    }
    return "";
  };
  const std::vector<TriangleCorners> beyond{{0, 1, 99}}, flat{{0, 1, 1}};
  EXPECT_EQ(reason([&] { TriangleMesh(box.corners, beyond); }), "triangle mesh: found corner number 99 of 24");
  EXPECT_EQ(reason([&] { TriangleMesh(box.corners, flat); }), "triangle mesh: found no triangle that has an area");
  EXPECT_EQ(reason([&] { TriangleMesh(box.corners, box.triangles, std::vector<Colour>(3)); }),
            "triangle mesh: found 3 colours of 12 triangles");
  std::vector<Vector3> corners = box.corners;
  corners[2].y = std::nan("");
  EXPECT_EQ(reason([&] { TriangleMesh(corners, box.triangles); }), "triangle mesh: found a corner that is not finite");
}

TEST(CameraMesh, TreeHoldsEveryBoxOnceWithinTheBoxesAboveIt) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> place(-1, 1);
  for (const int count : {1, 8, 9, 1000, 20000}) {
    std::vector<MeshBox> boxes(static_cast<std::size_t>(count));
    for (MeshBox& b : boxes) {
      b.low = {place(random), count == 1000 ? 0.0F : place(random), 0.0F};
      b.high = {b.low[0] + 0.1F, b.low[1] + 0.1F, 0.1F};
    }
    if (count == 20000) std::fill(boxes.begin() + 100, boxes.end(), boxes[0]);  // all in one place
    const MeshTree tree = buildMeshTree(boxes);
    std::vector<int> found(boxes.size(), 0);
    int most_waiting = 0;
    std::vector<int> waiting{0};
    while (!waiting.empty()) {
      most_waiting = std::max(most_waiting, int(waiting.size()));
      const CastMeshNode& node = tree.nodes[std::size_t(waiting.back())];
      waiting.pop_back();
      for (std::size_t k = 0; k < kMeshWidth; ++k) {
        if (node.low[0][k] > node.high[0][k]) continue;
        if (node.child[k] >= 0) {
          waiting.push_back(node.child[k]);
          continue;
        }
        for (const int box : tree.groups[std::size_t(~node.child[k])]) {
          ++found[std::size_t(box)];
          for (std::size_t axis = 0; axis < 3; ++axis) {
            EXPECT_GE(boxes[std::size_t(box)].low[axis], node.low[axis][k]);
            EXPECT_LE(boxes[std::size_t(box)].high[axis], node.high[axis][k]);
          }
        }
      }
    }
    EXPECT_EQ(std::count(found.begin(), found.end(), 1), count);
    EXPECT_LT(most_waiting, kMeshStack);
  }
}

TEST(CameraMesh, PicturesAreTheSameForAnyNumberOfLanes) {
  Studio s;
  s.scene = camera_scene::makeGame();
  mesh_shapes::drawAsMeshes(24, s.scene);
  s.scene.drawables.push_back(draw(rubble(3000, 8), {{}, {0.4, 0.3, 0.6}}));
  s.scene.drawables.push_back(
      camera_scene::place(makeCapsule(0.05, 0.2), {rotationX(0.7), {0.6, -0.3, 0.3}}, kOrange, 6));
  for (const double heading : {0.25, -2.0}) {
    s.X_WC = cameraPose({-0.35, -0.2, 0.5}, heading, 0.35);
    const Picture one = s.shoot(CastLanes::kOne);
    EXPECT_TRUE(equal(one, s.shoot(CastLanes::kEight)));
    EXPECT_TRUE(equal(one, s.shoot(CastLanes::kWidest)));
  }
}

TEST(CameraMesh, GameOfMeshesLooksLikeTheGameOfPrimitives) {
  Studio s;
  s.scene = camera_scene::makeGame();
  s.X_WC = cameraPose({-0.35, -0.2, 0.5}, 0.25, 0.35);
  const Picture primitives = s.shoot();
  mesh_shapes::drawAsMeshes(48, s.scene);
  const Picture meshes = s.shoot();
  int different = 0;
  for (std::size_t i = 0; i < meshes.label.size(); ++i) different += meshes.label[i] != primitives.label[i];
  EXPECT_LT(different, 0.004 * double(meshes.label.size()));
  EXPECT_GT(different, 0) << "they were to be meshes";
}

TEST(CameraCapsule, EqualsACylinderAndTwoSpheres) {
  Studio s;
  const double radius = 0.1, length = 0.3;
  for (const double turn : {0.0, 0.6, 0.5 * kPi, 1.5}) {
    const Pose X_WS{rotationZ(turn) * rotationY(turn), {1.2, 0.1, 0.9}};
    s.scene.drawables = {camera_scene::place(makeCylinder(radius, length), X_WS, kOrange, kThing)};
    for (const double end : {-0.5, 0.5})
      s.scene.drawables.push_back(camera_scene::place(
          makeSphere(radius), {X_WS.rotation, X_WS * Vector3{0, 0, end * length}}, kOrange, kThing));
    const Picture parts = s.shoot();
    const Difference d =
        compare(parts, s.shoot(camera_scene::place(makeCapsule(radius, length), X_WS, kOrange, kThing)), 1e-4);
    EXPECT_GT(d.seen, 8000);
    EXPECT_LT(d.labels, 5) << turn;
    EXPECT_LT(d.depths, 5) << turn;
    EXPECT_LT(d.colours, 0.001 * d.seen) << turn;  // where side and sphere meet
  }
}

TEST(CameraCapsule, IsNotDrawnByACameraWithinIt) {
  Studio s;
  for (const Vector3& at : {Vector3{0, 0, 1}, Vector3{0, 0, 1.28}, Vector3{0.05, 0, 0.7}}) {
    const Picture p = s.shoot(camera_scene::place(makeCapsule(0.1, 0.5), {{}, at}, kOrange, kThing));
    EXPECT_EQ(std::count(p.label.begin(), p.label.end(), kThing), 0);
  }
}

}  // namespace
}  // namespace murosimf
