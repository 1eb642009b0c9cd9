#include "murosimf/render/draw_list.h"

#include <algorithm>

namespace murosimf {

namespace {

std::array<float, 3> toPoint(const Vector3& p) {
  return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
}

/// A rotation whose z axis points along d, which is of unit length.
Rotation3 alongZ(const Vector3& d) {
  const Vector3 side = normalized(cross(d, std::abs(d.z) < 0.9 ? Vector3{0, 0, 1} : Vector3{1, 0, 0}));
  return {side, cross(d, side), d};
}

constexpr double kHeadLength = 5, kHeadRadius = 2.2;  // of an arrow, in radii of its shaft

}  // namespace

void DrawList::clear() {
  for (auto& instances : solid_) instances.clear();
  for (auto& instances : clear_tinted_) instances.clear();
  lines_.clear(), painted_.clear(), texts_.clear();
}

void DrawList::mesh(int number, const Pose& X_WM, const Vector3& stretch, const Tint& tint, std::uint32_t id) {
  auto& lists = tint.cover < 1 ? clear_tinted_ : solid_;
  if (lists.size() <= static_cast<std::size_t>(number)) lists.resize(static_cast<std::size_t>(number) + 1);
  MeshInstance& instance = lists[static_cast<std::size_t>(number)].emplace_back();
  const Rotation3& R = X_WM.rotation;
  for (int i = 0; i < 3; ++i) {
    instance.X_WM[static_cast<std::size_t>(i)] = {
        static_cast<float>(R.x[i] * stretch.x), static_cast<float>(R.y[i] * stretch.y),
        static_cast<float>(R.z[i] * stretch.z), static_cast<float>(X_WM.translation[i])};
  }
  instance.tint = tint;
  instance.id = id;
}

void DrawList::shape(const Shape& shape, const std::shared_ptr<const ConvexHull>& hull, const Pose& X_WS,
                     const Tint& tint, std::uint32_t id) {
  const Vector3& a = shape.half_size;
  switch (shape.kind) {
    case ShapeKind::kBox:
      return mesh(MeshLibrary::kBox, X_WS, a, tint, id);
    case ShapeKind::kEllipsoid:
      return mesh(MeshLibrary::kSphere, X_WS, a, tint, id);
    case ShapeKind::kCylinder:
      return mesh(MeshLibrary::kCylinder, X_WS, a, tint, id);
    case ShapeKind::kCapsule:
      mesh(MeshLibrary::kCylinder, X_WS, a, tint, id);
      for (const double end : {-a.z, a.z}) sphere(X_WS * Vector3{0, 0, end}, a.x, tint, id);
      return;
    case ShapeKind::kConvex:
      if (hull == nullptr) return mesh(MeshLibrary::kBox, X_WS, a, tint, id);
      return mesh(meshes_.numberOf(hull), X_WS, {1, 1, 1}, tint, id);
  }
}

void DrawList::sphere(const Vector3& p_W, double radius, const Tint& tint, std::uint32_t id) {
  mesh(MeshLibrary::kSphere, {{}, p_W}, {radius, radius, radius}, tint, id);
}

void DrawList::rod(const Vector3& a_W, const Vector3& b_W, double radius, const Tint& tint) {
  const double length = norm(b_W - a_W);
  if (!(length > 0)) return;
  mesh(MeshLibrary::kCylinder, {alongZ((b_W - a_W) * (1 / length)), (a_W + b_W) * 0.5}, {radius, radius, length / 2},
       tint);
}

void DrawList::arrow(const Vector3& a_W, const Vector3& b_W, double radius, const Tint& tint) {
  const double length = norm(b_W - a_W);
  if (!(length > 0)) return;
  const Vector3 d = (b_W - a_W) * (1 / length);
  const double head = min(kHeadLength * radius, 0.5 * length);
  const Vector3 neck_W = b_W - d * head;
  rod(a_W, neck_W, radius, tint);
  mesh(MeshLibrary::kCone, {alongZ(d), neck_W}, {kHeadRadius * radius, kHeadRadius * radius, head}, tint);
}

void DrawList::frame(const Pose& X_WF, double length) {
  const Vector3& p = X_WF.translation;
  const double radius = 0.03 * length;
  arrow(p, p + X_WF.rotation.x * length, radius, {0.9F, 0.15F, 0.15F});
  arrow(p, p + X_WF.rotation.y * length, radius, {0.15F, 0.75F, 0.15F});
  arrow(p, p + X_WF.rotation.z * length, radius, {0.2F, 0.35F, 1.0F});
}

void DrawList::line(const Vector3& a_W, const Vector3& b_W, const Tint& tint) {
  lines_.push_back({toPoint(a_W), tint});
  lines_.push_back({toPoint(b_W), tint});
}

void DrawList::paint(const Vector3& a_W, const Vector3& b_W, const Vector3& c_W, const Tint& tint) {
  for (const Vector3& p : {a_W, b_W, c_W}) painted_.push_back({toPoint({p.x, p.y, 0}), tint});
}

void DrawList::seeThrough(float cover) {
  clear_tinted_.resize(std::max(clear_tinted_.size(), solid_.size()));
  for (std::size_t number = 0; number < solid_.size(); ++number) {
    const auto shapes = std::stable_partition(solid_[number].begin(), solid_[number].end(),
                                              [](const MeshInstance& instance) { return instance.id == 0; });
    for (auto it = shapes; it != solid_[number].end(); ++it) it->tint.cover = cover;
    clear_tinted_[number].insert(clear_tinted_[number].end(), shapes, solid_[number].end());
    solid_[number].erase(shapes, solid_[number].end());
  }
}

void DrawList::text(const Vector3& p_W, std::string words, const Tint& tint) {
  texts_.push_back({p_W, std::move(words), tint});
}

}  // namespace murosimf
