#include "murosimf/control/wire/s_expression.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace murosimf {

namespace {

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f' || c == '\v' || c == '\0'; }

/// Reads lists within lists without calling itself: what a client nests costs no stack.
class Reader {
 public:
  Reader(std::string_view text, const SExpressionLimits& limits) : text_(text), limits_(limits) {
    open_.push_back(&all_);
  }

  bool read() {
    while (problem_.empty() && skipBlanks()) readOne();
    if (problem_.empty() && open_.size() > 1) fail("the end of a list is missing");
    return problem_.empty();
  }
  std::vector<SExpression>& all() { return all_.items; }
  const std::string& problem() const { return problem_; }

 private:
  void fail(std::string_view what) { problem_ = fmt::format("byte {}: {}", position_, what); }

  bool skipBlanks() {
    while (position_ < text_.size() && isBlank(text_[position_])) ++position_;
    return position_ < text_.size();
  }

  void readOne() {
    const char c = text_[position_];
    if (c == ')') return close();
    if (++count_ > limits_.count) return fail(fmt::format("more than {} words and lists", limits_.count));
    if (c == '(') return open();
    const std::size_t first = position_;
    while (position_ < text_.size() && !isBlank(text_[position_]) && text_[position_] != '(' && text_[position_] != ')')
      ++position_;
    open_.back()->items.push_back({text_.substr(first, position_ - first), {}});
  }

  // A list's own place does not move while it is open: its elder brothers are complete.
  void open() {
    if (static_cast<int>(open_.size()) > limits_.depth) return fail(fmt::format("lists deeper than {}", limits_.depth));
    open_.back()->items.emplace_back();
    open_.push_back(&open_.back()->items.back());
    ++position_;
  }

  void close() {
    if (open_.size() == 1) return fail("a ) too many");
    open_.pop_back();
    ++position_;
  }

  std::string_view text_;
  const SExpressionLimits& limits_;
  std::size_t position_ = 0, count_ = 0;
  SExpression all_;
  std::vector<SExpression*> open_;
  std::string problem_;
};

}  // namespace

std::string_view SExpression::name() const { return text(0); }

std::string_view SExpression::text(std::size_t place) const {
  return place < items.size() && !items[place].isList() ? items[place].word : std::string_view{};
}

const SExpression* SExpression::find(std::string_view list) const {
  for (const SExpression& item : items) {
    if (item.isList() && item.name() == list) return &item;
  }
  return nullptr;
}

std::optional<double> SExpression::number(std::size_t place) const {
  std::string_view digits = text(place);
  if (digits.starts_with('+')) digits.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  const bool whole = error == std::errc{} && end == digits.data() + digits.size() && !digits.empty();
  return whole && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::optional<std::vector<SExpression>> readSExpressions(std::string_view text, std::string& problem,
                                                         const SExpressionLimits& limits) {
  Reader reader(text, limits);
  if (reader.read()) return std::move(reader.all());
  problem = reader.problem();
  return std::nullopt;
}

}  // namespace murosimf
