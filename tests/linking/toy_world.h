#pragma once

/// @file A world of pendulums, and modules that only declare: what the tests of linking need.

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "murosimf/linking/linker.h"
#include "murosimf/linking/outside_access.h"
#include "murosimf/linking/robot_module.h"

namespace murosimf::toy {

inline constexpr Constant<double> kLength{"length", "m", "l > 0, from the joint to the bob"};
inline constexpr Constant<double> kDamping{"damping", "1/s", "rate lost per rate"};
inline constexpr Constant<std::string> kKind{"kind", "", "sort of pendulum"};
inline constexpr Variable<double> kTorque{"torque", "1/s^2", "angular acceleration from outside"};
inline constexpr Variable<double> kAngle{"angle", "rad", "from hanging down"};
inline constexpr Variable<double> kRate{"rate", "rad/s", "of the angle"};
inline constexpr Variable<double> kEnergy{"energy", "J/kg", "kinetic and potential", Storage::kKept};
inline constexpr Variable<double> kTally{"tally", "1", "steps made"};
inline constexpr Variable<double> kOtherTally{"other_tally", "1", "steps made by another"};
inline constexpr Variable<double> kScratch{"scratch", "1", "lives within a step", Storage::kStep};
inline constexpr std::string_view kArms = "arms";

inline ::testing::AssertionResult contains(const std::string& text, const std::string& part) {
  if (text.find(part) != std::string::npos) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << "\"" << part << "\" is not in:\n" << text;
}

/// A row of pendulums: a'' = -g/l sin a - c a' + torque, semi-implicit Euler.
class Pendulums final : public RobotModule {
 public:
  void declare(Declaration& d) const override {
    d.needs(kLength, kArms);
    d.uses(kDamping, 0.5, kArms);
    d.uses(kKind, std::string("plain"));
    d.reads(kTorque);
    d.adds(kAngle, kArms);
    d.adds(kRate, kArms);
  }

 private:
  void bind(Links& links) override {
    length_ = links.values(kLength, kArms);
    damping_ = links.values(kDamping, kArms);
    torque_ = links.values(kTorque);
    angle_ = links.values(kAngle, kArms);
    rate_ = links.values(kRate, kArms);
    factor_ = links.shared(kKind) == "heavy" ? 2.0 : 1.0;
  }
  void initialiseRobot(const RobotLane& robot) const override {
    for (int i = 0; i < angle_.objects; ++i) robot.set(angle_, 0.1 * (i + 1), i);
  }
  void stepRobot(const RobotLane& robot, const StepTime& time) const override {
    for (int i = 0; i < angle_.objects; ++i) {
      const double pull = factor_ * 9.81 / robot.get(length_, i) * sin(robot.get(angle_, i));
      const double damped = robot.get(damping_, i) * robot.get(rate_, i);
      robot.set(rate_, robot.get(rate_, i) + time.dt * (robot.get(torque_) - pull - damped), i);
      robot.set(angle_, robot.get(angle_, i) + time.dt * robot.get(rate_, i), i);
    }
  }
  RobotValues<const double> length_, damping_;
  RobotValues<double> torque_, angle_, rate_;
  double factor_ = 1;
};

/// Computes what nobody needs unless somebody reads it.
class EnergyWatch final : public RobotModule {
 public:
  void declare(Declaration& d) const override {
    d.runsIn(Phase::kSense);
    d.reads(kRate, kArms);
    d.adds(kEnergy);
  }

 private:
  void bind(Links& links) override {
    rate_ = links.values(kRate, kArms);
    energy_ = links.values(kEnergy);
  }
  void stepRobot(const RobotLane& robot, const StepTime&) const override {
    double sum = 0;
    for (int i = 0; i < rate_.objects; ++i) sum += 0.5 * robot.get(rate_, i) * robot.get(rate_, i);
    robot.set(energy_, sum);
  }
  RobotValues<double> rate_, energy_;
};

/// A module that says something and does nothing.
template <void (*kWords)(Declaration&)>
class Says final : public RobotModule {
 public:
  void declare(Declaration& d) const override { kWords(d); }

 private:
  void bind(Links&) override {}
  void stepRobot(const RobotLane&, const StepTime&) const override {}
};

inline const OutsideAccess kDriver([](Declaration& d) { d.adds(kTorque); });
inline const OutsideAccess kEnergyReader([](Declaration& d) { d.reads(kEnergy); });

inline ModuleRegistry registry() {
  ModuleRegistry all;
  all.add<Pendulums>("pendulums", "motion", "a row of pendulums");
  all.add<EnergyWatch>("energy_watch", "sensing", "kinetic energy");
  return all;
}

/// A world of robots "a", "b", ... of two arms each, linked by a list of assignments.
struct ToyWorld {
  World world;
  ModuleRegistry modules = registry();
  Diagnostics diagnostics;
  std::vector<Assignment> assignments;
  std::vector<Attachment> attachments;
  LinkOptions options{0.001, 1};

  ObjectId addRobot(const std::string& name, double length = 0.3, int arms = 2) {
    const ObjectId robot = world.addPath(name);
    std::vector<ObjectId> members;
    for (int i = 0; i < arms; ++i) {
      members.push_back(world.add(robot, "arm" + std::to_string(i + 1)));
      world.set(members.back(), kLength, length * (i + 1));
    }
    world.defineSubset(robot, kArms, std::move(members));
    return robot;
  }
  /// A robot with its pendulums and somebody who drives them.
  ObjectId addPendulums(const std::string& name, double length = 0.3, int arms = 2) {
    const ObjectId robot = addRobot(name, length, arms);
    assign(robot, "pendulums");
    attachments.push_back({"driver", &kDriver, {robot}});
    return robot;
  }
  Assignment& assign(ObjectId robot, std::string module, int line = 7) {
    return assignments.emplace_back(Assignment{robot, std::move(module), {}, {"game.toml", line, 3}});
  }
  std::unique_ptr<LinkedWorld> link() {
    Linker linker(world, modules, options);
    for (const Assignment& assignment : assignments) linker.assign(assignment);
    for (const Attachment& attachment : attachments) linker.attach(attachment);
    return linker.link(diagnostics);
  }
  /// The errors of linking; fails where there is none.
  std::string errors() { return link() == nullptr ? diagnostics.text() : "linked without an error"; }
};

}  // namespace murosimf::toy
