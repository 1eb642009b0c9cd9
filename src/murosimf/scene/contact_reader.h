#pragma once

/// @file Rules of a scenario about what may touch what: [contacts.NAME].

#include <vector>

#include "murosimf/scene/scene.h"
#include "murosimf/scene/text_tree.h"

namespace murosimf {

/// @param table [contacts], nullptr: none; @param in_file the same before `--set` changed it: rules hold in the file's
/// order, new ones of `--set` behind them
std::vector<ContactRuleSettings> readContacts(const TextNode* table, const TextNode* in_file, Diagnostics& diagnostics);

}  // namespace murosimf
