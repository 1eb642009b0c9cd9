#include "murosimf/modules/contact/ground_contact.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "murosimf/linking/links.h"

namespace murosimf {

namespace {

constexpr double kSameFace = 1e-3;  // [m] between a sole's rectangle and the lower face of a box

struct KindOnGround {
  GroundShape::Kind kind;
  int resting_points;
};
KindOnGround onGround(ShapeKind kind) {
  switch (kind) {
    case ShapeKind::kBox:
      return {GroundShape::Kind::kBox, GroundShape::kBoxPoints};
    case ShapeKind::kCylinder:
      return {GroundShape::Kind::kCylinder, GroundShape::kCylinderPoints};
    case ShapeKind::kCapsule:
      return {GroundShape::Kind::kCapsule, GroundShape::kCapsulePoints};
    case ShapeKind::kConvex:
      return {GroundShape::Kind::kConvex, GroundShape::kConvexPoints};
    case ShapeKind::kEllipsoid:
      break;
  }
  return {GroundShape::Kind::kEllipsoid, GroundShape::kEllipsoidPoints};
}

/// The sole that is the lower face of this box; -1 when none is.
int soleOf(const PlacedShape& s, const std::vector<SolePlace>& soles) {
  if (s.shape.kind != ShapeKind::kBox) return -1;
  const Vector3& half = s.shape.half_size;
  for (std::size_t i = 0; i < soles.size(); ++i) {
    if (soles[i].mount.row != s.row) continue;
    double farthest = 0;
    for (const double x : {-1.0, 1.0}) {
      for (const double y : {-1.0, 1.0}) {
        const Vector3 corner = s.X_BS * Vector3{x * half.x, y * half.y, -half.z};
        const Vector3 end = soles[i].mount.X_RM * Vector3{x * soles[i].half_length, y * soles[i].half_width, 0};
        farthest = max(farthest, norm(corner - end));
      }
    }
    if (farthest < kSameFace) return static_cast<int>(i);
  }
  return -1;
}

/// What rules say of a shape with the ground, or the table's pair.
ContactTerms termsWithGround(const std::vector<ContactTerms>& terms, std::size_t shape, const SurfaceTable& table,
                             const std::string& surface) {
  if (shape < terms.size()) return terms[shape];
  const SurfacePair* pair = table.find(surface, kGroundSurface);
  if (pair != nullptr) return {true, false, *pair};
  throw std::invalid_argument(fmt::format("no surface pair of {0} and {1}; expected [surfaces.{0}-{1}] in the scenario",
                                          surface, kGroundSurface));
}

void put(const Vector3& p, double (&numbers)[3]) { numbers[0] = p.x, numbers[1] = p.y, numbers[2] = p.z; }

void placeCorners(const PlacedShape& s, GroundShape& shape) {
  const Vector3& half = s.shape.half_size;
  if (s.shape.kind == ShapeKind::kCapsule) {
    for (int end = 0; end < 2; ++end) put(s.X_BS * Vector3{0, 0, end == 0 ? -half.z : half.z}, shape.corners[end]);
    return;
  }
  for (int i = 0; i < 8; ++i) {
    const Vector3 corner_S{(i & 1) != 0 ? half.x : -half.x, (i & 2) != 0 ? half.y : -half.y,
                           (i & 4) != 0 ? half.z : -half.z};
    put(s.X_BS * corner_S, shape.corners[i]);
  }
}

}  // namespace

void GroundContact::declare(Declaration& d) const {
  d.runsIn(Phase::kEvaluate);
  d.needs(kTree);
  d.needs(kShapes);
  d.uses(kSoles, {});
  d.uses(kWheels, {});
  d.uses(kWheelFriction, 0.0, subset::kWheels);
  d.uses(kWheelStickSpeed, 1e-3, subset::kWheels);
  d.uses(kWheelCreepage, 0.0, subset::kWheels);
  d.needs(kSurfaceTable, subset::kWorld);
  d.uses(kGroundTerms, {});
  d.reads(kBodyTwist, subset::kBodies);
  d.reads(kBodyUp, subset::kBodies);
  d.reads(kBodyHeight, subset::kBodies);
  d.accumulates(kBodyForce, subset::kBodies);
  d.accumulates(kContactTouch, subset::kBodies);
  d.accumulates(kSoleResponse, subset::kSoles);
  d.accumulates(kTouchResponse, subset::kTouchSensors);
  d.adds(kContactInertia, subset::kBodies);
}

void GroundContact::addVertices(const PlacedShape& s, const std::vector<SolePlace>& soles, GroundShape& shape) {
  const std::vector<Vector3>& vertices = s.hull->vertices();
  std::vector<GroundPoint>& numbers = vertices_.emplace_back(vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) put(s.X_BS * vertices[i], numbers[i].p);
  shape.vertices = numbers.data();
  shape.vertex_count = static_cast<int>(vertices.size());
  shape.least_corners = shape.vertex_count;
  for (const ConvexHull::Face& face : s.hull->faces()) shape.least_corners = min(shape.least_corners, face.count);
  const SoleShares& shares = shares_.emplace_back(shareBySole(s, soles));
  shape.sole = shares.sole;
  shape.shares = shares.of_vertices.data();
}

void GroundContact::addShape(const PlacedShape& s, const SurfacePair& pair, const std::vector<SolePlace>& soles) {
  GroundShape& shape = shapes_.emplace_back();
  const KindOnGround kind = onGround(s.shape.kind);
  shape.kind = kind.kind;
  shape.row = s.row;
  shape.sole = soleOf(s, soles);
  shape.touch_sensor = s.touch_sensor;
  shape.X_RS = kernelPose(s.X_BS);
  put(s.shape.half_size, shape.half_size);
  placeCorners(s, shape);
  if (s.hull != nullptr) addVertices(s, soles, shape);
  shape.reach = boundingRadius(s.shape);
  shape.pair = pair;
  if (laws_) shape.pair.normal_law = laws_->normal, shape.pair.friction_law = laws_->friction;
  shape.stiffness = shape.pair.stiffness / kind.resting_points;
}

void GroundContact::addWheel(const WheelPlace& place, int number, GroundShape& shape) const {
  const SinCos<double> angle = sincos(place.roller_angle);
  shape.kind = GroundShape::Kind::kWheel;
  shape.stiffness = shape.pair.stiffness;
  shape.wheel = {number, place.kind == WheelKind::kCastor, place.kind == WheelKind::kRollers, {}, angle.cos, angle.sin};
  put(place.axle, shape.wheel.axle);
}

void GroundContact::link(Links& links) {
  const SurfaceTable table = links.shared(kSurfaceTable, subset::kWorld);
  const std::vector<SolePlace> soles = links.shared(kSoles);
  const std::vector<ContactTerms> rules = links.shared(kGroundTerms);
  const std::vector<PlacedShape> shapes = links.shared(kShapes);
  const std::vector<WheelPlace> wheels = links.shared(kWheels);
  const int rows = links.shared(kTree).bodyCount();
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const PlacedShape& s = shapes[i];
    if (!s.collides) continue;
    const ContactTerms terms = termsWithGround(rules, i, table, s.surface);
    if (!terms.check) continue;
    if (s.row < 0 || s.row >= rows) throw std::invalid_argument(fmt::format("a shape on row {} of {}", s.row, rows));
    addShape(s, terms.surface, soles);
    if (s.wheel >= 0) addWheel(wheels.at(static_cast<std::size_t>(s.wheel)), s.wheel, shapes_.back());
  }
  const auto wheeled = std::stable_partition(
      shapes_.begin(), shapes_.end(), [](const GroundShape& shape) { return shape.kind != GroundShape::Kind::kWheel; });
  const auto bulges = std::stable_partition(shapes_.begin(), wheeled, [](const GroundShape& shape) {
    return shape.kind != GroundShape::Kind::kCapsule && shape.kind != GroundShape::Kind::kConvex;
  });
  arguments_ = {shapes_.data(),
                static_cast<int>(bulges - shapes_.begin()),
                static_cast<int>(wheeled - bulges),
                links.column(kBodyTwist, subset::kBodies),
                links.column(kBodyUp, subset::kBodies),
                links.column(kBodyHeight, subset::kBodies),
                links.column(kBodyForce, subset::kBodies),
                links.column(kContactInertia, subset::kBodies),
                links.column(kContactTouch, subset::kBodies),
                links.column(kSoleResponse, subset::kSoles),
                links.column(kTouchResponse, subset::kTouchSensors),
                static_cast<int>(shapes_.end() - wheeled),
                links.column(kWheelFriction, subset::kWheels),
                links.column(kWheelStickSpeed, subset::kWheels),
                links.column(kWheelCreepage, subset::kWheels)};
  kernel_ = kernelOfWidth<GroundContactArguments>(links.width());
}

}  // namespace murosimf
