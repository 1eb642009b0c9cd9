// Rules about what may touch what: names, order, and what becomes of the table of surfaces.
#include "murosimf/world/contact_rules.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace murosimf {
namespace {

using Pairs = ContactRule::Pairs;

SurfaceTable table() {
  SurfaceTable table;
  SurfacePair pair;
  pair.stiffness = 100;
  table.set("sole", "plastic", pair);
  return table;
}

const ContactBody kFoot{"robots.red.1.foot", "sole"}, kTrunk{"robots.blue.2.trunk", "plastic"};

ContactTerms termsOf(const std::vector<ContactRule>& rules, bool same_robot = false) {
  return contactTerms(table(), rules, kFoot, kTrunk, same_robot);
}

ContactRule rule(Pairs pairs, std::vector<std::string> a, std::vector<std::string> b, bool check) {
  ContactRule made;
  made.pairs = pairs;
  made.a.patterns = std::move(a);
  made.b.patterns = std::move(b);
  made.check = check;
  return made;
}

TEST(ContactRules, ANameMeansTheObjectAndAllBelowIt) {
  EXPECT_TRUE(patternMeans("robots.red.1", "robots.red.1"));
  EXPECT_TRUE(patternMeans("robots.red", "robots.red.1.trunk"));
  EXPECT_TRUE(patternMeans("*", "ball"));
  EXPECT_FALSE(patternMeans("robots.red.1", "robots.red.12")) << "whole names count";
  EXPECT_FALSE(patternMeans("robots.red.1.trunk", "robots.red.1"));
  EXPECT_TRUE(patternMeans("robots.*.1.*_left", "robots.blue.1.foot_left"));
  EXPECT_FALSE(patternMeans("robots.*_left", "robots.blue.1.foot_left")) << "a sign stays within one name";
  EXPECT_TRUE(patternMeans("robots.red.[12]", "robots.red.2.trunk"));
}

TEST(ContactRules, WithoutRulesTheTableHoldsAndARobotDoesNotTouchItself) {
  EXPECT_TRUE(termsOf({}).check);
  EXPECT_EQ(termsOf({}).surface.stiffness, 100);
  EXPECT_FALSE(termsOf({}).one_point);
  EXPECT_FALSE(termsOf({}, true).check);
}

TEST(ContactRules, BetweenTakesTheTwoSidesInEitherOrder) {
  EXPECT_FALSE(termsOf({rule(Pairs::kBetween, {"robots.red"}, {"robots.blue"}, false)}).check);
  EXPECT_FALSE(termsOf({rule(Pairs::kBetween, {"robots.blue"}, {"robots.red"}, false)}).check);
  EXPECT_TRUE(termsOf({rule(Pairs::kBetween, {"robots.red"}, {"ball"}, false)}).check);
}

TEST(ContactRules, WithinTakesPairsOfOneSetAndSelfThoseOfOneRobot) {
  EXPECT_FALSE(termsOf({rule(Pairs::kWithin, {"robots.red", "robots.blue"}, {}, false)}).check);
  EXPECT_TRUE(termsOf({rule(Pairs::kWithin, {"robots.red"}, {}, false)}).check) << "the other one is not in the set";
  EXPECT_FALSE(termsOf({rule(Pairs::kWithin, {"robots"}, {}, true)}, true).check) << "bodies of one robot are no pair";
  EXPECT_TRUE(termsOf({rule(Pairs::kSelf, {"robots"}, {}, true)}, true).check);
  EXPECT_TRUE(termsOf({rule(Pairs::kSelf, {"robots"}, {}, false)}).check);
}

TEST(ContactRules, TheLaterRuleHoldsItemByItem) {
  ContactRule soft = rule(Pairs::kBetween, {"robots.red"}, {"*"}, false);
  soft.surface.stiffness = 5;
  soft.surface.friction = 0.1;
  soft.one_point = true;
  ContactRule later = rule(Pairs::kWithin, {"robots"}, {}, true);
  later.surface.stiffness = 7;
  const ContactTerms terms = termsOf({soft, later});
  EXPECT_TRUE(terms.check);
  EXPECT_TRUE(terms.one_point);
  EXPECT_EQ(terms.surface.stiffness, 7);
  EXPECT_EQ(terms.surface.friction, 0.1);
}

TEST(ContactRules, APairThatNothingDescribesIsAnErrorWhereItMayTouch) {
  const ContactBody wood{"robots.blue.2.hand", "wood"};
  EXPECT_THROW(contactTerms(table(), {}, kFoot, wood, false), std::invalid_argument);
  EXPECT_FALSE(contactTerms(table(), {}, kFoot, wood, true).check);
  const ContactRule off = rule(Pairs::kWithin, {"*"}, {}, false);
  EXPECT_FALSE(contactTerms(table(), {off}, kFoot, wood, false).check);
  ContactRule enough;
  enough.pairs = Pairs::kWithin;
  enough.a.patterns = {"*"};
  enough.surface.stiffness = 10;
  EXPECT_THROW(contactTerms(table(), {enough}, kFoot, wood, false), std::invalid_argument);
  enough.surface.restitution_factor = 0.5;
  EXPECT_EQ(contactTerms(table(), {enough}, kFoot, wood, false).surface.stiffness, 10);
}

}  // namespace
}  // namespace murosimf
