#include "murosimf/bench/walking_world.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "murosimf/modules/all_modules.h"
#include "murosimf/scene/scenario_reader.h"
#include "murosimf/soccer/field.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

namespace {

constexpr double kSpacing = 1.57;  // [m] 22 robots on 9 m x 6 m: 2.45 m^2 each
constexpr double kMargin = 4;      // [m] between robots and goals
constexpr double kLeastRing = 3;   // [m] radius
constexpr double kOnRing = 0.5;    // [m] from one robot on the ring to the next
constexpr double kStiffness = 30;  // of the commands; servos take their own gains unless told [N m/rad]

/// Control software that looks at nothing.
class Replay final : public client::ControlSoftware {
 public:
  Replay(const RecordedWalk& walk, long delay) : walk_(walk), step_(-delay) {}
  void start(const client::RobotDescription&) override {}
  void step(const client::SensorFrame&, client::CommandFrame& commands) override {
    const controllers::JointAngles& q = walk_.at(step_++);
    for (std::size_t j = 0; j < q.size(); ++j) commands.joints[j] = {q[j], 0, 0, kStiffness, 0};
  }
  const client::ControlReport& report() const override { return report_; }
  void archive(client::StateArchive& archive) override { archive(step_); }

 private:
  const RecordedWalk& walk_;
  long step_;
  client::ControlReport report_;
};

/// The scenario with one robot.
std::string scenarioOf(const WalkingSettings& settings) {
  const bool sees = settings.eye != Eye::kNone;
  return fmt::format(
      "[simulation]\nframe = {}\nlanes = {}\nthreads = {}\ncontrol_period = {}\ncontrol_delay = {}\n"
      "[field]\npreset = \"2025_kid\"\n[referee]\nenabled = false\n"
      "[robots.red.1]\nfile = \"robots/ks21.urdf\"\nlevel = \"{}\"\ncontrol = \"{}\"\npose = [0, 0, 0]\n"
      "[robots.red.1.cameras]\nhead = {}\nchest = \"none\"\n",
      settings.frame, settings.lanes, settings.threads, kReplayPeriod, kReplayPeriod, settings.level,
      sees ? "replay" : "none", sees ? "{period = 0.05, noise = 0}" : "\"none\"");
}

/// Rows and columns about the centre, all heading for +x.
std::vector<PlanarPose> onField(int robots, FieldSettings& field) {
  const int rows = 2 * std::max(1, static_cast<int>(std::lround(std::sqrt(robots / 1.5) / 2)));
  const int columns = (robots + rows - 1) / rows;
  std::vector<PlanarPose> poses;
  for (int i = 0; i < robots; ++i)
    poses.push_back({(i / rows - 0.5 * (columns - 1)) * kSpacing, (i % rows - 0.5 * (rows - 1)) * kSpacing, 0});
  field.length.value = std::max(*field.length, columns * kSpacing + 2 * kMargin);
  field.width.value = std::max(*field.width, rows * kSpacing);
  return poses;
}

/// About the ball, heading for it.
std::vector<PlanarPose> onRing(int robots, FieldSettings& field) {
  const double radius = std::max(kLeastRing, 1 + robots * kOnRing / (2 * kPi));
  std::vector<PlanarPose> poses;
  for (int i = 0; i < robots; ++i) {
    const double angle = 2 * kPi * (i + 0.5) / robots;
    poses.push_back({radius * std::cos(angle), radius * std::sin(angle), angle + kPi});
  }
  field.length.value = std::max(*field.length, 2 * (radius + kMargin));
  field.width.value = std::max(*field.width, 2 * radius);
  return poses;
}

/// As wide an angle as this lens sees, without distortion.
CameraModel straightened(const CameraModel& lens) {
  const double left = -unproject(lens, {-0.5, lens.cy}).x, right = unproject(lens, {lens.width - 0.5, lens.cy}).x;
  return makePinholeCamera(lens.width, lens.height, std::atan2(left, 1.0) + std::atan2(right, 1.0));
}

void straightenCameras(World& world, const std::vector<ObjectId>& robots) {
  for (const ObjectId robot : robots) {
    const ObjectId camera = world.find(world.path(robot) + ".head");
    world.set(camera, kCameraModel, straightened(*world.find(camera, kCameraModel)));
  }
}

/// The ray caster with depths, and as many pixels at once as blocks have lanes.
PictureMakers makersFor(int lanes) {
  PictureMakerKind kind = *rayCasterKind();
  kind.make = [lanes, make = kind.make](PictureWish wish, const PaintedGround& ground) {
    wish.depth = true;
    wish.lanes = lanes == 8 ? CastLanes::kSixteen : lanes == 4 ? CastLanes::kEight : CastLanes::kWidest;
    return make(wish, ground);
  };
  return {{kind.name, std::make_shared<const PictureMakerKind>(kind)}};
}

}  // namespace

/// The golden ratio spreads any number of robots.
long delayOf(const RecordedWalk& walk, int robot) {
  const double turns = 0.6180339887498949 * robot;
  return static_cast<long>((turns - std::floor(turns)) * static_cast<double>(walk.stride()));
}

std::unique_ptr<Simulation> buildWalkingWorld(const RecordedWalk& walk, const WalkingSettings& settings, int robots) {
  Diagnostics diagnostics;
  auto scene = readScenarioText(scenarioOf(settings), "table.toml", {}, diagnostics);
  if (!scene) throw std::runtime_error(diagnostics.text());
  const std::vector<PlanarPose> poses =
      settings.eye == Eye::kNone ? onField(robots, scene->field) : onRing(robots, scene->field);
  scene->robots.assign(poses.size(), scene->robots.front());  // more than there are jersey numbers
  for (std::size_t i = 0; i < poses.size(); ++i) {
    scene->robots[i].number = static_cast<int>(i) + 1;
    scene->robots[i].pose.value = poses[i];
  }
  WorldBuilder builder(*scene, diagnostics);
  builder.addFixed(addField(builder.world(), fieldDescription(*scene), FieldLook{}));
  if (settings.eye == Eye::kStraight) straightenCameras(builder.world(), builder.participants().robots);
  int next = 0;
  const auto program = [&] { return std::make_unique<Replay>(walk, delayOf(walk, next++)); };
  auto simulation = builder.link(allModules(), {{"replay", program}}, makersFor(settings.lanes));
  if (simulation == nullptr) throw std::runtime_error(diagnostics.text());
  return simulation;
}

}  // namespace murosimf
