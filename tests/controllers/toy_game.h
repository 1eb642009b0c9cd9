#pragma once

/// @file A small game for closed-loop tests of the player: puppets, exact percepts and a ball that feet push.
///
/// Everything is in field coordinates; blue's own frame is turned by half a turn. The ball is a thin shell that
/// slides, then rolls, and bounces off soles; goals and kick-offs are counted, balls that leave the field are put
/// back. No physics is claimed: it is there to see whether decisions lead to kicks and kicks to goals.

#include <memory>
#include <vector>

#include "player/player.h"
#include "puppet.h"

namespace murosimf::controllers {

struct ToyBall {
  Point p, v;     ///< field [m], [m/s]
  Point rolling;  ///< velocity at which it would roll as fast as it turns [m/s]
};

/// Sees what stands in the frustum of a camera, exactly.
class ExactEyes final : public PerceptSource {
 public:
  struct View {
    PlanarPose X_FR;  ///< own frame
    Point ball_F;
    std::vector<Point> robots_F;
  };
  explicit ExactEyes(const View* view) : view_(view) {}
  void start(const client::RobotDescription& robot) override { robot_ = robot; }
  void process(const client::SensorFrame& sensors, const CameraPast& past, Percepts& out) override;
  void archive(client::StateArchive&) override {}

 private:
  static bool sees(const Pose& X_RC, const Vector3& p_R, std::size_t camera);

  const View* view_;
  client::RobotDescription robot_;
};

class ToyGame {
 public:
  struct Entry {
    int team = 0;  ///< 0 red attacks +x, 1 blue
    int number = 1;
    std::string role;
    PlanarPose pose;  ///< in the team's own frame
  };
  ToyGame(const std::vector<Entry>& entries, const Point& ball);

  void step();
  void run(double seconds) {
    for (int i = 0; i < static_cast<int>(seconds * 100 + 0.5); ++i) step();
  }
  double time() const { return time_; }
  const ToyBall& ball() const { return ball_; }
  void placeBall(const Point& p) { ball_ = {p, {}, {}}, ++restarts_; }
  PlanarPose pose(std::size_t i) const;  ///< of a robot's R on the field
  const client::ControlReport& report(std::size_t i) const { return robots_[i]->player->report(); }
  Player& player(std::size_t i) { return *robots_[i]->player; }
  const client::CommandFrame& commands(std::size_t i) const { return robots_[i]->commands; }
  int score(int team) const { return score_[static_cast<std::size_t>(team)]; }
  /// Takes over the state of a game with the same robots; the players read theirs from one archive, in order.
  void continueFrom(const ToyGame& other, const client::StateArchive& players);
  bool play_on = true;  ///< goals and outs restart the game

 private:
  struct Robot {
    Entry entry;
    Puppet puppet;
    ExactEyes::View view;
    std::unique_ptr<Player> player;
    client::CommandFrame commands;
    client::TeamMessage sent;
    bool placed = true;
  };
  void stepRobot(Robot& robot);
  void keepApart(Robot& robot, const PlanarPose& before);
  void slideAndRoll();
  void rollBall(const std::vector<std::array<Pose, 2>>& soles_before);
  void touch(const Point& p, const Point& normal, double depth, const Point& surface_velocity);
  void referee();
  void kickOff(int team);

  std::vector<std::unique_ptr<Robot>> robots_;
  std::vector<PlanarPose> starts_;
  ToyBall ball_;
  double time_ = 0, wait_ = 0;
  int kickoff_team_ = 0;
  std::uint32_t restarts_ = 1;
  std::array<int, 2> score_{};
};

}  // namespace murosimf::controllers
