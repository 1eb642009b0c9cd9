#include "murosimf/simulation/percept_overlay.h"

#include <fmt/format.h>

#include <algorithm>

#include "murosimf/simulation/canvas.h"
#include "murosimf/simulation/png_writer.h"

namespace murosimf {

namespace {

using client::Percept;

constexpr Rgb kBallColour{255, 60, 220}, kPostColour{255, 255, 0}, kPoleColour{0, 255, 255};
constexpr Rgb kLineColour{255, 40, 40}, kRobotColour{255, 160, 255}, kObstacleColour{255, 255, 255};

constexpr int kReadableWidth = 320;  // [px] at which large pictures are looked at among others

Rgb colourOf(Percept::Kind kind) {
  switch (kind) {
    case Percept::Kind::kBall:
      return kBallColour;
    case Percept::Kind::kPost:
      return kPostColour;
    case Percept::Kind::kPole:
      return kPoleColour;
    case Percept::Kind::kLinePoint:
      return kLineColour;
    case Percept::Kind::kRobot:
      return kRobotColour;
    case Percept::Kind::kObstacle:
      return kObstacleColour;
  }
  return Rgb{};
}

std::string_view nameOf(Percept::Kind kind) {
  switch (kind) {
    case Percept::Kind::kBall:
      return "BALL";
    case Percept::Kind::kPost:
      return "POST";
    case Percept::Kind::kPole:
      return "POLE";
    case Percept::Kind::kLinePoint:
      return "";
    case Percept::Kind::kRobot:
      return "ROBOT";
    case Percept::Kind::kObstacle:
      return "OBSTACLE";
  }
  return "";
}

double uprightHeight(const Percept& p) { return std::max(12.0, 4 * p.radius); }

/// The foot: a bar as wide as the thing, and an upright on it.
void drawFoot(const Percept& p, Canvas& canvas) {
  const Rgb colour = colourOf(p.kind);
  const double half_width = std::max(2.0, p.radius);
  canvas.line({p.u - half_width, p.v}, {p.u + half_width, p.v}, colour);
  canvas.line({p.u - half_width, p.v + 1}, {p.u + half_width, p.v + 1}, colour);
  canvas.line({p.u, p.v}, {p.u, p.v - uprightHeight(p)}, colour);
}

void drawMark(const Percept& p, Canvas& canvas) {
  if (p.kind == Percept::Kind::kLinePoint) {
    canvas.cross({p.u, p.v}, 2, kLineColour);
  } else if (p.kind == Percept::Kind::kBall) {
    canvas.circle({p.u, p.v}, p.radius, kBallColour);
    canvas.circle({p.u, p.v}, p.radius + 1, kBallColour);
    canvas.cross({p.u, p.v}, 2, kBallColour);
  } else {
    drawFoot(p, canvas);
  }
}

void drawLabel(const Percept& p, Canvas& canvas) {
  if (p.kind == Percept::Kind::kLinePoint) return;
  const std::string words = fmt::format("{} {:.2f}", nameOf(p.kind), p.distance);
  const int scale = std::max(1, canvas.width() / kReadableWidth);
  // Robots' labels on top: the ball often lies at their feet.
  const double below = p.kind == Percept::Kind::kBall    ? p.radius + 4
                       : p.kind == Percept::Kind::kRobot ? -uprightHeight(p) - Canvas::textHeight(scale) - 3
                                                         : 6;
  canvas.label({p.u - 0.5 * Canvas::textWidth(words, scale), p.v + below}, words, colourOf(p.kind), scale);
}

std::vector<std::size_t> cameraCounts(const ControlLoop& control) {
  std::vector<std::size_t> counts;
  for (int i = 0; i < control.robotCount(); ++i) counts.push_back(control.robot(i).cameraCount());
  return counts;
}

Percept::Kind perceptOf(client::ThingKind kind) {
  switch (kind) {
    case client::ThingKind::kBall:
      return Percept::Kind::kBall;
    case client::ThingKind::kRobot:
      return Percept::Kind::kRobot;
    case client::ThingKind::kPost:
      return Percept::Kind::kPost;
    case client::ThingKind::kPole:
      return Percept::Kind::kPole;
    case client::ThingKind::kObstacle:
      return Percept::Kind::kObstacle;
    case client::ThingKind::kLine:
      break;
  }
  return Percept::Kind::kLinePoint;
}

/// A kind arrives by itself, so what was found of others in looks before stays.
void keepSights(const client::CameraSights& sights, const client::ControlReport& report, KeptPercepts& kept) {
  const Percept::Kind kind = perceptOf(sights.kind);
  kept.time = std::max(kept.time, sights.time);
  kept.activity = report.activity;
  std::erase_if(kept.percepts, [&](const Percept& p) { return p.kind == kind; });
  std::copy_if(report.percepts.begin(), report.percepts.end(), std::back_inserter(kept.percepts),
               [&](const Percept& p) { return p.camera == sights.camera && p.kind == kind; });
}

/// In the place of the picture of a camera that takes none.
Picture plainPicture(const CameraModel& camera) {
  Picture picture;
  picture.has_depth = picture.has_label = false;
  picture.resize(camera.width, camera.height);
  Canvas(picture).fill({0, 0}, {camera.width - 1.0, camera.height - 1.0}, {46, 50, 56});
  return picture;
}

std::string captionOf(const std::string& camera, const KeptPercepts& kept) {
  return fmt::format("{}  T {:.2f}  {}", camera, kept.time, kept.activity);
}

}  // namespace

PerceptKeeper::PerceptKeeper(const ControlLoop& control) : PerceptKeeper(cameraCounts(control)) {}

PerceptKeeper::PerceptKeeper(const std::vector<std::size_t>& camera_counts) {
  for (const std::size_t count : camera_counts) robots_.emplace_back().cameras.resize(count);
}

void PerceptKeeper::onSensors(int robot, long) {
  // The robot's last task is over here and the next one has not begun, so its words may be taken over.
  Robot& r = robots_[static_cast<std::size_t>(robot)];
  r.shown_activity = r.last_activity;
}

void PerceptKeeper::onStep(int robot, long, const client::SensorFrame& sensors, const ControlledRobot&,
                           const client::ControlReport& report) {
  keep(robot, sensors, report);
}

void PerceptKeeper::keep(int robot, const client::SensorFrame& sensors, const client::ControlReport& report) {
  Robot& r = robots_[static_cast<std::size_t>(robot)];
  r.last_activity = report.activity;
  for (const client::CameraPicture& picture : sensors.pictures) {
    KeptPercepts& kept = r.cameras[static_cast<std::size_t>(picture.camera)];
    kept.time = picture.time;
    kept.activity = report.activity;
    kept.percepts.clear();
    std::copy_if(report.percepts.begin(), report.percepts.end(), std::back_inserter(kept.percepts),
                 [&](const Percept& p) { return p.camera == picture.camera; });
  }
  for (const client::CameraSights& sights : sensors.sights)
    keepSights(sights, report, r.cameras[static_cast<std::size_t>(sights.camera)]);
}

const KeptPercepts& PerceptKeeper::of(int robot, std::size_t camera) const {
  return robots_[static_cast<std::size_t>(robot)].cameras[camera];
}

void drawPercepts(std::span<const Percept> percepts, Picture& picture) {
  Canvas canvas(picture);
  for (const Percept& p : percepts) drawMark(p, canvas);
  for (const Percept& p : percepts) drawLabel(p, canvas);
}

Picture cameraPicture(const ControlledRobot& robot, std::size_t camera, std::span<const Percept> percepts) {
  const bool takes_pictures = camera < robot.cameras.size() && robot.cameras[camera] != nullptr;
  Picture picture = takes_pictures ? robot.cameras[camera]->picture() : plainPicture(robot.oracles[camera]->model());
  drawPercepts(percepts, picture);
  return picture;
}

std::vector<std::filesystem::path> writeCameraPictures(const std::filesystem::path& directory, Simulation& simulation,
                                                       const PerceptKeeper& keeper) {
  std::vector<std::filesystem::path> files;
  ControlLoop* control = simulation.control();
  if (control == nullptr) return files;
  control->finish();
  for (int i = 0; i < control->robotCount(); ++i) {
    const ControlledRobot& robot = control->robot(i);
    for (std::size_t k = 0; k < robot.cameraCount(); ++k) {
      if (robot.camera(k) == nullptr || keeper.of(i, k).time < 0) continue;
      const std::string& name = robot.camera(k)->path();
      Picture picture = cameraPicture(robot, k, keeper.of(i, k).percepts);
      Canvas(picture).caption(captionOf(name, keeper.of(i, k)));
      files.push_back(directory / (name + ".png"));
      writePng(files.back(), picture);
    }
  }
  return files;
}

}  // namespace murosimf
