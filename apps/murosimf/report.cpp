#include "murosimf/report.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <thread>

#include "game/picture_drawers.h"

namespace murosimf {

std::string hexadecimal(std::uint64_t hash) { return fmt::format("{:016x}", hash); }

namespace {

nlohmann::ordered_json stageSeconds(const Simulation& simulation) {
  nlohmann::ordered_json stages;
  for (int i = 0; i < static_cast<int>(Stage::kCount); ++i) {
    const auto stage = static_cast<Stage>(i);
    stages[std::string(nameOf(stage))] = simulation.stages().seconds(stage);
  }
  return stages;
}

nlohmann::ordered_json controlFigures(const ControlCounts& counts) {
  return {{"pictures", counts.pictures},
          {"picture_seconds_all_threads", counts.picture_seconds},
          {"steps", counts.steps},
          {"program_seconds_all_threads", counts.program_seconds},
          {"refused_joint_commands", counts.refused_joints},
          {"late_commands", counts.late_commands},
          {"missed_sensor_frames", counts.missed_frames},
          {"failed_programs", counts.failed_programs}};
}

/// What programs have counted; none where no program counts anything.
nlohmann::ordered_json programFigures(const Simulation& simulation) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (int i = 0; i < simulation.control()->robotCount(); ++i) {
    const client::ControlSoftware* program = simulation.control()->program(i);
    if (program == nullptr || program->figures().empty()) continue;
    nlohmann::ordered_json& entry = list.emplace_back();
    entry["robot"] = simulation.world().path(simulation.control()->robot(i).port.robot());
    for (const auto& [name, value] : program->figures()) entry[name] = value;
  }
  return list;
}

nlohmann::ordered_json drawerList(const Simulation& simulation) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const DrawnCameras& drawn : drawnCameras(simulation)) {
    nlohmann::ordered_json& entry = list.emplace_back();
    entry["module"] = drawn.module;
    entry["cameras"] = drawn.cameras;
    if (!drawn.drawer.name.empty()) entry["by"] = drawn.drawer.name;
    if (!drawn.drawer.warning.empty()) entry["warning"] = drawn.drawer.warning;
  }
  return list;
}

nlohmann::ordered_json faultList(const Simulation& simulation) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const ProgramFault& fault : simulation.control()->faults()) {
    list.push_back({{"robot", simulation.world().path(fault.robot)}, {"time", fault.time}, {"what", fault.what}});
  }
  return list;
}

}  // namespace

nlohmann::ordered_json basicReport(const Scene& scene, const Simulation& simulation, const HashLog& hashes,
                                   double simulated_seconds, double wall_seconds) {
  nlohmann::ordered_json report;
  report["scenario"] = scene.file.string();
  report["seed"] = *scene.simulation.seed;
  report["simulated_seconds"] = simulated_seconds;
  report["wall_seconds"] = wall_seconds;
  report["real_time_factor"] = wall_seconds > 0 ? simulated_seconds / wall_seconds : 0;
  const int threads = *scene.simulation.threads;
  report["threads"] = threads > 0 ? threads : static_cast<int>(std::thread::hardware_concurrency());
  report["state_hash"] = hexadecimal(simulation.stateHash());
  for (const std::uint64_t hash : hashes.hashes()) report["state_hashes"].push_back(hexadecimal(hash));
  report["stages"] = stageSeconds(simulation);
  if (simulation.control() != nullptr) {
    report["control"] = controlFigures(simulation.control()->counts());
    report["control"]["pictures_by"] = drawerList(simulation);
    report["control"]["faults"] = faultList(simulation);
    report["control"]["programs"] = programFigures(simulation);
  }
  return report;
}

void writeReport(const nlohmann::ordered_json& report, const std::string& file) {
  const std::string temporary = file + ".part";
  std::ofstream out(temporary);
  out << report.dump(2) << "\n";
  out.close();
  if (!out) throw std::runtime_error(fmt::format("cannot write {}", temporary));
  std::filesystem::rename(temporary, file);
}

}  // namespace murosimf
