#pragma once

/// @file The bird's-eye picture of a game: a camera high beside the field, tilted towards its middle.

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "murosimf/algorithms/ray_caster.h"
#include "murosimf/simulation/canvas.h"
#include "murosimf/simulation/simulation.h"

namespace murosimf {

/// A word that hovers over a place of the world.
struct Tag {
  Vector3 p_W;
  std::string text;
  Rgb colour;
};

/// Everything that one picture shows: a copy of the world as it was at one moment.
struct OverviewShot {
  RayScene scene;
  std::vector<Tag> tags;  ///< one a robot
  std::string caption;
};

/// What to write over a robot besides its number; an index into Participants::robots. May be empty.
using TagText = std::function<std::string(int robot)>;

/// Takes shots of a simulation, between two frames.
class OverviewSource {
 public:
  explicit OverviewSource(Simulation& simulation, TagText tag_text = {});
  /// A shot with room for everything; what take() needs.
  OverviewShot emptyShot() const;
  /// Fills in poses and tags as they are now; the caption is the caller's.
  void take(OverviewShot& shot);

 private:
  Simulation& simulation_;
  TagText tag_text_;
  std::vector<Handle<Pose>> poses_;
  std::vector<Tag> tags_;
};

/// Renders shots of one size. One object a thread.
class Overview {
 public:
  /// The camera sees the whole carpet. Cost: some 0.1 s for its table of rays.
  Overview(int width, int height, const PaintedGround& ground);
  /// The picture holds until the next call. Ground shadows and antialiasing are on.
  const Picture& render(OverviewShot& shot);
  const Pose& cameraPose() const { return X_WC_; }
  const CameraModel& camera() const { return rays_.camera(); }

 private:
  RayTable rays_;
  Pose X_WC_;
  PreparedScene work_;
  Picture picture_;
};

/// The pose X_WC nearest to the field, at a fixed tilt, from which the camera sees all of the carpet and what stands on
/// it, with a margin of a few per cent and room for a caption below.
Pose overviewPose(const CameraModel& camera, const PaintedGround& ground);

/// "T 12.34  RED 1 : 0 BLUE"
std::string gameCaption(double time, int red, int blue);

/// Writes the game as it is now, 1280 x 720. @throws std::runtime_error as writePng() does.
void writeOverview(const std::filesystem::path& file, Simulation& simulation, const std::string& caption,
                   const TagText& tag_text = {});

}  // namespace murosimf
