#include "murosimf/frozen_robots.h"

#include <fmt/format.h>
#include <fmt/os.h>
#include <fmt/ranges.h>

namespace murosimf {

namespace {

std::string fileName(const StateGuard::Fault& fault, const World& world) {
  return fmt::format("frozen_{}_{:.3f}s.csv", world.path(fault.robot), fault.time);
}

/// The joint's name, without its robot's.
std::string_view nameOf(const World& world, ObjectId robot, ObjectId joint) {
  return std::string_view(world.path(joint)).substr(world.path(robot).size() + 1);
}

std::string headings(const World& world, ObjectId robot) {
  std::string line = "time,x,y,z,roll,pitch,yaw,rate_x,rate_y,rate_z,velocity_x,velocity_y,velocity_z";
  for (const char* what : {"position", "velocity", "command"}) {
    for (const ObjectId joint : world.members(robot, subset::kJoints)) {
      line += fmt::format(",{}.{}", nameOf(world, robot, joint), what);
    }
  }
  return line + "\n";
}

std::string lineOf(const RecordedStep& step) {
  const Vector3 p = step.X_WB.translation, angles = toRollPitchYaw(step.X_WB.rotation), w = step.V_WB.w,
                v = step.V_WB.v;
  return fmt::format("{:.6f},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", step.time, p.x, p.y, p.z, angles.x,
                     angles.y, angles.z, w.x, w.y, w.z, v.x, v.y, v.z, fmt::join(step.q, ","), fmt::join(step.dq, ","),
                     fmt::join(step.command, ","));
}

void writeSteps(const StateGuard::Fault& fault, const World& world, const std::filesystem::path& file) {
  fmt::ostream out = fmt::output_file(file.string());
  out.print("{}", headings(world, fault.robot));
  for (const RecordedStep& step : fault.steps) out.print("{}", lineOf(step));
}

}  // namespace

std::string writeFrozenRobots(const Simulation& simulation, const std::filesystem::path& directory) {
  std::string text;
  for (const StateGuard::Fault& fault : simulation.guard().faults()) {
    const std::filesystem::path file = directory / fileName(fault, simulation.world());
    text +=
        fmt::format("warning: {}: frozen at {:.3f} s: {}. A step too long for its integrator? (docs/integrators.md)",
                    simulation.world().path(fault.robot), fault.time, fault.what);
    if (!fault.steps.empty()) {
      writeSteps(fault, simulation.world(), file);
      text += fmt::format(" Its last {} steps: {}", fault.steps.size(), file.string());
    }
    text += "\n";
  }
  return text;
}

void addFrozenRobots(nlohmann::ordered_json& report, const Simulation& simulation) {
  for (const StateGuard::Fault& fault : simulation.guard().faults()) {
    report["frozen_robots"].push_back({{"robot", simulation.world().path(fault.robot)},
                                       {"time", fault.time},
                                       {"what", fault.what},
                                       {"steps", fileName(fault, simulation.world())}});
  }
}

}  // namespace murosimf
