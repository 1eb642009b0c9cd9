#pragma once

/// @file Motion firmware and drivers of a robot run unchanged against simulated servos: a program that connects the
/// robot's joints with a bus of servos on a pseudo-terminal.
///
/// A thread of its own reads questions from the terminal and answers them from the servos' registers in wall-clock
/// time, from the first sensor frame on. A step writes what is sensed into the registers and turns what they hold into
/// joint commands; it waits for nobody but while a packet is followed, some microseconds.
/// Lock step  With lock_step a step waits until goals have been written since the last step took them, at most
///            `patience`; steps that waited in vain may cost 1 s in 25 s of simulated time, then no step waits until
///            they are that long ago. It goes on with the last goals, and counts it.
/// docs/servo_bus.md tells how to use it and what differs from servos of metal.

#include <atomic>
#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "murosimf/control/client/control_software.h"
#include "murosimf/control/servo_bus/bus.h"
#include "murosimf/control/servo_bus/imu_board.h"
#include "murosimf/control/servo_bus/packet_reader.h"
#include "murosimf/control/servo_bus/pseudo_terminal.h"
#include "murosimf/control/servo_bus/servo.h"

namespace murosimf::servo_bus {

struct ServoBusCounts {
  std::uint64_t packets = 0;       ///< that were followed
  std::uint64_t damaged = 0;       ///< whose checksum was wrong
  std::uint64_t lost_bytes = 0;    ///< of answers that nobody read in time
  std::uint64_t missed_steps = 0;  ///< lock step: that went on without new goals
};

class ServoBus final : public client::ControlSoftware {
 public:
  /// @throws std::invalid_argument  settings that are out of range or contradict one another: what was found, what was
  ///         expected
  explicit ServoBus(ServoBusSettings settings);
  ~ServoBus() override;

  /// Opens the terminal. @throws client::CannotStart for a joint or an IMU that the robot lacks, or where the system or
  /// PseudoTerminal refuses
  void start(const client::RobotDescription& robot) override;
  bool waitsForOthers() const override { return settings_.lock_step; }
  void step(const client::SensorFrame& sensors, client::CommandFrame& commands) override;
  /// The link's path, as the settings have it.
  std::string address() const override;
  std::vector<std::pair<std::string, double>> figures() const override;
  const client::ControlReport& report() const override { return report_; }
  void archive(StateArchive& archive) override;

  ServoBusCounts counts() const;
  /// The terminal; null before start().
  const PseudoTerminal* terminal() const { return terminal_.get(); }

 private:
  struct Actuator {
    Servo servo;
    std::size_t device = 0, joint = 0;
  };
  struct Board {
    ImuBoard imu;
    std::size_t device = 0, number = 0;
  };
  class Turn;  // of a step to have the registers
  void checkSettings() const;
  void connect(const client::RobotDescription& robot);
  void sense(const client::SensorFrame& sensors, double dt);
  void waitForGoals(double t, std::unique_lock<std::mutex>& lock);
  std::uint64_t goalWrites() const;
  void serve();
  void follow(const InstructionPacket& packet, double& ready);
  void send(const Answer& answer, double& ready);
  bool rest(double seconds) const;

  ServoBusSettings settings_;
  std::unique_ptr<Bus> bus_;
  std::vector<Actuator> actuators_;
  std::vector<Board> boards_;
  double period_ = 0, last_time_ = 0;
  bool stepped_ = false;
  std::uint64_t goals_taken_ = 0;
  std::deque<std::pair<double, double>> vain_;  ///< simulated time and wall-clock length of waits in vain [s]
  client::ControlReport report_;

  mutable std::mutex mutex_;            ///< of the registers and the counts; never held while bytes come or go
  std::atomic<bool> step_asks_{false};  ///< the thread lets a step go first
  std::condition_variable goals_written_;
  ServoBusCounts counts_;
  std::unique_ptr<PseudoTerminal> terminal_;
  FileDescriptor alarm_;  ///< wakes the thread: the first frame has come, or it is to end
  std::atomic<bool> open_{false}, ends_{false};
  std::thread thread_;
};

/// What a scenario asks for when it names the program `servo_bus`. @throws as ServoBus
std::unique_ptr<client::ControlSoftware> makeServoBus(const ServoBusSettings& settings);

}  // namespace murosimf::servo_bus
