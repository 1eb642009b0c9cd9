#pragma once

/// @file Reading scenarios in tests.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "murosimf/scene/scenario_reader.h"

namespace murosimf::test {

inline const std::filesystem::path kRoot = MUROSIMF_SOURCE_DIR;

/// Two robots a line or two each, without any defaults of their own.
inline const std::string kTwoRobots = R"(
[robots.red.1]
file = "robots/ks21.urdf"
pose = [-1, 0, 0]
[robots.blue.1]
file = "robots/ks21.urdf"
pose = [1, 0, {deg = 180}]
)";

/// Where the texts of the tests would lie: beside the real scenarios, so that robot files are found.
inline const std::filesystem::path kPlace = kRoot / "scenarios" / "test.toml";

inline Scene readGood(const std::string& text, const std::vector<std::string>& overrides = {}) {
  Diagnostics diagnostics;
  std::optional<Scene> scene = readScenarioText(text, kPlace, overrides, diagnostics);
  EXPECT_EQ(diagnostics.text(), "");
  EXPECT_TRUE(scene.has_value());
  return scene.value_or(Scene{});
}

/// What is said of a text that is wrong, "LINE:COLUMN: words" a line; "--set" lines as they are.
inline std::vector<std::string> complaints(const std::string& text, const std::vector<std::string>& overrides = {}) {
  Diagnostics diagnostics;
  EXPECT_FALSE(readScenarioText(text, kPlace, overrides, diagnostics).has_value());
  std::vector<std::string> out;
  for (const Diagnostic& d : diagnostics.all()) {
    const SourceLocation& w = d.where;
    const std::string place = w.line > 0 ? std::to_string(w.line) + ":" + std::to_string(w.column) : w.file;
    out.push_back(place + ": " + d.message);
  }
  return out;
}

inline bool startsWith(const std::string& text, const std::string& start) {
  return text.compare(0, start.size(), start) == 0;
}

}  // namespace murosimf::test
