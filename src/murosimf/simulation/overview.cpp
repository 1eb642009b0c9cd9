#include "murosimf/simulation/overview.h"

#include <fmt/format.h>

#include <algorithm>

#include "murosimf/simulation/png_writer.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

namespace {

constexpr double kViewAngle = 0.70;  // between left and right edge [rad]: long, for little perspective
constexpr double kTilt = 0.96;       // of the line of sight below the horizon [rad]
constexpr double kTallest = 0.6;     // what stands on the far edge: poles [m]
constexpr double kAboveHead = 0.38;  // of a tag above the base of a robot [m]
constexpr double kMargin = 0.02;     // of the picture's size

/// Pixels a dot of tags, and of the caption, in a picture of this height.
int tagScale(int height) { return std::max(1, height / 280); }
int captionScale(int height) { return std::max(1, (height + 60) / 300); }

/// Where the camera stands when it is this far from what it looks at.
Pose poseAt(double distance, double target_y) {
  const SinCos<double> tilt = sincos(kTilt);
  return lookAt({0, target_y - distance * tilt.cos, distance * tilt.sin}, {0, target_y, 0});
}

/// Corners of the carpet, and the tops of what stands on its far edge.
std::vector<Vector3> outline(const PaintedGround& ground) {
  std::vector<Vector3> points;
  for (const double x : {-ground.half_length, ground.half_length}) {
    points.push_back({x, -ground.half_width, 0});
    points.push_back({x, ground.half_width, 0});
    points.push_back({x, 0.85 * ground.half_width, kTallest});
  }
  return points;
}

/// Lowest and highest row of points in the picture; nothing when one is not seen or too near the sides.
std::optional<std::pair<double, double>> rowsOf(const CameraModel& camera, const Pose& X_WC,
                                                const std::vector<Vector3>& points) {
  double top = camera.height, bottom = 0;
  for (const Vector3& p_W : points) {
    const auto place = projectPoint(camera, applyInverse(X_WC, p_W));
    if (!place || place->u < kMargin * camera.width || place->u > (1 - kMargin) * camera.width) return std::nullopt;
    top = std::min(top, place->v);
    bottom = std::max(bottom, place->v);
  }
  return std::pair{top, bottom};
}

Rgb teamColour(const std::string& path) {
  return path.find(".red.") != std::string::npos ? Rgb{255, 150, 215} : Rgb{140, 235, 255};
}

std::string lastName(const std::string& path) { return path.substr(path.rfind('.') + 1); }

void drawTags(const OverviewShot& shot, const CameraModel& camera, const Pose& X_WC, Canvas& canvas) {
  const int scale = tagScale(camera.height);
  for (const Tag& tag : shot.tags) {
    const auto place = projectPoint(camera, applyInverse(X_WC, tag.p_W));
    if (!place || !isInPicture(camera, *place)) continue;
    canvas.label({place->u - 0.5 * Canvas::textWidth(tag.text, scale), place->v - Canvas::textHeight(scale)}, tag.text,
                 tag.colour, scale);
  }
}

}  // namespace

Pose overviewPose(const CameraModel& camera, const PaintedGround& ground) {
  const std::vector<Vector3> points = outline(ground);
  const double top = kMargin * camera.height;
  const double bottom = (1 - kMargin) * camera.height - Canvas::captionHeight(captionScale(camera.height));
  // The nearest distance at which all fits, the picture's middle of rows kept on the middle of what is seen.
  double target_y = 0, distance = 0.5 * (ground.half_length + ground.half_width);
  for (int step = 0; step < 400; ++step, distance *= 1.02) {
    auto rows = rowsOf(camera, poseAt(distance, target_y), points);
    for (int shift = 0; rows && shift < 4; ++shift) {
      const double off = 0.5 * (rows->first + rows->second) - 0.5 * (top + bottom);  // > 0: seen too low
      const double metres_a_row = distance / (camera.fy * sincos(kTilt).sin);
      target_y -= off * metres_a_row;
      rows = rowsOf(camera, poseAt(distance, target_y), points);
    }
    if (rows && rows->first >= top && rows->second <= bottom) break;
  }
  return poseAt(distance, target_y);
}

Overview::Overview(int width, int height, const PaintedGround& ground)
    : rays_(makePinholeCamera(width, height, kViewAngle)), X_WC_(overviewPose(rays_.camera(), ground)) {
  picture_.has_depth = picture_.has_label = false;
}

const Picture& Overview::render(OverviewShot& shot) {
  CastOptions options;
  options.antialias = true;
  shot.scene.ground_shadows = true;
  castPicture(rays_, shot.scene, X_WC_, {}, options, work_, picture_);
  Canvas canvas(picture_);
  drawTags(shot, rays_.camera(), X_WC_, canvas);
  if (!shot.caption.empty()) canvas.caption(shot.caption, captionScale(picture_.height));
  return picture_;
}

OverviewSource::OverviewSource(Simulation& simulation, TagText tag_text)
    : simulation_(simulation), tag_text_(std::move(tag_text)) {
  for (const ObjectId robot : simulation.participants().robots) {
    const std::string& path = simulation.world().path(robot);
    if (!path.starts_with("robots.")) continue;  // an obstacle that can be pushed
    poses_.push_back(simulation.linked().handle(robot, kBasePose));
    tags_.push_back({{}, lastName(path), teamColour(path)});
  }
}

OverviewShot OverviewSource::emptyShot() const { return {simulation_.view().initialScene(), tags_, ""}; }

void OverviewSource::take(OverviewShot& shot) {
  simulation_.view().snapshot(simulation_.frame() - 1, shot.scene);
  for (std::size_t i = 0; i < tags_.size(); ++i) {
    shot.tags[i].p_W = poses_[i].valid() ? poses_[i].get().translation + Vector3{0, 0, kAboveHead} : Vector3{};
    shot.tags[i].text = tags_[i].text;
    if (tag_text_) shot.tags[i].text += " " + tag_text_(static_cast<int>(i));
  }
}

std::string gameCaption(double time, int red, int blue) {
  return fmt::format("T {:.2f}   RED {} : {} BLUE", time, red, blue);
}

void writeOverview(const std::filesystem::path& file, Simulation& simulation, const std::string& caption,
                   const TagText& tag_text) {
  OverviewSource source(simulation, tag_text);
  OverviewShot shot = source.emptyShot();
  source.take(shot);
  shot.caption = caption;
  Overview overview(1280, 720, shot.scene.ground);
  writePng(file, overview.render(shot));
}

}  // namespace murosimf
