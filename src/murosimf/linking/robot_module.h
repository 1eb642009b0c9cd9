#pragma once

/// @file Modules that step one robot at a time: written like a loop over robots, without kernels for lanes.
///
///     class Odometer final : public RobotModule {
///       void declare(Declaration& d) const override { d.reads(kBasePose); d.adds(kWay); }
///       void bind(Links& links) override { pose_ = links.values(kBasePose); way_ = links.values(kWay); }
///       void stepRobot(const RobotLane& robot, const StepTime& time) const override {
///         robot.set(way_, robot.get(way_) + ...);
///       }
///       RobotValues<Pose> pose_;
///       RobotValues<double> way_;
///     };
///
/// They stand beside modules with kernels in the same batch, at any lane width, with the same bits. Cost: that of
/// scalar code with strided access; where a module is worth its own kernels, linking/kernel.h tells how.

#include "murosimf/linking/links.h"

namespace murosimf {

class RobotModule : public BlockModule {
 public:
  void link(Links& links) final {
    width_ = links.width();
    bind(links);
  }
  void initialise(const BlockMemory& block) const final {
    for (int lane = 0; lane < width_; ++lane) initialiseRobot(RobotLane(block, width_, lane));
  }
  void step(const BlockMemory& block, const StepTime& time) const final {
    for (int lane = 0; lane < width_; ++lane) stepRobot(RobotLane(block, width_, lane), time);
  }
  void answer(const BlockMemory& block) const final {
    for (int lane = 0; lane < width_; ++lane) answerRobot(RobotLane(block, width_, lane));
  }

 protected:
  /// Keeps where the values of the declared properties stand: links.values(...).
  virtual void bind(Links& links) = 0;
  /// Gives the variables it adds their first values where zero (or the identity pose) will not do.
  virtual void initialiseRobot(const RobotLane& robot) const { static_cast<void>(robot); }
  /// Makes one step of one robot. Called from any thread, for different robots at once.
  virtual void stepRobot(const RobotLane& robot, const StepTime& time) const = 0;
  /// Computes the variables that it adds on demand.
  virtual void answerRobot(const RobotLane& robot) const { static_cast<void>(robot); }

 private:
  int width_ = 1;
};

}  // namespace murosimf
