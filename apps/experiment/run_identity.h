#pragma once

/// @file Names a run by everything that enters it, so that a result found under that name is the run's result.
///
/// What enters: this program's bytes, the scenario's text, the texts and bytes of the files that it names, the
/// overrides in their order, the seed. What does not: paths, times, machines, and the number of threads, which changes
/// no bit.

#include <map>
#include <string>

#include "experiment/run_settings.h"

namespace murosimf {

class RunIdentifier {
 public:
  /// @param program  SHA-256 of the program that plays
  explicit RunIdentifier(std::string program) : program_(std::move(program)) {}

  const std::string& program() const { return program_; }

  /// 64 hexadecimal digits. Each file is read once and taken to stay as it is.
  /// @throws std::runtime_error naming a file that cannot be read
  std::string identify(const RunSettings& run);

 private:
  std::string hashOfCase(const RunSettings& run);
  const std::string& hashOfFile(const std::filesystem::path& file);

  std::string program_;
  std::map<std::string, std::string> files_, cases_;
};

/// SHA-256 of the program that is running.
std::string hashOfThisProgram();

}  // namespace murosimf
