// S-expressions of clients: what is read, and what is refused.

#include "murosimf/control/wire/s_expression.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace murosimf::testing {
namespace {

/// Written again, with one blank between items.
std::string written(const SExpression& e) {
  if (!e.isList()) return std::string(e.word);
  std::string text = "(";
  for (const SExpression& item : e.items) text += (text.size() > 1 ? " " : "") + written(item);
  return text + ")";
}

std::string read(const std::string& text, const SExpressionLimits& limits = {}) {
  std::string problem;
  const auto all = readSExpressions(text, problem, limits);
  if (!all) return problem;
  std::string out;
  for (const SExpression& e : *all) out += written(e);
  return out;
}

TEST(SExpression, ListsAndWordsStandInAnyBlanks) {
  EXPECT_EQ(read("(he1 3.2)(lle4 -1.5)"), "(he1 3.2)(lle4 -1.5)");
  EXPECT_EQ(read(" ( init(unum 1)\n(teamname\tFHO) ) "), "(init (unum 1) (teamname FHO))");
  EXPECT_EQ(read("()"), "()");
  EXPECT_EQ(read(""), "");
  EXPECT_EQ(read("syn"), "syn");
}

TEST(SExpression, ListsAreFoundByName) {
  std::string problem;
  const std::string text = "(agent (unum 7)(team Left)(move 1 -2.5 +3e-1 x))";
  const auto all = readSExpressions(text, problem);
  ASSERT_TRUE(all);
  const SExpression& agent = all->front();
  EXPECT_EQ(agent.name(), "agent");
  EXPECT_EQ(agent.find("unum")->number(1), 7);
  EXPECT_EQ(agent.find("team")->text(1), "Left");
  EXPECT_EQ(agent.find("move")->number(2), -2.5);
  EXPECT_EQ(agent.find("move")->number(3), 0.3);
  EXPECT_EQ(agent.find("move")->number(4), std::nullopt);
  EXPECT_EQ(agent.find("move")->number(9), std::nullopt);
  EXPECT_EQ(agent.find("beam"), nullptr);
}

TEST(SExpression, NumbersThatAreNotFiniteAreNone) {
  std::string problem;
  const std::string text = "(x nan inf -inf 1e999 1.5.5 0x10)";
  const auto all = readSExpressions(text, problem);
  ASSERT_TRUE(all);
  for (std::size_t i = 1; i < all->front().items.size(); ++i) EXPECT_EQ(all->front().number(i), std::nullopt) << i;
}

TEST(SExpression, WhatIsWrongIsToldWithItsPlace) {
  EXPECT_EQ(read("(he1 3"), "byte 6: the end of a list is missing");
  EXPECT_EQ(read("(he1 3))"), "byte 7: a ) too many");
  EXPECT_EQ(read("((((((", {4, 100}), "byte 4: lists deeper than 4");
  EXPECT_EQ(read("a b c d", {4, 3}), "byte 6: more than 3 words and lists");
}

TEST(SExpression, AMillionParenthesesCostNoStack) {
  EXPECT_EQ(read(std::string(1 << 20, '(')), "byte 16: lists deeper than 16");
}

TEST(SExpression, WhatIsWrittenIsReadAgain) {
  EXPECT_TRUE(rc::check("reading is the inverse of writing", [](const std::vector<std::vector<int>>& lists) {
    std::string text;
    for (const std::vector<int>& list : lists) {
      text += "(x";
      for (const int i : list) text += " (y " + std::to_string(i) + ")";
      text += ")";
    }
    RC_ASSERT(read(text, {16, 1000000}) == text);
  }));
}

}  // namespace
}  // namespace murosimf::testing
