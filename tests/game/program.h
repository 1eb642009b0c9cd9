#pragma once

/// @file Running the program as a person does, and reading what it leaves behind.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace murosimf::test {

struct Outcome {
  int exit_code = -1;
  std::string text;  ///< standard output and error
};

/// Runs a command through the shell.
Outcome runCommand(const std::string& command);
/// Runs `murosimf ARGUMENTS` through the shell.
Outcome runProgram(const std::string& arguments);

/// An empty folder of its own for each test.
std::string freshFolder(const std::string& name);

/// Plays the 3 versus 3 game and gives its report.
nlohmann::json playGame(const std::string& folder, const std::string& more_arguments);

}  // namespace murosimf::test
