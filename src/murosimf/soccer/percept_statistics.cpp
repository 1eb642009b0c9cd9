#include "murosimf/soccer/percept_statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "murosimf/soccer/label_blob.h"

namespace murosimf {

namespace {

constexpr double kSmallestDistance = 0.01;  // that a relative error refers to [m]

PlanarPose planar(const Pose& X) { return {X.translation.x, X.translation.y, atan2(X.rotation.x.y, X.rotation.x.x)}; }

double share(long part, long whole) {
  return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : std::numeric_limits<double>::quiet_NaN();
}

void fillShares(PerceptResult& r) {
  r.recall = share(r.ball_found, r.pictures_with_ball);
  r.precision = share(r.ball_percepts_right, r.ball_percepts);
  r.valid_share = share(r.valid_steps, r.playing_steps);
}

void addCounts(PerceptResult& sum, const PerceptResult& r) {
  sum.pictures += r.pictures;
  sum.pictures_with_ball += r.pictures_with_ball;
  sum.ball_found += r.ball_found;
  sum.ball_percepts += r.ball_percepts;
  sum.ball_percepts_right += r.ball_percepts_right;
  sum.playing_steps += r.playing_steps;
  sum.valid_steps += r.valid_steps;
}

void append(std::vector<float>& all, const Samples& samples) {
  all.insert(all.end(), samples.kept().begin(), samples.kept().end());
}

}  // namespace

PerceptStatistics::PerceptStatistics(const MatchSettings& match, Simulation& simulation) {
  if (match.ball.valid()) {
    ball_ = simulation.linked().handle(match.ball, kBasePose);
    ball_label_ = simulation.view().labelOf(match.ball);
    ball_radius_ = match.field.ball_radius;
  }
  if (simulation.control() == nullptr) return;
  accounts_.resize(static_cast<std::size_t>(simulation.control()->robotCount()));
  for (std::size_t i = 0; i < accounts_.size(); ++i) {
    const RobotPort& port = simulation.control()->robot(static_cast<int>(i)).port;
    accounts_[i].path = BodyPath(simulation.linked(), port.robot());
    accounts_[i].robot = accounts_[i].counts.robot = port.robot();
    accounts_[i].attacks_positive_x = port.description().attacks_positive_x;
  }
}

void PerceptStatistics::onSensors(int robot, long frame) {
  Account& account = accounts_[static_cast<std::size_t>(robot)];
  const Pose X_WB = account.path.pose(0, account.path.shareAfter(frame));
  account.truth = turnedForTeam(planar(X_WB), account.attacks_positive_x);
  account.kicks_before = account.kicks;
  if (!ball_.valid()) return;
  const Vector3 way = ball_.get().translation - X_WB.translation;
  account.ball_distance = sqrt(way.x * way.x + way.y * way.y);
}

void PerceptStatistics::onStep(int robot, long, const client::SensorFrame& sensors, const ControlledRobot& controlled,
                               const client::ControlReport& report) {
  Account& account = accounts_[static_cast<std::size_t>(robot)];
  account.kicks = report.kicks_started;
  if (ball_label_ != 0) {
    for (const client::CameraPicture& picture : sensors.pictures) {
      const RobotCamera& camera = *controlled.cameras[static_cast<std::size_t>(picture.camera)];
      judge(account, ballIn(camera), picture.camera, report);
    }
    for (const client::CameraSights& sights : sensors.sights) {
      if (sights.kind != client::ThingKind::kBall) continue;
      const OracleCamera& camera = *controlled.oracles[static_cast<std::size_t>(sights.camera)];
      judge(account, ballIn(camera), sights.camera, report);
    }
  }
  if (sensors.game.phase == client::GamePhase::kPlaying) checkPose(account, report);
}

PerceptStatistics::ShownBall PerceptStatistics::ballIn(const RobotCamera& camera) const {
  const LabelBlob blob = findLabel(camera.picture(), ball_label_);
  return {blob.pixels > 0, blob.pixels >= kVisiblePixels, blob.u, blob.v, blob.radius()};
}

PerceptStatistics::ShownBall PerceptStatistics::ballIn(const OracleCamera& camera) const {
  for (const ArrivedSights& arrived : camera.arrived()) {
    if (arrived.kind != SightKind::kBall || arrived.truth.empty()) continue;
    const Vector3& p_C = arrived.truth[0].p_C;
    const auto place = projectPoint(camera.model(), p_C);
    if (place) return {true, true, place->u, place->v, camera.model().fx * ball_radius_ / p_C.z};
  }
  return {};
}

void PerceptStatistics::judge(Account& account, const ShownBall& ball, int camera,
                              const client::ControlReport& report) {
  const double tolerance = std::max(kMatchPixels, kMatchRadii * ball.radius);
  PerceptResult& counts = account.counts;
  bool found = false;
  for (const client::Percept& percept : report.percepts) {
    if (percept.kind != client::Percept::Kind::kBall || percept.camera != camera) continue;
    ++counts.ball_percepts;
    const double u = percept.u - ball.u, v = percept.v - ball.v;
    if (!ball.shown || u * u + v * v > tolerance * tolerance) continue;
    ++counts.ball_percepts_right;
    found = true;
    account.distance.add(std::fabs(percept.distance - account.ball_distance) /
                         std::max(account.ball_distance, kSmallestDistance));
  }
  ++counts.pictures;
  if (!ball.visible) return;
  ++counts.pictures_with_ball;
  counts.ball_found += found ? 1 : 0;
}

void PerceptStatistics::checkPose(Account& account, const client::ControlReport& report) {
  PerceptResult& counts = account.counts;
  ++counts.playing_steps;
  if (!report.pose_valid) return;
  if (counts.valid_steps++ % kPoseStride != 0) return;
  const double x = report.pose.x - account.truth.x, y = report.pose.y - account.truth.y;
  account.position.add(sqrt(x * x + y * y));
  account.heading.add(std::fabs(wrapAngle(report.pose.heading - account.truth.heading)));
}

std::vector<PerceptResult> PerceptStatistics::results() const {
  std::vector<PerceptResult> results;
  for (const Account& account : accounts_) {
    PerceptResult r = account.counts;
    fillShares(r);
    r.distance_error_median = percentile(account.distance.kept(), 0.5);
    r.position_median = percentile(account.position.kept(), 0.5);
    r.position_90 = percentile(account.position.kept(), 0.9);
    r.heading_median = percentile(account.heading.kept(), 0.5);
    r.heading_90 = percentile(account.heading.kept(), 0.9);
    results.push_back(r);
  }
  return results;
}

PerceptResult PerceptStatistics::allTogether() const {
  PerceptResult sum;
  std::vector<float> distance, position, heading;
  for (const Account& account : accounts_) {
    addCounts(sum, account.counts);
    append(distance, account.distance);
    append(position, account.position);
    append(heading, account.heading);
  }
  fillShares(sum);
  sum.distance_error_median = percentile(distance, 0.5);
  sum.position_median = percentile(position, 0.5);
  sum.position_90 = percentile(position, 0.9);
  sum.heading_median = percentile(heading, 0.5);
  sum.heading_90 = percentile(heading, 0.9);
  return sum;
}

void PerceptStatistics::Account::archive(StateArchive& archive) {
  archive(truth, ball_distance, kicks, kicks_before, counts, distance, position, heading);
}

void PerceptStatistics::archive(StateArchive& archive) {
  for (Account& account : accounts_) archive(account);
}

}  // namespace murosimf
