#pragma once

/// @file The world as cameras see it: a snapshot of everything drawn, at one moment.
///
/// Built once from the shapes of robots, free bodies and fixed objects; afterwards only poses change. A snapshot is
/// immutable while cameras look at it, so physics may go on. A shape that has a mesh is drawn as its triangles, a
/// convex hull as its faces.

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "murosimf/algorithms/collision/convex_hull.h"
#include "murosimf/algorithms/ray_scene.h"
#include "murosimf/linking/body_path.h"
#include "murosimf/linking/outside_access.h"

namespace murosimf {

/// What a label stands for.
enum class SeenKind : std::uint8_t { kTurf, kLine, kSky, kFreeBody, kRobot, kFixed };
struct SeenClass {
  SeenKind kind = SeenKind::kTurf;
  std::string path{};  ///< of the object: "ball", "robots.red.1", "goal..."; empty for ground, lines and sky
};

class SceneView {
 public:
  /// What it takes of robots: attach this when linking.
  static const OutsideAccess& robotAccess();

  SceneView(const World& world, LinkedWorld& linked, const std::vector<ObjectId>& robots,
            const std::vector<ObjectId>& free_bodies, const std::vector<ObjectId>& fixed);

  /// Writes poses as they are at the end of this frame. `scene` must be a copy of initialScene(). If it has been given
  /// room for motions, it also gets those, as means over the frame.
  void snapshot(long frame, RayScene& scene) const;
  const RayScene& initialScene() const { return initial_; }

  /// Label of everything that belongs to an object, from 1; 0 when it is not drawn. Label of an owner's row, for
  /// hiding.
  std::uint16_t labelOf(ObjectId object) const;
  /// All that is drawn, in the order of their labels.
  const std::vector<ObjectId>& labelled() const { return labelled_; }
  std::uint32_t ownerOf(ObjectId object, int row) const;
  /// What pixels of this label show.
  const SeenClass& classOf(std::uint16_t label) const;
  /// Where an object stands among the drawables of scenes, and which of them tells where its base B is.
  struct Drawn {
    int first = 0, last = 0;  ///< [first, last) belong to it
    int carrier = -1;         ///< fixed to its base, or the first one where none is; -1: nothing is drawn
    Pose X_SB;                ///< B in the carrier's frame S
  };
  Drawn drawnOf(ObjectId object) const;
  /// X_WB of a body at the end of a frame, and its twist (w; v) over the frame: world axes, of its origin.
  Pose bodyPose(ObjectId robot, int row, long frame) const;
  SpatialMotion<double> bodyMotion(ObjectId robot, int row, long frame) const;

 private:
  struct Source {  // where the pose of one drawable comes from
    int robot = -1, body = -1, row = 0;
    Pose X_BS;
  };
  const BodyPath& pathOf(ObjectId robot) const;
  SpatialMotion<double> motionOf(const BodyPath& path, int row, long frame) const;
  SpatialMotion<double> motionOf(const Source& source, const Pose& X_WS, long frame) const;
  void addShapes(const World& world, ObjectId object, const Pose& X_WB, SeenKind kind, Source source);

  RayScene initial_;
  std::vector<Source> sources_;                            // one per drawable
  std::vector<SeenClass> classes_{{SeenKind::kTurf, ""}};  // by label
  std::map<const ConvexHull*, std::shared_ptr<const TriangleMesh>> meshes_of_hulls_;
  std::vector<ObjectId> robots_, labelled_;
  std::vector<BodyPath> paths_;
  std::vector<Handle<Pose>> bodies_;
  std::vector<Handle<Vector3>> velocities_, rates_;  // as bodies_
  double frame_length_;
};

}  // namespace murosimf
