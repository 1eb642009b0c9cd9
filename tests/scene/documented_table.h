#pragma once

/// @file Tables of the documentation that are printed from the code.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "scene/scenario_for_test.h"

namespace murosimf::test {

/// Expects a file of docs/ to hold this between the marks "<!-- NAME: begin -->" and "<!-- NAME: end -->". With
/// MUROSIMF_UPDATE_DOCS set, writes it there.
inline void expectDocumented(const std::string& name, const std::string& table,
                             const std::string& document = "scenario_format.md") {
  const std::filesystem::path file = kRoot / "docs" / document;
  std::ostringstream stream;
  stream << std::ifstream(file).rdbuf();
  std::string text = stream.str();
  const std::string begin = "<!-- " + name + ": begin -->\n", end = "<!-- " + name + ": end -->";
  const std::size_t first = text.find(begin), last = text.find(end);
  ASSERT_NE(first, text.npos);
  ASSERT_NE(last, text.npos);
  const std::size_t start = first + begin.size();
  if (std::getenv("MUROSIMF_UPDATE_DOCS") != nullptr) {
    text.replace(start, last - start, table);
    std::ofstream(file) << text;
    return;
  }
  EXPECT_EQ(text.substr(start, last - start), table)
      << "run this test with MUROSIMF_UPDATE_DOCS=1 and it writes the table anew";
}

}  // namespace murosimf::test
