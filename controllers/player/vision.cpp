#include "player/vision.h"

#include <stdexcept>
#include <utility>

#include "player/vision/ball_finder.h"
#include "player/vision/obstacle_finder.h"
#include "player/vision/robot_finder.h"

namespace murosimf::controllers {
namespace {

/// Learns the carpet's brightness and share of green from every 16th pixel (8th of a small picture) that is greener
/// than anything else on a field. With too few of them the last picture's values stay.
void learnColours(const PictureView& view, FieldColours& colours) {
  const int spacing = view.width >= 480 ? 16 : 8;
  int count = 0;
  double level = 0, share = 0;
  for (int v = spacing / 2; v < view.height; v += spacing) {
    for (int u = spacing / 2; u < view.width; u += spacing) {
      const std::uint8_t* p = view.pixel(u, v);
      const int excess = greenExcess(p[0], p[1], p[2]), sum = p[0] + p[1] + p[2];
      if (excess < 10 || 8 * excess < sum) continue;
      ++count;
      level += p[1];
      share += static_cast<double>(excess) / sum;
    }
  }
  if (count < 40) return;
  colours.green_level = level / count;
  colours.green_share = share / count;
  colours.derive();
}

void reserve(Percepts& out) {
  out.balls.reserve(16);
  out.posts.reserve(64);
  out.poles.reserve(64);
  out.lines.reserve(128);
  out.robots.reserve(64);
  out.obstacles.reserve(64);
  out.drawn.reserve(384);
}

/// Insertion sort: a handful of balls at most, and std::stable_sort would allocate.
void sortByDeviation(std::vector<BallPercept>& balls) {
  for (std::size_t i = 1; i < balls.size(); ++i) {
    for (std::size_t j = i; j > 0 && balls[j].deviation < balls[j - 1].deviation; --j)
      std::swap(balls[j], balls[j - 1]);
  }
}

}  // namespace

void Vision::start(const client::RobotDescription& robot) {
  field_ = robot.field;
  obstacle_radius_ = robot.course.obstacle_radius;
  landmarks_.start();
  cameras_.clear();
  cameras_.resize(robot.cameras.size());
  for (std::size_t i = 0; i < cameras_.size(); ++i) {
    Camera& camera = cameras_[i];
    camera.description = robot.cameras[i];
    camera.rays.start(camera.description);
    camera.grid.start(camera.description.width, camera.description.height);
    camera.lines.start(camera.description.width, camera.description.height);
    camera.colours.derive();
  }
}

void Vision::process(const client::SensorFrame& frame, std::span<const Pose> X_RC, Percepts& out) {
  out.clear();
  reserve(out);
  for (const client::CameraPicture& picture : frame.pictures) {
    const auto index = static_cast<std::size_t>(picture.camera);
    if (picture.camera < 0 || index >= cameras_.size() || index >= X_RC.size()) continue;
    look(picture, X_RC[index], out);
  }
  sortByDeviation(out.balls);
}

void Vision::look(const client::CameraPicture& picture, const Pose& X_RC, Percepts& out) {
  Camera& camera = cameras_[static_cast<std::size_t>(picture.camera)];
  const client::CameraDescription& d = camera.description;
  if (picture.width != d.width || picture.height != d.height) return;
  if (picture.format != client::PixelFormat::kRgb)
    throw std::invalid_argument("the player's vision wants pictures in the format rgb");
  if (picture.bytes.size() < static_cast<std::size_t>(3 * d.width * d.height)) return;
  PictureView view{picture.bytes.data(), picture.camera, d.width, d.height, &d, &camera.rays, camera.colours, X_RC};
  learnColours(view, camera.colours);
  view.colours = camera.colours;
  camera.grid.fill(view);
  findBalls(view, camera.grid, field_.ball_radius, out);
  landmarks_.find(view, camera.grid, field_, out);
  camera.lines.find(view, field_.line_width, out);
  findRobots(view, camera.grid, out);
  if (obstacle_radius_ > 0) findObstacles(view, camera.grid, obstacle_radius_, out);
}

void Vision::archive(client::StateArchive& archive) {
  for (Camera& camera : cameras_) archive(camera.colours);
}

}  // namespace murosimf::controllers
