#pragma once

/// @file The player API of the RoboCup Humanoid virtual season: one robot, one TCP port, one client
/// [RoboCup-Humanoid-TC/hlvs_webots, controllers/player]. docs/player_api.md tells all of it.
///
/// As control software it gives the robot's sensors to the client at the end of each port period, and the client's
/// requests to the robot. In a step, in this order:
///   free running  all requests that have come are obeyed; what is due is measured and sent
///   lock-step     what is due is measured and sent; one message of requests is waited for (DelayBudget) and obeyed
/// so that in both a request acts with the first step behind the measurements that the client had seen, and a sensor
/// that it turns on is measured one period later.

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "murosimf/control/client/control_software.h"
#include "murosimf/control/player_api/device_book.h"
#include "murosimf/control/player_api/motor_table.h"
#include "murosimf/control/player_api/network_quota.h"
#include "murosimf/control/player_api/request_reader.h"
#include "murosimf/control/player_api/sensor_schedule.h"
#include "murosimf/control/wire/delay_budget.h"
#include "murosimf/control/wire/frame_server.h"

namespace murosimf::player_api {

struct PlayerPortSettings {
  std::string host = "127.0.0.1";                    ///< address to listen on
  int port = 0;                                      ///< 0: any free one
  std::vector<std::string> allowed = {"127.0.0.1"};  ///< hosts that clients may come from
  bool lock_step = false;
  double connect_wait = 60;                             ///< lock-step: how long the start waits for the client [s]
  DelayLimits delay;                                    ///< lock-step: how long steps do
  double rendering_quota = 87.5, network_quota = 87.5;  ///< [MiB/s]
};

/// The port of a robot in the virtual season: red 10001, 10002, ..., blue 10021, 10022, ... [referee/game.json].
int usualPort(const client::RobotDescription& robot);

/// What has passed through a port.
struct PlayerPortCounts {
  ChannelCounts channel;
  long missed_answers = 0, warnings = 0;
};

class PlayerPort final : public client::ControlSoftware {
 public:
  PlayerPort(std::shared_ptr<FrameServer> server, const PlayerPortSettings& settings);
  ~PlayerPort() override;

  /// Listens.
  /// @throws client::CannotStart where it cannot listen, or where the port period is no whole number of milliseconds
  void start(const client::RobotDescription& robot) override;
  /// In lock-step waits for the client and its first requests.
  void startCameras(std::span<double> periods) override;
  std::string address() const override;
  std::vector<std::pair<std::string, double>> figures() const override;
  bool waitsForOthers() const override { return true; }
  void step(const client::SensorFrame& sensors, client::CommandFrame& commands) override;
  const client::ControlReport& report() const override { return report_; }
  /// State of motors and sensors. The client is not part of it: it must connect anew.
  void archive(client::StateArchive& archive) override;

  /// That it listens on; 0 before start().
  int port() const { return port_; }
  PlayerPortCounts counts() const;

 private:
  struct Parts;
  void listen();
  void awaitClient();
  void obeyAll(long now);
  void obey(const FrameBytes& frame, long now);
  void awaitAnswer(long asked, long now);
  bool takeAnswer(long asked, long now);
  void heedReferee(const client::GameInfo& game);
  void sendMeasurements(const client::SensorFrame& sensors, long now);
  void beginMessage(long now);
  void addMessage(bool error, const std::string& text);
  void introduce();
  void measure(const client::SensorFrame& sensors, long now);
  FrameBytes written();
  void tellCameras(std::span<double> periods) const;

  std::shared_ptr<FrameServer> server_;
  PlayerPortSettings settings_;
  client::RobotDescription robot_;
  int port_ = 0;
  long period_ = 0;  // of the port [ms]
  std::shared_ptr<FrameChannel> channel_;
  std::shared_ptr<std::atomic<bool>> open_;  // whether clients are taken; the server may outlive the port
  std::unique_ptr<Parts> parts_;
  DelayBudget budget_;
  NetworkQuota network_;
  long connection_ = 0;  // that described_ belongs to
  bool wants_surroundings_ = false, described_ = false, sent_off_ = false;
  std::vector<std::string> warnings_;
  long warning_count_ = 0;
  std::optional<client::TeamMessage> team_message_;
  std::optional<long> answered_;  // of the last requests: the time that they answer [ms]
  client::ControlReport report_;
};

}  // namespace murosimf::player_api
