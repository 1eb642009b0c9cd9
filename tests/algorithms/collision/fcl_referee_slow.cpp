// FCL 0.7 as a second referee. Built only where Debian's libfcl-dev is installed (cmake/peers.cmake).
//
// Solver: GST_LIBCCD, set explicitly; GST_INDEP misses most contacts of curved shapes.
// Where FCL is to be trusted, and what is asked there:
//   sphere against sphere, box, capsule, cylinder, and anything against a half-space: closed forms; equal depths.
//   all others: libccd's portals, except two boxes (FCL's own, edges disfavoured by 5 %). The depth is measured along
//     the ray from centre to centre, is up to 4 % off, and need not be the least. So FCL is asked whether the shapes
//     touch, and for a direction: the overlap along its normal, by our own support functions, is never less than the
//     depth found by us. How often it is more is printed.
// Left out: overlaps of less than 1e-5 m along the normal of either (FCL's tolerance), half-space against hull (FCL
// gives one vertex with another meaning of depth), half-space against a cylinder that nearly stands or lies (FCL takes
// it to stand or lie), and pairs for which FCL throws.
#include <fcl/fcl.h>
#include <gtest/gtest.h>

#include <cstdio>

#include "algorithms/collision/random_pairs.h"

namespace murosimf::collision_test {
namespace {

constexpr int kPoses = 20000;
constexpr double kTolerance = 1e-5;  // [m], FCL's

using Geometry = std::shared_ptr<fcl::CollisionGeometryd>;

fcl::Vector3d toFcl(const Vector3& v) { return {v.x, v.y, v.z}; }
Vector3 fromFcl(const fcl::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

fcl::Transform3d toFcl(const Pose& X) {
  fcl::Transform3d result = fcl::Transform3d::Identity();
  result.linear().col(0) = toFcl(X.rotation.x);
  result.linear().col(1) = toFcl(X.rotation.y);
  result.linear().col(2) = toFcl(X.rotation.z);
  result.translation() = toFcl(X.translation);
  return result;
}

Geometry convexOf(const ConvexHull& hull) {
  auto vertices = std::make_shared<std::vector<fcl::Vector3d>>();
  for (const Vector3& v : hull.vertices()) vertices->push_back(toFcl(v));
  auto faces = std::make_shared<std::vector<int>>();
  for (const auto& face : hull.faces()) {
    faces->push_back(face.count);
    for (const int corner : hull.corners(face)) faces->push_back(corner);
  }
  return std::make_shared<fcl::Convexd>(vertices, static_cast<int>(hull.faces().size()), faces);
}

Geometry geometryOf(const CollisionShape& s) {
  const Vector3& a = s.half_size;
  switch (s.kind) {
    case CollisionKind::kPlane:
      return std::make_shared<fcl::Halfspaced>(fcl::Vector3d(0, 0, 1), 0);
    case CollisionKind::kSphere:
      return std::make_shared<fcl::Sphered>(a.x);
    case CollisionKind::kBox:
      return std::make_shared<fcl::Boxd>(2 * a.x, 2 * a.y, 2 * a.z);
    case CollisionKind::kCapsule:
      return std::make_shared<fcl::Capsuled>(a.x, 2 * a.z);
    case CollisionKind::kCylinder:
      return std::make_shared<fcl::Cylinderd>(a.x, 2 * a.z);
    case CollisionKind::kEllipsoid:
      return std::make_shared<fcl::Ellipsoidd>(a.x, a.y, a.z);
    case CollisionKind::kConvex:
      break;
  }
  return convexOf(*s.hull);
}

/// FCL's deepest contact. normal from B to A, as ours.
struct Verdict {
  bool thrown = false, touch = false;
  double depth = 0;
  Vector3 normal;
};

Verdict ask(const Pair& pair) {
  const fcl::CollisionObjectd a(geometryOf(pair.a), toFcl(pair.X_WA)), b(geometryOf(pair.b), toFcl(pair.X_WB));
  fcl::CollisionRequestd request(10, true);
  request.gjk_solver_type = fcl::GJKSolverType::GST_LIBCCD;
  fcl::CollisionResultd result;
  Verdict verdict;
  try {
    fcl::collide(&a, &b, request, result);
  } catch (const std::exception&) {
    verdict.thrown = true;
    return verdict;
  }
  for (std::size_t i = 0; i < result.numContacts(); ++i) {
    const fcl::Contactd& contact = result.getContact(i);
    if (verdict.touch && contact.penetration_depth <= verdict.depth) continue;
    verdict.touch = true;
    verdict.depth = contact.penetration_depth;
    verdict.normal = -fromFcl(contact.normal);
    if (contact.o1 != a.collisionGeometry().get()) verdict.normal = -verdict.normal;
  }
  return verdict;
}

bool isClosedInFcl(CollisionKind a, CollisionKind b) {
  if (a == CollisionKind::kPlane) return true;
  return a == CollisionKind::kSphere && b <= CollisionKind::kCylinder;
}

struct Tally {
  int touching = 0, compared = 0, thrown = 0, missed = 0, missed_by_fcl = 0, unequal = 0, less = 0, deeper = 0;
};

void compare(const Pair& pair, bool closed, Dice& dice, Tally& tally) {
  ContactManifold ours;
  detectContact(pair.a, pair.X_WA, pair.b, pair.X_WB, ours);
  const double depth = ours.count > 0 ? deepest(ours).depth : 0;
  const Verdict fcl = ask(pair);
  tally.touching += ours.count > 0 ? 1 : 0;
  tally.thrown += fcl.thrown ? 1 : 0;
  if (fcl.thrown) return;
  if (!fcl.touch) {
    tally.missed_by_fcl += depth > kTolerance ? 1 : 0;
    return;
  }
  const bool has_normal = abs(norm(fcl.normal) - 1) < 1e-6;
  const double along = has_normal && !closed ? overlapAlong(pair, fcl.normal) : fcl.depth;
  if (ours.count == 0) {
    tally.missed += along > kTolerance && sweepDirections(pair, dice).depth > kTolerance ? 1 : 0;
    return;
  }
  if (depth < kTolerance || !has_normal) return;
  ++tally.compared;
  if (closed) tally.unequal += abs(fcl.depth - depth) > 1e-7 ? 1 : 0;
  tally.less += along < depth - 2e-6 ? 1 : 0;
  tally.deeper += along > 1.01 * depth + kTolerance ? 1 : 0;
}

TEST(FclReferee, FindsTheSameContactsAndNoShorterWayOut) {
  Dice dice(600);
  for (int i = 0; i < kCollisionKinds; ++i)
    for (int j = max(i, 1); j < kCollisionKinds; ++j) {
      const auto a = static_cast<CollisionKind>(i), b = static_cast<CollisionKind>(j);
      if (a == CollisionKind::kPlane && b == CollisionKind::kConvex) continue;
      Tally tally;
      for (int k = 0; k < kPoses; ++k) {
        const Pair pair = randomPair(a, b, dice);
        const bool on_plane = a == CollisionKind::kPlane && b == CollisionKind::kCylinder;
        if (!on_plane || !pair.aligned) compare(pair, isClosedInFcl(a, b), dice, tally);
      }
      std::printf(
          "%-9s %-9s: %d touch, %d compared; FCL threw %d, missed %d; we missed %d, unequal %d, FCL shorter %d; "
          "FCL's normal 1 %% deeper in %.2f %%\n",
          nameOf(a).c_str(), nameOf(b).c_str(), tally.touching, tally.compared, tally.thrown, tally.missed_by_fcl,
          tally.missed, tally.unequal, tally.less, 100.0 * tally.deeper / max(1, tally.compared));
      std::fflush(stdout);
      EXPECT_EQ(tally.missed, 0) << nameOf(a) << " " << nameOf(b);
      EXPECT_EQ(tally.unequal, 0) << nameOf(a) << " " << nameOf(b);
      EXPECT_EQ(tally.less, 0) << nameOf(a) << " " << nameOf(b);
      EXPECT_GT(tally.compared, kPoses / 4) << nameOf(a) << " " << nameOf(b);
    }
}

}  // namespace
}  // namespace murosimf::collision_test
