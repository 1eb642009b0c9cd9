#pragma once

/// @file Reads the values of one table of a scenario, each checked against the table of keys (scenario_keys.h).

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/scene/located.h"
#include "murosimf/scene/scenario_keys.h"
#include "murosimf/scene/scene.h"
#include "murosimf/scene/text_tree.h"

namespace murosimf {

/// A key that is absent leaves its target as it is; one that is wrong is reported and leaves it too.
class TableReader {
 public:
  /// @param name of the table in messages; default: its key
  /// @param section as in scenario_keys.h. A table of nullptr reads as empty; a node that is no table is reported.
  TableReader(const TextNode* table, std::string_view section, Diagnostics& diagnostics, std::string_view name = "");

  /// @return true when the key was there and right
  bool read(std::string_view key, Located<double>& target) const;
  bool read(std::string_view key, Located<int>& target) const;
  bool read(std::string_view key, Located<std::uint64_t>& target) const;
  bool read(std::string_view key, Located<bool>& target) const;
  bool read(std::string_view key, Located<std::string>& target) const;  ///< kText and kWord
  bool read(std::string_view key, Located<Colour>& target) const;
  bool read(std::string_view key, Located<PlanarPose>& target) const;
  bool read(std::string_view key, Located<Vec3<double>>& target) const;  ///< [x, y] or [x, y, z]

  bool read(std::string_view key, Located<std::vector<std::string>>& target) const;  ///< kNames
  /// Both of kTwoNames.
  bool read(std::string_view key, Located<std::vector<std::string>>& first,
            Located<std::vector<std::string>>& second) const;

  /// Reports keys that the section does not have; `more` are allowed too.
  void refuseUnknownKeys(const std::vector<std::string>& more = {}) const;
  /// The child at the key, nullptr when absent.
  const TextNode* child(std::string_view key) const { return table_ == nullptr ? nullptr : table_->find(key); }

 private:
  bool fail(const TextNode& node, const ScenarioKey& key) const;

  const TextNode* table_;
  std::string_view section_;
  std::string name_;
  Diagnostics& diagnostics_;
};

/// A finite number; with `angle`, `{deg = 30}` too. Reports what is wrong and returns nothing.
std::optional<double> readNumber(const TextNode& node, std::string_view name, const std::string& expected, bool angle,
                                 Diagnostics& diagnostics);
/// A text. Of `--set` also a number or a word without quotes.
std::optional<std::string> readText(const TextNode& node);
/// Whatever a property or a module's parameter may be.
std::optional<Located<SceneValue>> readSceneValue(const TextNode& node, std::string_view name,
                                                  Diagnostics& diagnostics);
/// True for a table whose only key is like `deg`: an angle, not a table of keys.
bool looksLikeAngle(const TextNode& node);

}  // namespace murosimf
