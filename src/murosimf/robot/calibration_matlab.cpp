#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "murosimf/robot/calibration_parts.h"
#include "murosimf/robot/checks.h"
#include "murosimf/robot/xml_element.h"

namespace murosimf::calibration {
namespace {

/// One `name = value;` of a Matlab script; comments are gone, brackets, commas, semicolons and new lines are blanks.
struct Statement {
  std::string name, value;
  int line = 0;  ///< of the name
};

bool isLetter(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// Statements end at a semicolon or a new line outside of brackets. What is no assignment to a plain name is left out.
class Statements {
 public:
  explicit Statements(const std::string& text) : text_(text) {}

  std::optional<Statement> next() {
    while (at_ < text_.size()) {
      const Statement statement = one();
      const bool named = !statement.name.empty() && std::all_of(statement.name.begin(), statement.name.end(), isLetter);
      if (named) return statement;
    }
    return std::nullopt;
  }

 private:
  Statement one() {
    Statement out;
    int depth = 0;
    bool assigned = false;
    for (; at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      const bool continues = text_.compare(at_, 3, "...") == 0;  // in the next line
      if (c == '%' || continues) {
        at_ = std::min(text_.find('\n', at_), text_.size()) - (continues ? 0 : 1);
        if (continues) ++line_;
        continue;
      }
      if (c == '[' || c == '(') ++depth;
      if (c == ']' || c == ')') --depth;
      const bool ends = depth <= 0 && (c == ';' || c == '\n');
      if (c == '\n') ++line_;
      if (ends) break;
      add(out, c, assigned);
    }
    ++at_;
    if (!assigned) out.name.clear();
    return out;
  }

  void add(Statement& out, char c, bool& assigned) const {
    const bool blank = std::isspace(static_cast<unsigned char>(c)) != 0;
    if (!assigned && c == '=') {
      assigned = true;
    } else if (!assigned && !blank) {
      if (out.name.empty()) out.line = line_;
      out.name += c;
    } else if (assigned) {
      out.value += blank || c == '[' || c == ']' || c == ',' || c == ';' ? ' ' : c;
    }
  }

  const std::string& text_;
  std::size_t at_ = 0;
  int line_ = 1;
};

class Reader {
 public:
  Reader(const std::string& file, Diagnostics& diagnostics) : file_(file), diagnostics_(diagnostics) {}

  Parts read(const std::string& text) {
    Parts parts;
    Statements statements(text);
    while (const std::optional<Statement> statement = statements.next()) {
      names_.push_back(statement->name);
      if (statement->name == "fc") parts.focal = numbers(*statement, 2);
      if (statement->name == "cc") parts.centre = numbers(*statement, 2);
      if (statement->name == "alpha_c") parts.skew = numbers(*statement, 1);
      if (statement->name == "kc") parts.distortion = numbers(*statement, 5);
      if (statement->name == "nx") parts.width = numbers(*statement, 1);
      if (statement->name == "ny") parts.height = numbers(*statement, 1);
    }
    for (const char* name : {"fc", "cc", "kc"}) {
      if (std::find(names_.begin(), names_.end(), name) == names_.end())
        diagnostics_.error({file_, 0, 0},
                           fmt::format("{0} is missing, expected {0} = [ ... ];{1}", name, didYouMean(name, names_)));
    }
    return parts;
  }

 private:
  std::optional<Numbers> numbers(const Statement& statement, std::size_t count) {
    Numbers out{statement.name, {}, {file_, statement.line, 0}};
    const std::vector<std::string> words = splitWords(statement.value);
    for (const std::string& word : words) {
      if (const std::optional<double> x = parseNumber(word)) out.values.push_back(*x);
    }
    if (out.values.size() == words.size() && out.values.size() == count) return out;
    diagnostics_.error(out.where,
                       fmt::format("{} is {}, expected {} number{}", statement.name,
                                   quoted(fmt::format("{}", fmt::join(words, " "))), count, count == 1 ? "" : "s"));
    return std::nullopt;
  }

  const std::string& file_;
  Diagnostics& diagnostics_;
  std::vector<std::string> names_;
};

}  // namespace

Parts readMatlab(const std::string& text, const std::string& file, Diagnostics& diagnostics) {
  return Reader(file, diagnostics).read(text);
}

}  // namespace murosimf::calibration
