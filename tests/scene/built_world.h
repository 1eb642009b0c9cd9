#pragma once

/// @file Worlds built from scenario texts in tests.

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "murosimf/modules/all_modules.h"
#include "murosimf/scene/world_builder.h"
#include "murosimf/world/vocabulary.h"
#include "scene/scenario_for_test.h"

namespace murosimf::test {

/// A program that asks for nothing.
class Idle final : public client::ControlSoftware {
 public:
  void start(const client::RobotDescription&) override {}
  void step(const client::SensorFrame&, client::CommandFrame&) override {}
  const client::ControlReport& report() const override { return report_; }
  void archive(StateArchive&) override {}

 private:
  client::ControlReport report_;
};

inline ControlPrograms idlePrograms() {
  return {{"idle", [] { return std::make_unique<Idle>(); }}};
}

/// A scene with what was built from it; the scene must outlive the builder.
struct BuiltWorld {
  explicit BuiltWorld(const std::string& text, const std::vector<std::string>& overrides = {})
      : scene(readGood(text, overrides)), builder(scene, diagnostics) {}

  /// The simulation; expects no complaint.
  std::unique_ptr<Simulation> simulation() {
    std::unique_ptr<Simulation> made = builder.link(allModules(), idlePrograms());
    EXPECT_EQ(diagnostics.text(), "");
    return made;
  }
  /// What is said of a scenario that can be read but not built: "LINE:COLUMN: words", of robot files "NAME:LINE:
  /// words".
  std::vector<std::string> complaints() {
    EXPECT_EQ(builder.link(allModules(), idlePrograms()), nullptr);
    std::vector<Diagnostic> sorted = diagnostics.all();
    std::stable_sort(sorted.begin(), sorted.end(), [](const Diagnostic& a, const Diagnostic& b) {
      return std::tie(a.where.line, a.where.column) < std::tie(b.where.line, b.where.column);
    });
    std::vector<std::string> out;
    for (const auto& [severity, w, message] : sorted) {
      const std::string file = std::filesystem::path(w.file).filename().string();
      out.push_back(w.file.ends_with(".urdf") ? fmt::format("{}:{}: {}", file, w.line, message)
                                              : fmt::format("{}:{}: {}", w.line, w.column, message));
    }
    return out;
  }

  Diagnostics diagnostics;
  Scene scene;
  WorldBuilder builder;
};

}  // namespace murosimf::test
