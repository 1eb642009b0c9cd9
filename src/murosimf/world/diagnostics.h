#pragma once

/// @file Errors in what people wrote: where, what was found, what was expected. All of them at once.

#include <string>
#include <string_view>
#include <vector>

namespace murosimf {

/// A place in a text file. Line and column count from 1; 0 when unknown.
struct SourceLocation {
  std::string file;
  int line = 0;
  int column = 0;
};

struct Diagnostic {
  enum class Severity { kError, kWarning };
  Severity severity = Severity::kError;
  SourceLocation where;
  std::string message;  ///< what was found, what was expected
};

/// Collects what is wrong with the files being read, so that one run names every mistake.
class Diagnostics {
 public:
  void error(SourceLocation where, std::string message);
  void warning(SourceLocation where, std::string message);
  bool hasErrors() const { return error_count_ > 0; }
  int errorCount() const { return error_count_; }
  const std::vector<Diagnostic>& all() const { return all_; }
  /// One line each, `file:line:column: error: message`, in the order of the files' lines. What is wrong for
  /// every robot in the same words at the same place is told once.
  std::string text() const;

 private:
  std::vector<Diagnostic> all_;
  int error_count_ = 0;
};

/// ` (did you mean "x"?)` for the candidate nearest to the word by edit distance, or nothing when none is near.
std::string didYouMean(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace murosimf
