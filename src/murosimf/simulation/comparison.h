#pragma once

/// @file Where two runs part: the first frame, object and property whose bits differ.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace murosimf {

/// One number of one object, that is not the same in two runs.
struct StateDifference {
  long frame = 0;
  double time = 0;  ///< at the end of that frame [s]
  std::string object, assembly, property, unit;
  std::uint32_t component = 0, components = 1;  ///< which number of the property, from 0, of how many
  double a = 0, b = 0;
  std::size_t others = 0;  ///< further numbers that differ after the same frame
};

struct Comparison {
  bool equal = true;                     ///< everything that both runs have is the same, and both have the same
  std::string compared;                  ///< how much: "1200 frames", up to and including the first difference
  std::optional<StateDifference> first;  ///< of state
  std::vector<std::string> notes;        ///< other differences: length, columns, interventions, scenario, hashes
  /// A few lines for people; names as given.
  std::string text(const std::string& name_a, const std::string& name_b) const;
};

/// Compares two recordings, over the frames that both have. @throws std::runtime_error as RecordingReader does.
Comparison compareRecordings(const std::filesystem::path& a, const std::filesystem::path& b);

/// Compares the hashes of two reports: "state_hashes", one a second of simulated time, and "state_hash".
/// @throws std::runtime_error naming the file and what it lacks.
Comparison compareReports(const std::filesystem::path& a, const std::filesystem::path& b);

/// Either, by what the files are; of a folder, its report.json. @throws std::runtime_error when they are not alike.
Comparison compareRuns(const std::filesystem::path& a, const std::filesystem::path& b);

}  // namespace murosimf
