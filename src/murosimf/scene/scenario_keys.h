#pragma once

/// @file The keys of a scenario file: one table from which the reader takes its checks and
/// docs/scenario_format.md its lines.

#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace murosimf {

inline constexpr double kNoLimit = std::numeric_limits<double>::infinity();

struct ScenarioKey {
  enum class Kind {
    kBool,
    kInteger,
    kNumber,
    kText,
    kWord,
    kPose,
    kPosition,
    kColour,
    kModule,
    kTable,
    kNames,
    kTwoNames
  };

  std::string_view section;  ///< "simulation", "robots.TEAM.NUMBER", ...
  std::string_view key;
  Kind kind;
  std::string_view unit;           ///< of numbers; "1" for plain ones
  double lower = 0, upper = 0;     ///< of numbers, both allowed; kNoLimit: none
  bool above_lower = false;        ///< the lower limit itself is refused
  std::string_view words = {};     ///< of kWord: the allowed ones, with a blank between
  std::string_view fallback = {};  ///< default as TOML; empty: must be given, or see the meaning
  std::string_view meaning = {};
};

/// All keys, section by section.
std::span<const ScenarioKey> scenarioKeys();
/// Keys of one section, in the table's order.
std::vector<std::string> keysOfSection(std::string_view section);
/// nullptr when the section has no such key.
const ScenarioKey* findScenarioKey(std::string_view section, std::string_view key);
/// "more than 0 and at most 10 kg", "\"red\" or \"blue\"", "true or false", ...
std::string expectation(const ScenarioKey& key);
/// Words of a kWord key, one by one.
std::vector<std::string> allowedWords(const ScenarioKey& key);
/// `"a", "b" or "c"`.
std::string listWords(const std::vector<std::string>& words);
/// The tables of docs/scenario_format.md, in Markdown.
std::string scenarioKeysAsMarkdown();

}  // namespace murosimf
