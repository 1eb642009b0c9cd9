#pragma once

/// @file What the team knows together: its ball, where mates stand, and who should go for the ball.

#include <array>
#include <span>

#include "murosimf/control/client/robot_description.h"
#include "murosimf/control/client/robot_frames.h"
#include "murosimf/control/client/state_archive.h"
#include "plane.h"

namespace murosimf::controllers {

/// Is nobody of the mates nearer to the ball (by cost_to_ball [s])? Equal costs: the lower jersey number goes.
bool cheapestToBall(int own_number, double own_cost, std::span<const client::TeamMessage> messages);

/// The ball that mates have reported by radio, in the team's own frame.
///
/// Keeps the last message of every mate. A report weighs  exp(-age / 1 s) / (s0^2 + (k d)^2),  d: the sender's
/// distance from the ball. The heaviest report is right about where the ball is; others within 0.7 m of it are
/// averaged in.
/// Where somebody who knows tells where a mate stands (level "oracle" of localisation), that counts in the place of
/// what the mate believes: the ball that it reports is moved along, for it has seen it from where it is.
class TeamBall {
 public:
  static constexpr int kLargestNumber = 8;

  void start(const client::RobotDescription& robot);
  /// Takes in the messages of one sensor frame and lets dt pass since the frame before. told: poses of mates that were
  /// told in this frame, at this time [s].
  void observe(std::span<const client::TeamMessage> messages, double dt, std::span<const client::ToldPose> told = {},
               double time = 0);
  bool known() const;      ///< some mate has seen it within the last 4 s
  Point position() const;  ///< in F [m]; (0, 0) when not known
  double age() const;      ///< of the best report [s]
  /// The last messages that are not older than 1 s, for cheapestToBall().
  std::span<const client::TeamMessage> freshMessages() const { return std::span(fresh_).first(fresh_count_); }
  /// Where mates stand, as they were told or have said within the last second, in F [m].
  std::span<const Point> mates() const { return std::span(mates_).first(mate_count_); }
  void archive(client::StateArchive& archive);

 private:
  struct Report {
    client::TeamMessage message;
    double since = 1e9;  ///< it came [s]
    PlanarPose told;
    double told_age = 1e9;  ///< [s]
    double weight() const;
    double age() const { return message.ball_age + since; }
    void take(const client::TeamMessage& heard);
    void archive(client::StateArchive& archive);
  };
  const Report* best() const;
  Report* reportOf(int number);
  void collectFresh();

  std::array<Report, kLargestNumber> reports_{};  ///< by number - 1
  std::array<client::TeamMessage, kLargestNumber> fresh_{};
  std::size_t fresh_count_ = 0;
  std::array<Point, kLargestNumber> mates_{};
  std::size_t mate_count_ = 0;
  int own_number_ = 0;
};

}  // namespace murosimf::controllers
