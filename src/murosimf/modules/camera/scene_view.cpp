#include "murosimf/modules/camera/scene_view.h"

#include <algorithm>

#include "murosimf/world/vocabulary.h"

namespace murosimf {

namespace {
constexpr std::uint32_t kRowsPerOwner = 256;

/// A hull's faces, each cut into a fan.
std::shared_ptr<const TriangleMesh> meshOf(const ConvexHull& hull) {
  std::vector<TriangleCorners> triangles;
  for (const ConvexHull::Face& face : hull.faces()) {
    const std::span<const int> corner = hull.corners(face);
    for (std::size_t k = 2; k < corner.size(); ++k) triangles.push_back({corner[0], corner[k - 1], corner[k]});
  }
  return std::make_shared<const TriangleMesh>(hull.vertices(), triangles);
}
}  // namespace

const OutsideAccess& SceneView::robotAccess() {
  static const OutsideAccess access([](Declaration& d) {
    d.needs(kShapes);
    d.reads(kBodyPose, subset::kBodies);
    d.reads(kBodyPoseLast, subset::kBodies);
    d.reads(kShownBase);
    d.reads(kShownBaseLast);
  });
  return access;
}

SceneView::SceneView(const World& world, LinkedWorld& linked, const std::vector<ObjectId>& robots,
                     const std::vector<ObjectId>& free_bodies, const std::vector<ObjectId>& fixed)
    : robots_(robots), frame_length_(linked.frameLength()) {
  if (const PaintedGround* ground = world.findShared(world.root(), kGround)) initial_.ground = *ground;
  for (const ObjectId id : free_bodies) {
    Source source;
    source.body = static_cast<int>(bodies_.size());
    bodies_.push_back(linked.handle(id, kBasePose));
    velocities_.push_back(linked.handle(id, kBodyVelocity));
    rates_.push_back(linked.handle(id, kBodyRate));
    addShapes(world, id, Pose{}, SeenKind::kFreeBody, source);
  }
  for (const ObjectId id : robots) {
    Source source;
    source.robot = static_cast<int>(paths_.size());
    paths_.emplace_back(linked, id);
    addShapes(world, id, Pose{}, SeenKind::kRobot, source);
  }
  for (const ObjectId id : fixed) addShapes(world, id, *world.find(id, kFixedPose), SeenKind::kFixed, Source{});
}

void SceneView::addShapes(const World& world, ObjectId object, const Pose& X_WB, SeenKind kind, Source source) {
  labelled_.push_back(object);
  classes_.push_back({kind, world.path(object)});
  const auto label = static_cast<std::uint16_t>(labelled_.size());
  for (const PlacedShape& s : *world.findShared(object, kShapes)) {
    if (!s.drawn) continue;
    source.row = s.row;
    source.X_BS = s.X_BS;
    sources_.push_back(source);
    Drawable& drawable = initial_.drawables.emplace_back();
    drawable.shape = s.shape;
    drawable.mesh = s.mesh;
    if (!s.mesh && s.hull) {
      std::shared_ptr<const TriangleMesh>& made = meshes_of_hulls_[s.hull.get()];
      if (!made) made = meshOf(*s.hull);
      drawable.mesh = made;
    }
    drawable.X_WS = X_WB * s.X_BS;
    drawable.colour = s.colour;
    drawable.label = label;
    drawable.owner = label * kRowsPerOwner + static_cast<std::uint32_t>(s.row);
  }
}

void SceneView::snapshot(long frame, RayScene& scene) const {
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    const Source& source = sources_[i];
    Pose& X_WS = scene.drawables[i].X_WS;
    if (source.robot >= 0) {
      const BodyPath& path = paths_[static_cast<std::size_t>(source.robot)];
      X_WS = path.pose(source.row, path.shareAfter(frame)) * source.X_BS;
    } else if (source.body >= 0) {
      X_WS = bodies_[static_cast<std::size_t>(source.body)].get() * source.X_BS;
    }
    if (!scene.motions.empty()) scene.motions[i] = motionOf(source, X_WS, frame);
  }
}

/// Of a drawable's origin. What never moves has none.
SpatialMotion<double> SceneView::motionOf(const Source& source, const Pose& X_WS, long frame) const {
  SpatialMotion<double> V;
  Vector3 p_WB;
  if (source.robot >= 0) {
    const BodyPath& path = paths_[static_cast<std::size_t>(source.robot)];
    V = motionOf(path, source.row, frame);
    p_WB = path.position(source.row, path.shareAfter(frame));
  } else if (source.body >= 0) {
    const auto body = static_cast<std::size_t>(source.body);
    V = {rates_[body].get(), velocities_[body].get()};
    p_WB = bodies_[body].get().translation;
  }
  return {V.w, V.v + cross(V.w, X_WS.translation - p_WB)};
}

/// A hand's work is no motion.
SpatialMotion<double> SceneView::motionOf(const BodyPath& path, int row, long frame) const {
  constexpr double kJump = 0.05;  // [m] in a frame
  const Pose begin = path.pose(row, path.shareAt(frame)), end = path.pose(row, path.shareAfter(frame));
  const Vector3 way = end.translation - begin.translation;
  if (squaredNorm(way) > kJump * kJump) return {};
  const double per_second = 1 / frame_length_;
  return {end.rotation * rotationLog(transposed(begin.rotation) * end.rotation) * per_second, way * per_second};
}

std::uint16_t SceneView::labelOf(ObjectId object) const {
  const auto found = std::find(labelled_.begin(), labelled_.end(), object);
  return found == labelled_.end() ? std::uint16_t{0} : static_cast<std::uint16_t>(found - labelled_.begin() + 1);
}

const SeenClass& SceneView::classOf(std::uint16_t label) const {
  static const SeenClass kSky{SeenKind::kSky, ""}, kLine{SeenKind::kLine, ""};
  if (label == kSkyLabel) return kSky;
  return label == kLineLabel ? kLine : classes_.at(label);
}

std::uint32_t SceneView::ownerOf(ObjectId object, int row) const {
  return labelOf(object) * kRowsPerOwner + static_cast<std::uint32_t>(row);
}

SceneView::Drawn SceneView::drawnOf(ObjectId object) const {
  const std::uint16_t label = labelOf(object);
  Drawn drawn;
  for (int i = 0; label != 0 && i < static_cast<int>(initial_.drawables.size()); ++i) {
    const auto index = static_cast<std::size_t>(i);
    if (initial_.drawables[index].label != label) continue;
    if (drawn.carrier < 0) drawn.first = drawn.carrier = i;
    drawn.last = i + 1;
    const bool better = sources_[index].row == 0 && sources_[static_cast<std::size_t>(drawn.carrier)].row != 0;
    if (better) drawn.carrier = i;
  }
  if (drawn.carrier >= 0) drawn.X_SB = inverse(sources_[static_cast<std::size_t>(drawn.carrier)].X_BS);
  return drawn;
}

const BodyPath& SceneView::pathOf(ObjectId robot) const {
  const auto found = std::find(robots_.begin(), robots_.end(), robot);
  return paths_[static_cast<std::size_t>(found - robots_.begin())];
}

Pose SceneView::bodyPose(ObjectId robot, int row, long frame) const {
  const BodyPath& path = pathOf(robot);
  return path.pose(row, path.shareAfter(frame));
}

SpatialMotion<double> SceneView::bodyMotion(ObjectId robot, int row, long frame) const {
  return motionOf(pathOf(robot), row, frame);
}

}  // namespace murosimf
