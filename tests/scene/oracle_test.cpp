// Cameras and localisation of level "oracle" as scenarios choose them: what is refused, what arrives and when.

#include <oneapi/tbb/global_control.h>

#include <chrono>
#include <cmath>
#include <condition_variable>
#include <mutex>

#include "scene/built_world.h"

namespace murosimf::test {
namespace {

std::vector<std::string> saidOf(const std::string& robot) { return BuiltWorld(kTwoRobots + robot).complaints(); }

void expectSaid(const std::string& robot, const std::string& start) {
  const std::vector<std::string> said = saidOf(robot);
  ASSERT_EQ(said.size(), 1U) << fmt::format("{}", fmt::join(said, "\n"));
  EXPECT_TRUE(startsWith(said[0], start)) << said[0];
}

TEST(OracleChoice, MistakesAreToldWithTheirPlace) {
  const std::string head = "[robots.red.1.cameras.head]\nmodule = \"oracle\"\n", self = "[robots.red.1.localisation]\n";
  expectSaid(head + "ball_mis = 0.1", "10:1: module oracle has no parameter \"ball_mis\"; it knows bearing_noise, ");
  EXPECT_NE(saidOf(head + "ball_mis = 0.1").at(0).find("(did you mean \"ball_miss\"?)"), std::string::npos);
  expectSaid(head + "miss = 1.5", "10:8: miss is 1.5, expected a number from 0 to 1");
  expectSaid(head + "post_delay = 11", "10:14: post_delay is 11, expected a number from 0 to 10 s");
  expectSaid(head + "line_range = \"far\"", "10:14: line_range is no number, expected a number from 0.3 to 1000 m");
  expectSaid(head + "noise = 0.1", "10:1: module oracle has no parameter \"noise\"");
  expectSaid(self + "module = \"orakel\"", "9:10: robots.red.1: unknown module \"orakel\" of localisation; expected ");
  expectSaid(self + "own_miss = 0.1", "9:1: robots.red.1: localisation \"none\" has no parameter \"own_miss\"");
  expectSaid(self + "module = \"oracle\"\nother_miss = 0.1", "10:1: module oracle has no parameter \"other_miss\"");
}

/// Of one control step, what was told; spans are copied.
struct Heard {
  struct Sights {
    int camera = 0;
    client::ThingKind kind = client::ThingKind::kBall;
    double time = 0;
    std::vector<client::SeenThing> things;
  };
  double time = 0;
  std::size_t pictures = 0;
  std::vector<Sights> sights;
  client::ToldPose own;
  std::vector<client::ToldPose> mates;
};

/// Where the programs of a game meet in each step, so that all of them run at the same time.
class MeetingPoint {
 public:
  /// Waits until so many are here. Nobody waits for long, nor again after it was in vain.
  void meet(int expected) {
    std::unique_lock lock(mutex_);
    ++arrived_;
    const long round = (arrived_ + expected - 1) / expected;
    if (arrived_ == round * expected) return all_here_.notify_all();
    const bool met =
        all_here_.wait_for(lock, std::chrono::seconds(failed_ ? 0 : 10), [&] { return arrived_ >= round * expected; });
    failed_ = failed_ || !met;
  }
  bool failed() const { return failed_; }

 private:
  std::mutex mutex_;
  std::condition_variable all_here_;
  long arrived_ = 0;
  bool failed_ = false;
};

/// Keeps what the first red robot hears.
class Listener final : public client::ControlSoftware {
 public:
  Listener(std::vector<Heard>& heard, MeetingPoint& meeting, const int& together)
      : heard_(heard), meeting_(meeting), together_(together) {}
  void start(const client::RobotDescription& robot) override { listens_ = robot.team == "red" && robot.number == 1; }
  void step(const client::SensorFrame& sensors, client::CommandFrame&) override {
    if (together_ > 1) meeting_.meet(together_);
    if (!listens_) return;
    Heard heard;
    heard.time = sensors.time, heard.pictures = sensors.pictures.size(), heard.own = sensors.own_pose;
    for (const client::CameraSights& s : sensors.sights)
      heard.sights.push_back({s.camera, s.kind, s.time, {s.things.begin(), s.things.end()}});
    heard.mates.assign(sensors.mate_poses.begin(), sensors.mate_poses.end());
    heard_.push_back(heard);
  }
  const client::ControlReport& report() const override { return report_; }
  void archive(StateArchive&) override {}

 private:
  std::vector<Heard>& heard_;
  MeetingPoint& meeting_;
  const int& together_;
  bool listens_ = false;
  client::ControlReport report_;
};

/// Robots of level oracle on a field, all of them still, the ball before red 1.
const std::string kStillRobots = R"(
[ball]
position = [0.5, 0.3]
[robots.all]
file = "robots/ks21.urdf"
level = "oracle"
control = "listener"
[robots.red.1]
pose = [-1, 0, 0]
[robots.red.2]
pose = [-2, 1, 0.5]
[robots.blue.1]
pose = [1, 0.4, {deg = 180}]
)";

struct OracleGame {
  explicit OracleGame(const std::string& more = "", const std::vector<std::string>& overrides = {})
      : scene(readGood(kStillRobots + more, overrides)) {
    Diagnostics diagnostics;
    WorldBuilder builder(scene, diagnostics);
    Landmark line;
    line.kind = SightKind::kLine, line.a = {0, -3, 0}, line.b = {0, 3, 0};
    builder.addLandmarks({line});
    simulation = builder.link(allModules(),
                              {{"listener", [this] { return std::make_unique<Listener>(heard, meeting, together); }}});
    EXPECT_EQ(diagnostics.text(), "");
  }
  void run(int frames) {
    for (int i = 0; i < frames; ++i) simulation->step();
    simulation->control()->finish();
  }
  /// What the last look of a camera found of a kind.
  std::vector<client::SeenThing> lastThings(client::ThingKind kind, int camera) const {
    std::vector<client::SeenThing> things;
    for (const Heard& step : heard) {
      for (const Heard::Sights& s : step.sights)
        if (s.kind == kind && s.camera == camera) things = s.things;
    }
    return things;
  }
  /// Where the robot's camera is now.
  Pose cameraPose(std::size_t camera) const {
    return simulation->control()->robot(0).oracles[camera]->place(simulation->view(), simulation->frame() - 1).X_WC;
  }

  Scene scene;
  MeetingPoint meeting;
  int together = 1;  ///< so many programs wait for one another in each step
  std::vector<Heard> heard;
  std::unique_ptr<Simulation> simulation;
};

TEST(Oracle, ThingsAreToldWhereTheyAre) {
  OracleGame game;
  game.run(400);
  const Vector3 ball =
      game.simulation->linked().handle(game.simulation->world().find("ball"), kBasePose).get().translation;
  int balls = 0, robots = 0;
  for (const int camera : {0, 1}) {
    const Pose X_WC = game.cameraPose(static_cast<std::size_t>(camera));
    for (const client::SeenThing& thing : game.lastThings(client::ThingKind::kBall, camera)) {
      EXPECT_LT(norm(X_WC * thing.p_C - ball), 1e-9);
      ++balls;
    }
    for (const client::SeenThing& thing : game.lastThings(client::ThingKind::kRobot, camera)) {
      EXPECT_LT(norm(X_WC * thing.p_C - Vector3{1, 0.4, 0}), 1e-9);
      EXPECT_EQ(thing.mark, "blue");
      EXPECT_EQ(thing.number, 1);
      ++robots;
    }
  }
  EXPECT_GT(balls, 0);
  EXPECT_GT(robots, 0);
  for (const Heard& step : game.heard) EXPECT_EQ(step.pictures, 0U);
}

TEST(Oracle, PartsOfALineLieOnIt) {
  OracleGame game;
  game.run(400);
  int parts = 0;
  for (const int camera : {0, 1}) {
    const Pose X_WC = game.cameraPose(static_cast<std::size_t>(camera));
    for (const client::SeenThing& thing : game.lastThings(client::ThingKind::kLine, camera)) {
      const Vector3 p = X_WC * thing.p_C, q = X_WC * thing.q_C;
      EXPECT_NEAR(p.z, 0, 1e-9);
      EXPECT_NEAR(q.z, 0, 1e-9);
      EXPECT_NEAR(p.x, 0, 1e-9);
      EXPECT_NEAR(q.x, 0, 1e-9);
      EXPECT_LE(std::max(std::fabs(p.y), std::fabs(q.y)), 3 + 1e-9);
      ++parts;
    }
  }
  EXPECT_GT(parts, 0);
}

TEST(Oracle, ARobotIsToldWhereItAndItsMatesStand) {
  OracleGame game("[teams.red]\nattacks = \"-x\"\n[teams.blue]\nattacks = \"+x\"\n");
  game.run(100);
  ASSERT_FALSE(game.heard.empty());
  for (const Heard& step : game.heard) {
    ASSERT_TRUE(step.own.valid);
    EXPECT_NEAR(step.own.pose.x, 1, 1e-3);
    EXPECT_NEAR(step.own.pose.y, 0, 1e-3);
    EXPECT_NEAR(std::fabs(step.own.pose.heading), kPi, 1e-3);
    ASSERT_EQ(step.mates.size(), 1U);
    EXPECT_EQ(step.mates[0].number, 2);
    EXPECT_NEAR(step.mates[0].pose.y, -1, 1e-3);
    EXPECT_EQ(step.own.time, step.time);
  }
}

TEST(Oracle, DelaysArriveLateEachKindByItself) {
  OracleGame game("[robots.red.1.cameras.head]\nball_delay = 0.12\n[robots.red.1.localisation]\nown_delay = 0.055\n");
  game.run(1000);
  const auto camera = [&] {
    const auto& cameras = game.simulation->control()->robot(0).port.description().cameras;
    return cameras[0].name == "head" ? 0 : 1;
  }();
  int balls = 0, lines = 0, poses = 0;
  for (const Heard& step : game.heard) {
    for (const Heard::Sights& s : step.sights) {
      if (s.camera != camera) continue;
      const double age = step.time - s.time, delay = s.kind == client::ThingKind::kBall ? 0.12 : 0;
      EXPECT_GE(age, delay - 1e-9);
      EXPECT_LT(age, delay + 0.01 - 1e-9) << "the next step of the control software";
      (s.kind == client::ThingKind::kBall ? balls : lines) += 1;
    }
    if (!step.own.valid) continue;
    EXPECT_NEAR(step.time - step.own.time, 0.06, 1e-9) << "poses are read with the sensors, every 10 ms";
    ++poses;
  }
  EXPECT_GE(balls, 15);
  EXPECT_GE(lines, 4 * 18);
  EXPECT_GE(poses, 90);
}

TEST(Oracle, PosesHaveTheirNoiseAndMisses) {
  OracleGame game("[robots.red.1.localisation]\nown_position_noise = 0.1\nown_x_bias = 0.3\nmate_miss = 0.25\n");
  game.run(10000);
  double sum = 0, squares = 0, mates = 0;
  const auto count = static_cast<double>(game.heard.size());
  for (const Heard& step : game.heard) {
    const double error = step.own.pose.x + 1;
    sum += error, squares += error * error;
    mates += static_cast<double>(step.mates.size());
  }
  const double mean = sum / count, deviation = std::sqrt(squares / count - mean * mean), four = 4 / std::sqrt(count);
  EXPECT_NEAR(mean, 0.3, four * 0.1);
  EXPECT_NEAR(deviation, 0.1, four * 0.1 * 0.71);
  EXPECT_NEAR(mates, 0.75 * count, 4 * std::sqrt(count * 0.25 * 0.75));
}

const std::string kWrong =
    "[robots.all.cameras]\nhead = {bearing_noise = 0.02, miss = 0.2, false_rate = 5, delay = 0.08}\n"
    "[robots.all.localisation]\nposition_noise = 0.1\ndelay = 0.05\n";

void expectSame(const std::vector<Heard>& a, const std::vector<Heard>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(a[i].own.pose, b[i].own.pose) << a[i].time;
    ASSERT_EQ(a[i].sights.size(), b[i].sights.size()) << a[i].time;
    for (std::size_t k = 0; k < a[i].sights.size(); ++k) {
      const auto &x = a[i].sights[k].things, &y = b[i].sights[k].things;
      ASSERT_EQ(x.size(), y.size()) << a[i].time;
      for (std::size_t j = 0; j < x.size(); ++j) ASSERT_EQ(x[j].p_C, y[j].p_C) << a[i].time;
    }
  }
}

TEST(Oracle, TellsTheSameBitsForAnyNumberOfThreads) {
  // As many workers as threads are asked for, also on a machine with fewer processors.
  const oneapi::tbb::global_control workers(oneapi::tbb::global_control::max_allowed_parallelism, 4);
  OracleGame one(kWrong, {"simulation.threads=1"}), four(kWrong, {"simulation.threads=4"});
  four.together = 3;  // all robots
  one.run(1000), four.run(1000);
  EXPECT_FALSE(four.meeting.failed()) << "the robots' programs do not run at the same time";
  expectSame(one.heard, four.heard);
}

TEST(Oracle, GoesOnFromACheckpointWithTheSameBits) {
  OracleGame through(kWrong), later(kWrong);
  through.run(523);
  StateArchive saved;
  through.simulation->archive(saved);
  through.heard.clear();
  through.run(477);
  later.simulation->start();
  StateArchive loading(saved.bytes());
  later.simulation->archive(loading);
  EXPECT_TRUE(loading.exhausted());
  later.run(477);
  expectSame(through.heard, later.heard);
}

}  // namespace
}  // namespace murosimf::test
