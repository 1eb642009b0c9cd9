#pragma once

/// @file KS21 robots that walk by the reference gait in a simulation, commanded by the test or by a program in a port.

#include <memory>
#include <string>
#include <vector>

#include "modules/motion_world.h"
#include "murosimf/simulation/simulation.h"

namespace murosimf::team {

struct Member {
  std::string path;
  PlanarPose pose;
  controllers::WalkCommand command;
  double phase = 0;      ///< of the gait at the start
  double amplitude = 1;  ///< of the gait; 0: stands still
};

struct TeamOptions {
  int lanes = 1;
  bool ball = true;
};

/// Robots with motion at 100 Hz in frames of 1 ms, and a ball in front of the origin.
class WalkingTeam {
 public:
  explicit WalkingTeam(std::vector<Member> members, const TeamOptions& options = {}) : members_(std::move(members)) {
    auto world = std::make_shared<World>();
    Participants participants;
    for (const Member& member : members_) {
      const ObjectId robot = addRobot(*world, member.path, motion::ks21(), Colour{});
      world->set(robot, kMass, 3.3);
      const auto joints = world->members(robot, subset::kJoints);
      const std::vector<double> q = motion::gait(member.phase, member.command, member.amplitude);
      for (std::size_t i = 0; i < q.size(); ++i) world->set(joints[i], kInitialPosition, q[i]);
      participants.robots.push_back(robot);
    }
    if (options.ball) participants.free_bodies.push_back(addBall(*world));
    addSurfaces(*world);
    simulation_ = std::make_unique<Simulation>(world, link(*world, participants, options.lanes), participants);
    for (std::size_t i = 0; i < members_.size(); ++i) {
      simulation_->interventions().placeRobot(0, participants.robots[i], members_[i].pose);
    }
    if (options.ball) simulation_->interventions().placeBody(0, participants.free_bodies[0], {0.4, 0, 0.07});
  }

  Simulation& simulation() { return *simulation_; }
  ObjectId robot(std::size_t i) const { return simulation_->participants().robots[i]; }
  Pose base(std::size_t i) { return simulation_->linked().handle(robot(i), kBasePose).get(); }
  Pose ball() { return simulation_->linked().handle(simulation_->participants().free_bodies[0], kBasePose).get(); }
  /// One frame; joints are commanded at the beginning of each step of the motion.
  void frame() {
    if (simulation_->frame() % 10 == 0) {
      for (std::size_t i = 0; i < members_.size(); ++i) command(i);
    }
    simulation_->step();
  }
  void frames(int count) {
    for (int i = 0; i < count; ++i) frame();
  }

 private:
  static ObjectId addBall(World& world) {
    const ObjectId ball = world.addPath("ball");
    world.set(ball, kMass, 0.205);
    world.set(ball, kInertiaFactor, 2.0 / 3.0);
    world.set(ball, kBallRadius, 0.07);
    world.set(ball, kShapes, {{0, Pose{}, makeSphere(0.07), {}, "ball", true, true}});
    return ball;
  }
  static void addSurfaces(World& world) {
    SurfaceTable table;
    SurfacePair pair;
    pair.stiffness = 3e3, pair.restitution_factor = 0.5, pair.viscous_friction = 3;
    for (const char* other : {"turf", "plastic", "sole"}) table.set("ball", other, pair);
    world.set(world.root(), kSurfaceTable, table);
  }
  static std::unique_ptr<LinkedWorld> link(const World& world, const Participants& participants, int lanes) {
    const ModuleRegistry modules = allModules();
    Linker linker(world, modules, {0.001, lanes});
    for (const ObjectId robot : participants.robots) {
      for (const char* name : {"ideal_servo", "kinematic_walking", "body_poses", "inertial_sensor", "primitives"}) {
        linker.assign({robot, name, {{"period", {{{0.01}, ""}, {}}}}, {}});
      }
    }
    attachFrame(linker, participants);
    Diagnostics diagnostics;
    auto linked = linker.link(diagnostics);
    if (linked == nullptr) throw std::runtime_error(diagnostics.text());
    return linked;
  }
  void command(std::size_t i) {
    const double t = static_cast<double>(simulation_->frame() + 10) * 0.001;
    const std::vector<double> q =
        motion::gait(members_[i].phase + t / 0.52, members_[i].command, members_[i].amplitude);
    Handle<ServoCommand> commands = simulation_->linked().handle(robot(i), kJointCommand, subset::kJoints);
    for (std::size_t j = 0; j < q.size(); ++j) commands.set({q[j], 0, 0, 1, 0}, static_cast<int>(j));
  }

  std::vector<Member> members_;
  std::unique_ptr<Simulation> simulation_;
};

}  // namespace murosimf::team
