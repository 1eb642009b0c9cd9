#include "experiment/run_identity.h"

#include <fmt/format.h>

#include "experiment/content_hash.h"
#include "experiment/input_files.h"

namespace murosimf {

std::vector<std::string> allOverrides(const RunSettings& run) {
  std::vector<std::string> all = run.overrides;
  all.push_back(fmt::format("simulation.seed={}", run.seed));
  return all;
}

std::string RunIdentifier::identify(const RunSettings& run) {
  ContentHash hash;
  hash.add("murosimf run 1");
  hash.add(program_);
  hash.add(hashOfCase(run));
  hash.add(std::to_string(run.seed));
  return hash.text();
}

/// Cases differ by their overrides; their many seeds share what is found here.
std::string RunIdentifier::hashOfCase(const RunSettings& run) {
  ContentHash key;
  key.add(run.scenario.string());
  for (const std::string& assignment : run.overrides) key.add(assignment);
  const std::string name = key.text();
  if (const auto known = cases_.find(name); known != cases_.end()) return known->second;
  ContentHash hash;
  hash.add(hashOfFile(run.scenario));
  for (const std::string& assignment : run.overrides) hash.add(assignment);
  for (const InputFile& input : inputFiles(run.scenario, run.overrides)) {
    hash.add(input.name);
    hash.add(hashOfFile(input.file));
  }
  return cases_.emplace(name, hash.text()).first->second;
}

const std::string& RunIdentifier::hashOfFile(const std::filesystem::path& file) {
  if (const auto known = files_.find(file.string()); known != files_.end()) return known->second;
  return files_.emplace(file.string(), sha256OfFile(file)).first->second;
}

std::string hashOfThisProgram() { return sha256OfFile("/proc/self/exe"); }

}  // namespace murosimf
