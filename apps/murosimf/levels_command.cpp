// murosimf levels: the same walk at every level of detail, side by side, as a table in Markdown.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>

#include "murosimf/commands.h"
#include "murosimf/modules/all_modules.h"
#include "murosimf/scene/scenario_reader.h"
#include "murosimf/scene/world_builder.h"
#include "player/body_motion.h"

namespace murosimf {

namespace {

constexpr double kStanding = 1.0;   ///< before the walk [s]
constexpr long kSamplePeriod = 10;  ///< of torques, in frames
constexpr double kStiffness = 30;   ///< of the commands; servos take their own gains unless told [N m/rad]

/// Control software that stands, then walks straight on.
class Walker final : public client::ControlSoftware {
 public:
  explicit Walker(double speed) : speed_(speed) {}
  void start(const client::RobotDescription& robot) override { period_ = robot.control_period; }
  void step(const client::SensorFrame& sensors, client::CommandFrame& commands) override {
    if (!started_) motion_.startFrom(controllers::anglesOf(sensors.joints));
    started_ = true;
    controllers::MotionRequest wish;
    if (sensors.time >= kStanding) wish = {controllers::MotionRequest::Kind::kWalk, {speed_, 0, 0}, 0};
    const Vector3 rate = rotationZ(sensors.joints[controllers::kWaistYaw].position) * sensors.angular_velocity;
    for (const client::JointReading& joint : sensors.joints) servos_feel_ = servos_feel_ || joint.torque != 0;
    const controllers::JointAngles q = motion_.step(period_, wish, {rate, sensors.specific_force}, servos_feel_);
    for (std::size_t j = 0; j < q.size(); ++j) commands.joints[j] = {q[j], 0, 0, kStiffness, 0};
  }
  const client::ControlReport& report() const override { return report_; }
  void archive(client::StateArchive& archive) override { archive(motion_, started_, servos_feel_); }

 private:
  double speed_, period_ = 0;
  controllers::BodyMotion motion_;
  client::ControlReport report_;
  bool started_ = false, servos_feel_ = false;
};

/// One row of the table: what the scenario says of the robots.
struct LevelRow {
  const char* name;
  const char* settings;
};
constexpr LevelRow kRows[] = {
    {"kinematic", "level = \"kinematic\"\n"},
    {"fast, version 1", "motion = {module = \"simplified_dynamics\", recompute = 0}\n"},
    {"fast", "level = \"fast\"\n"},
    {"fast, hunt_crossley_contact", "level = \"fast\"\ncontact = \"hunt_crossley_contact\"\n"},
    {"fast, torque_estimate", "level = \"fast\"\ntorque = \"torque_estimate\"\n"},
    {"full", "level = \"full\"\n"},
    {"full, smooth_contact", "level = \"full\"\ncontact = \"smooth_contact\"\n"},
    {"full, composite_body_dynamics", "motion = \"composite_body_dynamics\"\n"},
    {"full, runge_kutta_4", "level = \"full\"\nintegration = \"runge_kutta_4\"\n"},
    {"full, dormand_prince", "level = \"full\"\nintegration = \"dormand_prince\"\n"},
};

std::string scenarioOf(const LevelRow& row, int robots) {
  std::string text =
      "[referee]\nenabled = false\n[ball]\npresent = false\n[robots.all]\nfile = \"robots/ks21.urdf\"\n"
      "control = \"walker\"\ncameras = {head = \"none\", chest = \"none\"}\n";
  text += row.settings;
  for (int i = 0; i < robots; ++i)
    text += fmt::format("[robots.red.{}]\npose = [0, {}, 0]\n", i + 1, 3 * (i - robots / 2));
  return text;
}

/// What is measured of the first robot, and the cost of all.
struct Walk {
  double forward = 0, sideways = 0, turned = 0;  // [m], [m], [rad]
  double torque_square = 0, largest_torque = 0;  // sum over samples and joints; [N m]
  long torque_samples = 0;
  double seconds = 0;  // of the wall clock, in the stages of physics
};

double physicsSeconds(const Simulation& simulation) {
  double sum = 0;
  for (const Stage stage : {Stage::kPrescribe, Stage::kContacts, Stage::kAdvance}) {
    sum += simulation.stages().seconds(stage);
  }
  return sum;
}

void sampleTorques(const Handle<double>& torque, Walk& walk) {
  for (int j = 0; j < torque.size(); ++j) {
    const double tau = torque.get(j);
    walk.torque_square += tau * tau, ++walk.torque_samples;
    walk.largest_torque = std::max(walk.largest_torque, std::fabs(tau));
  }
}

Walk walk(Simulation& simulation, double duration) {
  const ObjectId robot = simulation.participants().robots.front();
  const auto base = simulation.linked().handle(robot, kBasePose);
  const auto torque = simulation.linked().handle(robot, kMeasuredTorque, subset::kJoints);
  const auto run = [&](double until, auto&& sample) {
    while (simulation.time() < until - 1e-9) {
      simulation.step();
      if (simulation.frame() % kSamplePeriod == 0) sample();
    }
  };
  Walk result;
  run(kStanding, [] {});
  const Pose start = base.get();
  const double seconds = physicsSeconds(simulation);
  run(kStanding + duration, [&] { sampleTorques(torque, result); });
  result.seconds = physicsSeconds(simulation) - seconds;
  const Vector3 way = applyTransposed(start.rotation, base.get().translation - start.translation);
  const Rotation3 turn = transposed(start.rotation) * base.get().rotation;
  result.forward = way.x, result.sideways = way.y, result.turned = atan2(turn.x.y, turn.x.x);
  return result;
}

std::string torqueText(const Walk& walk) {
  if (walk.torque_samples == 0) return "| |";
  return fmt::format("{:.2f} | {:.2f} |", std::sqrt(walk.torque_square / static_cast<double>(walk.torque_samples)),
                     walk.largest_torque);
}

/// Null, and told, when the row's scenario is wrong.
std::unique_ptr<Simulation> simulationOf(const LevelRow& row, const LevelsArguments& arguments) {
  Diagnostics diagnostics;
  const auto scene =
      readScenarioText(scenarioOf(row, arguments.robots), "levels.toml", {"simulation.threads=1"}, diagnostics);
  std::unique_ptr<Simulation> simulation;
  if (scene) {
    WorldBuilder builder(*scene, diagnostics);
    simulation = builder.link(allModules(), {{"walker", [&] { return std::make_unique<Walker>(arguments.speed); }}});
  }
  if (simulation == nullptr) std::fprintf(stderr, "%s", diagnostics.text().c_str());
  return simulation;
}

std::string lineOf(const LevelRow& row, const Walk& walk, const LevelsArguments& arguments) {
  const double cost = 1e6 * walk.seconds / (arguments.seconds * arguments.robots);
  return fmt::format("| {} | {:.2f} | {:.2f} | {:.1f} | {} {:.0f} |", row.name, walk.forward, walk.sideways,
                     walk.turned * 180 / kPi, torqueText(walk), cost);
}

}  // namespace

int printLevels(const LevelsArguments& arguments) {
  std::puts(
      "| level of detail | forward [m] | sideways [m] | turned [deg] | torque, mean [N m] | largest [N m] | cost [us] "
      "|");
  std::puts("|---|---|---|---|---|---|---|");
  for (const LevelRow& row : kRows) {
    const std::unique_ptr<Simulation> simulation = simulationOf(row, arguments);
    if (simulation == nullptr) return kWrongInput;
    const Walk result = walk(*simulation, arguments.seconds);
    simulation->control()->finish();
    std::puts(lineOf(row, result, arguments).c_str());
    std::fflush(stdout);
  }
  return 0;
}

}  // namespace murosimf
