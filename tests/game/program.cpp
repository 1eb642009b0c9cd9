#include "game/program.h"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>

namespace murosimf::test {

Outcome runCommand(const std::string& command) {
  Outcome outcome;
  std::FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  if (pipe == nullptr) return outcome;
  std::array<char, 4096> buffer{};
  while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe)) {
    outcome.text.append(buffer.data(), count);
  }
  const int status = pclose(pipe);
  outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return outcome;
}

Outcome runProgram(const std::string& arguments) { return runCommand(std::string(MUROSIMF_PROGRAM) + " " + arguments); }

std::string freshFolder(const std::string& name) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / ("murosimf_" + name);
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder.string();
}

nlohmann::json playGame(const std::string& folder, const std::string& more_arguments) {
  const Outcome outcome = runProgram("run scenarios/game_3v3.toml --out " + folder + " " + more_arguments);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.text;
  std::ifstream file(folder + "/report.json");
  return nlohmann::json::parse(file, nullptr, false);
}

}  // namespace murosimf::test
