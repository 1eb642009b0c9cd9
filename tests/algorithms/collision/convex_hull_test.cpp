// Hulls: corners, faces in one piece, edges; and what is no body.
#include "murosimf/algorithms/collision/convex_hull.h"

#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <stdexcept>
#include <vector>

#include "algorithms/collision/random_pairs.h"

namespace murosimf::collision_test {
namespace {

std::vector<Vector3> cubeCorners() {
  std::vector<Vector3> points;
  for (int i = 0; i < 8; ++i)
    points.push_back({(i & 1) != 0 ? 0.1 : -0.1, (i & 2) != 0 ? 0.1 : -0.1, (i & 4) != 0 ? 0.1 : -0.1});
  return points;
}

std::string errorOf(const std::vector<Vector3>& points) {
  try {
    const ConvexHull hull(points);
  } catch (const std::invalid_argument& fault) {
    return fault.what();
  }
  return "";
}

/// Closed, convex, every edge between two faces, corners counterclockwise; Euler: V - E + F = 2.
void expectPolytope(const ConvexHull& hull, const std::vector<Vector3>& points) {
  for (const auto& face : hull.faces()) {
    EXPECT_NEAR(norm(face.normal), 1, 1e-12);
    for (const Vector3& p : points) EXPECT_LE(dot(face.normal, p), face.offset + 1e-6 * hull.boundingRadius());
  }
  std::map<std::pair<int, int>, int> edges;
  for (const auto& face : hull.faces()) {
    const auto loop = hull.corners(face);
    Vector3 turn;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const int begin = loop[i], end = loop[(i + 1) % loop.size()];
      ++edges[{begin, end}];
      turn += cross(hull.vertex(begin) - hull.vertex(loop[0]), hull.vertex(end) - hull.vertex(loop[0]));
    }
    EXPECT_GT(dot(turn, face.normal), 0);
  }
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    EXPECT_EQ(edges.count({edge.second, edge.first}), 1U);
  }
  EXPECT_EQ(hull.vertices().size() + hull.faces().size(), edges.size() / 2 + 2);
}

TEST(ConvexHull, OfACubesCornersAndInnerPointsHasSixFacesOfFour) {
  std::vector<Vector3> points = cubeCorners();
  Dice dice(500);
  for (int i = 0; i < 200; ++i) points.push_back(dice.inBox(0.1));
  for (int i = 0; i < 50; ++i) points.push_back({dice.uniform(-0.1, 0.1), dice.uniform(-0.1, 0.1), 0.1});
  const ConvexHull hull(points);
  EXPECT_EQ(hull.vertices().size(), 8U);
  ASSERT_EQ(hull.faces().size(), 6U);
  for (const auto& face : hull.faces()) {
    EXPECT_EQ(face.count, 4);
    EXPECT_NEAR(face.offset, 0.1, 1e-12);
  }
  for (int i = 0; i < 8; ++i) EXPECT_EQ(hull.neighbours(i).size(), 3U);
  EXPECT_NEAR(hull.boundingRadius(), 0.1 * sqrt(3.0), 1e-12);
  EXPECT_NEAR(norm(hull.centre()), 0, 1e-12);
}

TEST(ConvexHull, OfRandomPointsIsAPolytopeThatHoldsThem) {
  Dice dice(501);
  for (int i = 0; i < 60; ++i) {
    std::vector<Vector3> points;
    const int count = 4 + dice.below(i < 50 ? 60 : 600);
    const Vector3 centre = dice.inBox(1);
    for (int k = 0; k < count; ++k) points.push_back(centre + (i % 2 == 0 ? dice.direction() * 0.1 : dice.inBox(0.1)));
    const ConvexHull hull(points);
    expectPolytope(hull, points);
    EXPECT_TRUE(i % 2 == 1 || hull.vertices().size() == points.size());
  }
}

TEST(ConvexHull, OfARoundedBodysMeshHasItsFlatEndsInOnePiece) {
  std::vector<Vector3> points;
  for (int i = 0; i < 48; ++i)
    for (const double z : {-0.1, 0.1}) points.push_back({0.05 * cos(i * kPi / 24), 0.05 * sin(i * kPi / 24), z});
  const ConvexHull hull(points);
  expectPolytope(hull, points);
  EXPECT_EQ(hull.vertices().size(), 96U);
  EXPECT_EQ(hull.faces().size(), 50U);
}

TEST(ConvexHull, FarthestVertexIsFoundByTheWalkToo) {
  Dice dice(502);
  for (const int count : {10, 30, 100, 400}) {
    std::vector<Vector3> points;
    for (int i = 0; i < count; ++i) points.push_back(dice.direction() * 0.1);
    const ConvexHull hull(points);
    for (int i = 0; i < 2000; ++i) {
      const Vector3 d = dice.direction() * dice.uniform(0.1, 5);
      double most = -1;
      for (const Vector3& v : hull.vertices()) most = max(most, dot(d, v));
      EXPECT_NEAR(dot(d, hull.vertex(hull.farthestVertex(d))), most, 1e-12);
    }
  }
}

TEST(ConvexHull, RepeatedAndCollinearPointsDoNoHarm) {
  std::vector<Vector3> points = cubeCorners();
  for (int i = 0; i < 8; ++i) points.push_back(points[static_cast<std::size_t>(i)]);
  for (int i = -9; i <= 9; ++i) points.push_back({0.1, 0.1, 0.01 * i}), points.push_back({0.1, 0.01 * i, 0});
  const ConvexHull hull(points);
  expectPolytope(hull, points);
  EXPECT_EQ(hull.faces().size(), 6U);
}

TEST(ConvexHull, SaysWhatIsNoBody) {
  std::vector<Vector3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_EQ(errorOf(points), "convex hull: found 3 points, expected 4 or more");
  points.push_back({1, 1, 0});
  EXPECT_EQ(errorOf(points), "convex hull: found points in one plane, expected points that enclose a body");
  EXPECT_NE(errorOf({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}).find("points on one line"), std::string::npos);
  EXPECT_NE(errorOf(std::vector<Vector3>(5, {1, 2, 3})).find("coincide"), std::string::npos);
  points.push_back({0, 0, std::numeric_limits<double>::quiet_NaN()});
  EXPECT_NE(errorOf(points).find("point 4 is no number"), std::string::npos);
}

}  // namespace
}  // namespace murosimf::collision_test
