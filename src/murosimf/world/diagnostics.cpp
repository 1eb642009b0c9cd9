#include "murosimf/world/diagnostics.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

namespace murosimf {

void Diagnostics::error(SourceLocation where, std::string message) {
  all_.push_back({Diagnostic::Severity::kError, std::move(where), std::move(message)});
  ++error_count_;
}

void Diagnostics::warning(SourceLocation where, std::string message) {
  all_.push_back({Diagnostic::Severity::kWarning, std::move(where), std::move(message)});
}

std::string Diagnostics::text() const {
  std::vector<Diagnostic> sorted = all_;
  std::stable_sort(sorted.begin(), sorted.end(), [](const Diagnostic& a, const Diagnostic& b) {
    return std::tie(a.where.file, a.where.line, a.where.column) < std::tie(b.where.file, b.where.line, b.where.column);
  });
  std::string out, last;
  for (const Diagnostic& d : sorted) {
    std::string line = d.where.file;
    if (d.where.line > 0) line += ":" + std::to_string(d.where.line);
    if (d.where.column > 0) line += ":" + std::to_string(d.where.column);
    if (!d.where.file.empty()) line += ": ";
    line += d.severity == Diagnostic::Severity::kError ? "error: " : "warning: ";
    line += d.message + "\n";
    if (line != last) out += line;
    last = line;
  }
  return out;
}

namespace {

/// Least number of insertions, deletions and replacements that turn a into b [Levenshtein 1966].
std::size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = std::exchange(row[j], std::min({row[j] + 1, row[j - 1] + 1, replaced}));
    }
  }
  return row[b.size()];
}

}  // namespace

std::string didYouMean(std::string_view word, const std::vector<std::string>& candidates) {
  const std::string* best = nullptr;
  std::size_t least = std::max<std::size_t>(2, word.size() / 3) + 1;
  for (const std::string& candidate : candidates) {
    const std::size_t distance = editDistance(word, candidate);
    if (distance < least) least = distance, best = &candidate;
  }
  return best == nullptr ? "" : " (did you mean \"" + *best + "\"?)";
}

}  // namespace murosimf
