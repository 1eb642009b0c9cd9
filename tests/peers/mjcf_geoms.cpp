#include "peers/mjcf_geoms.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "murosimf/world/vocabulary.h"

namespace murosimf::peers {

namespace {

constexpr double kContactTime = 0.02;      // MuJoCo's own [s]
constexpr std::size_t kContactTypes = 31;  // bits of an int without its sign

std::string text(const Vector3& v) { return fmt::format("{} {} {}", v.x, v.y, v.z); }

/// Kind, size, and what an ellipsoid or cylinder has in common with ours: axes, radius and half length along z.
std::string shapeText(const Shape& shape) {
  const Vector3& half = shape.half_size;
  switch (shape.kind) {
    case ShapeKind::kBox:
      return fmt::format("type=\"box\" size=\"{}\"", text(half));
    case ShapeKind::kCylinder:
      return fmt::format("type=\"cylinder\" size=\"{} {}\"", half.x, half.z);
    case ShapeKind::kCapsule:
      return fmt::format("type=\"capsule\" size=\"{} {}\"", half.x, half.z);
    case ShapeKind::kConvex:
      throw std::runtime_error("a convex hull, expected primitives: the comparison writes no meshes");
    case ShapeKind::kEllipsoid:
      break;
  }
  if (half.x == half.y && half.y == half.z) return fmt::format("type=\"sphere\" size=\"{}\"", half.x);
  return fmt::format("type=\"ellipsoid\" size=\"{}\"", text(half));
}

std::string geom(const std::string& shape, const std::string& where, unsigned type, unsigned affinity, double friction,
                 double contact_time = kContactTime) {
  return fmt::format("<geom {} {} contype=\"{}\" conaffinity=\"{}\" friction=\"{} 0.005 0.0001\" solref=\"{} 1\"/>\n",
                     shape, where, type, affinity, friction, contact_time);
}

std::string plane(unsigned type, double friction, double contact_time = kContactTime) {
  return geom("type=\"plane\" size=\"0 0 1\"", "", type, 0, friction, contact_time);
}

/// Calls visit(shape, place of the body) for all shapes that collide.
template <class Visit>
void forColliding(const RobotBlueprint& robot, Visit&& visit) {
  for (std::size_t i = 0; i < robot.model.tree.bodies.size(); ++i) {
    for (const BodyShape& shape : robot.model.tree.bodies[i].shapes) {
      if (shape.collides) visit(shape, robot.flat.bodies[i]);
    }
  }
}

}  // namespace

std::string mjcfPlace(const Pose& X) {
  return fmt::format("pos=\"{}\" xyaxes=\"{} {}\"", text(X.translation), text(X.rotation.x), text(X.rotation.y));
}

std::string SoleGeoms::ground() const { return plane(1, scene_.friction); }

std::string SoleGeoms::onRow(int /*robot*/, int row) const {
  std::string geoms;
  for (const Sole& sole : scene_.robot.model.soles) {
    const RowPlace box = soleBox(scene_.robot, sole);
    const Shape shape = makeBox({sole.length, sole.width, kSoleThickness});
    if (box.row == row) geoms += geom(shapeText(shape), mjcfPlace(box.X_RB), 0, 1, scene_.friction);
  }
  return geoms;
}

HeapGeoms::HeapGeoms(const PeerHeap& heap) : heap_(heap) {
  forColliding(heap.robot, [&](const BodyShape& shape, const RowPlace&) {
    if (std::find(surfaces_.begin(), surfaces_.end(), shape.surface) == surfaces_.end())
      surfaces_.push_back(shape.surface);
  });
  if (surfaces_.size() + static_cast<std::size_t>(heap.robots) > kContactTypes)
    throw std::invalid_argument(fmt::format("{} robots and {} surfaces, expected at most {} of both", heap.robots,
                                            surfaces_.size(), kContactTypes));
  requireLargerFrictions();
}

double HeapGeoms::friction(std::string_view a, std::string_view b) const {
  const SurfacePair* pair = heap_.surfaces.find(a, b);
  if (pair == nullptr) throw std::invalid_argument(fmt::format("no surface pair of {} and {}", a, b));
  return pair->friction;
}

/// MuJoCo's rule is to give what the table says.
void HeapGeoms::requireLargerFrictions() const {
  const auto require = [&](std::string_view a, std::string_view b, double larger) {
    if (friction(a, b) == larger) return;
    throw std::invalid_argument(fmt::format("friction of {} and {} is {}, expected {}: MuJoCo takes the larger one", a,
                                            b, friction(a, b), larger));
  };
  for (const std::string& a : surfaces_) {
    for (const std::string& b : surfaces_) require(a, b, std::max(friction(a, a), friction(b, b)));
    require(a, kGroundSurface, std::max(friction(a, a), friction(a, kGroundSurface)));
  }
}

unsigned HeapGeoms::groundType(std::string_view surface) const {
  return 1U << (std::find(surfaces_.begin(), surfaces_.end(), surface) - surfaces_.begin());
}

unsigned HeapGeoms::otherRobots(int robot) const {
  unsigned types = 0;
  for (int other = 0; other < heap_.robots; ++other) types |= other == robot ? 0 : robotType(other);
  return types;
}

std::string HeapGeoms::ground() const {
  std::string planes;
  for (const std::string& surface : surfaces_)
    planes += plane(groundType(surface), friction(surface, kGroundSurface), heap_.contact_time);
  return planes;
}

std::string HeapGeoms::onRow(int robot, int row) const {
  std::string geoms;
  forColliding(heap_.robot, [&](const BodyShape& shape, const RowPlace& body) {
    if (body.row != row) return;
    geoms += geom(shapeText(shape.shape), mjcfPlace(body.X_RB * shape.X_BS), robotType(robot),
                  otherRobots(robot) | groundType(shape.surface), friction(shape.surface, shape.surface),
                  heap_.contact_time);
  });
  return geoms;
}

}  // namespace murosimf::peers
